# Four travels of two sunk wheels on one bed, for the tests of engines: LOAD-sSLIP.
CHAPTER := tests/engines
SWEEP   := $(CHAPTER)/chapter.mk
OUT     := build/engines/runs
RUNS    := $(foreach l,100N 50N,$(foreach s,0 40,$(l)-s$(s)))

.PHONY: runs
runs: sweep
include reproductions/chapter3/sweep.mk

part    = $(word $(2),$(subst -, ,$(1)))
load_of = --set wheel.load_N=$(patsubst %N,%,$(call part,$(1),1))
slip_of = --set travel.slip_percent=$(patsubst s%,%,$(call part,$(1),2))

$(eval $(call bed_rule,bed,$(CASES),))
$(foreach s,$(sort $(foreach r,$(RUNS),$(call part,$(r),1))),$(eval $(call sunk_rule,$(s),$(CASES),$(call load_of,$(s)),bed)))
$(foreach r,$(RUNS),$(eval $(call travel_rule,$(r),$(CASES),$(call load_of,$(r)) $(call slip_of,$(r)),$(call part,$(r),1))))

travels: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS)))
