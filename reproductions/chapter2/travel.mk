# Travels on the small bin that compare methods: the two ways to drive a wheel over slip; walls of discs; light rim and lugs.
# A run is METHOD-sSLIP-rREALISATION; realisations are paired between methods. Walls and density are about differences of
# less than one run's scatter, hence twice the realisations.

CHAPTER := reproductions/chapter2
SWEEP   := $(CHAPTER)/travel.mk
OUT     := build/runs/chapter2/travel
SLIPS   := 0 20 40 60
SEEDS   := 1 2 3 4 5 6 7 8 9 10 11 12
RUNS    := $(foreach r,$(wordlist 1,6,$(SEEDS)),$(foreach s,$(SLIPS),pid-s$(s)-r$(r) prescribed-s$(s)-r$(r))) \
           $(foreach r,$(wordlist 7,12,$(SEEDS)),pid-s60-r$(r)) $(foreach r,$(SEEDS),walls-s60-r$(r) light-s60-r$(r))

include reproductions/chapter3/sweep.mk

part           = $(word $(2),$(subst -, ,$(1)))
realisation_of = $(patsubst r%,%,$(lastword $(subst -, ,$(1))))
sets_pid        :=
sets_prescribed := --set control.scheme=prescribed
sets_walls      := --set bed.walls=discs
sets_light      := --set wheel.rim.density_kg_m3=1000 --set wheel.lug.density_kg_m3=1000
sets_of = --set bed.seed=$(call realisation_of,$(1)) --set wheel.lug_phase_deg=$(PHASE_$(call realisation_of,$(1))) $(sets_$(call part,$(1),1))
slip_of = --set travel.slip_percent=$(patsubst s%,%,$(call part,$(1),2))
sunk_of = $(call part,$(1),1)-sunk-$(lastword $(subst -, ,$(1)))
bed_of  = $(if $(filter walls,$(call part,$(1),1)),walls,flat)-bed-$(lastword $(subst -, ,$(1)))

$(foreach r,$(SEEDS),$(eval $(call bed_rule,flat-bed-r$(r),$(CHAPTER)/cases/bin.toml,--set bed.seed=$(r))))
$(foreach r,$(SEEDS),$(eval $(call bed_rule,walls-bed-r$(r),$(CHAPTER)/cases/bin.toml,--set bed.seed=$(r) $(sets_walls))))
SUNK := $(sort $(foreach r,$(RUNS),$(call sunk_of,$(r))))
$(foreach s,$(SUNK),$(eval $(call sunk_rule,$(s),$(CHAPTER)/cases/bin.toml,$(call sets_of,$(s)),$(call bed_of,$(s)))))
$(foreach r,$(RUNS),$(eval $(call travel_rule,$(r),$(CHAPTER)/cases/bin.toml,$(call sets_of,$(r)) $(call slip_of,$(r)),$(call sunk_of,$(r)))))

travels: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS)))
