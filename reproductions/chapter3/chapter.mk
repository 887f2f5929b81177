# Chapter 3 as a graph of files: bed → sunk wheel → travel → checks → report. Included from the top level's directory:
#   make -f reproductions/chapter3/chapter.mk reproduce
# A run that was interrupted goes on from its checkpoint; a finished one is not repeated unless its case or the results version
# changes.

CHAPTER := reproductions/chapter3
include $(CHAPTER)/realisations.mk
OUT     := build/runs/chapter3
REPORT  := build/reports/chapter3
CASES   := $(wildcard $(CHAPTER)/cases/*.toml)
COMMAND ?= make reproduce-chapter3

# WHEEL-PLANET-LOAD-sSLIP-rREALISATION. A realisation is a packing seed and a lug phase (golden section of the pitch of 30°).
SLIPS  := 0 10 20 30 40 50 60 70
EARTH  := $(foreach s,$(SLIPS),B3-earth-170N-s$(s)-r1) $(foreach r,2 3 4 5 6 7 8,B3-earth-170N-s60-r$(r))
MARS   := $(foreach r,1 2 3 4 5 6 7 8,B3-mars-64.4N-s60-r$(r))
RUNS   := $(EARTH) $(MARS)

part = $(word $(2),$(subst -, ,$(1)))
case_of = $(CHAPTER)/cases/$(call part,$(1),1)-$(call part,$(1),2).toml
realisation_of = $(patsubst r%,%,$(call part,$(1),5))
bed_of = $(call part,$(1),1)-$(call part,$(1),2)-r$(call realisation_of,$(1))
load_of = $(patsubst %N,%,$(call part,$(1),3))
sets_of = --set wheel.load_N=$(call load_of,$(1)) --set bed.seed=$(call realisation_of,$(1)) \
          --set wheel.lug_phase_deg=$(PHASE_$(call realisation_of,$(1)))

.PHONY: reproduce runs quick
.SECONDARY:

reproduce:
	@mkdir -p $(OUT)
	@$(IFEDEM) watch $(addprefix $(OUT)/,$(RUNS)) & watcher=$$!; \
	$(MAKE) --no-print-directory -k -j$(JOBS) -f $(CHAPTER)/chapter.mk runs; status=$$?; \
	kill $$watcher 2>/dev/null; wait $$watcher 2>/dev/null; exit $$status
	@$(IFEDEM) report $(CHAPTER)/claims.csv $(addprefix $(OUT)/,$(RUNS)) $(OUT)/stiffness -o $(REPORT) \
	  --title "Chapter 3: an elastic rover wheel on sand" --command "$(COMMAND)"
	@echo "report: $(REPORT)/index.html"
	@$(IFEDEM) check $(CHAPTER)/claims.csv $(addprefix $(OUT)/,$(RUNS)) $(OUT)/stiffness -o $(REPORT)/checks.csv

runs: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS))) $(OUT)/stiffness/stiffness_summary.csv

# Renewed only when the number changes, so that rebuilding the program does not repeat the campaign.
$(OUT)/results_version: FORCE
	@mkdir -p $(OUT)
	@$(IFEDEM) --version | sed 's/.*results version \([0-9]*\).*/\1/' | cmp -s - $@ || \
	$(IFEDEM) --version | sed 's/.*results version \([0-9]*\).*/\1/' > $@
FORCE:

# The sunk wheel of a planet, load and realisation; its travels share it.
define prepare_rule
$(OUT)/prepared-$(call part,$(1),1)-$(call part,$(1),2)-$(call part,$(1),3)-r$(call realisation_of,$(1)): $(CASES) $(OUT)/results_version
	@$(IFEDEM) prepare $(call case_of,$(1)) $(call sets_of,$(1)) --quiet > /dev/null && touch $$@
endef
unique_beds := $(sort $(foreach r,$(RUNS),$(call part,$(r),1)-$(call part,$(r),2)-$(call part,$(r),3)-s-r$(call realisation_of,$(r))))
$(foreach b,$(unique_beds),$(eval $(call prepare_rule,$(b))))

define run_rule
$(OUT)/$(1)/run.csv: $(OUT)/prepared-$(call part,$(1),1)-$(call part,$(1),2)-$(call part,$(1),3)-r$(call realisation_of,$(1))
	@if [ -f $(OUT)/$(1)/checkpoint.h5 ] && [ $(OUT)/$(1)/checkpoint.h5 -nt $(OUT)/results_version ]; then $(IFEDEM) resume $(OUT)/$(1) --quiet > /dev/null; \
	else $(IFEDEM) run $(call case_of,$(1)) -o $(OUT)/$(1) --force --quiet $(call sets_of,$(1)) \
	  --set travel.slip_percent=$(patsubst s%,%,$(call part,$(1),4)) > /dev/null; fi
endef
$(foreach r,$(RUNS),$(eval $(call run_rule,$(r))))

$(OUT)/stiffness/stiffness_summary.csv: $(CASES)
	@$(IFEDEM) stiffness $(CHAPTER)/cases/B3-earth.toml $(CHAPTER)/cases/B6-earth.toml -o $(OUT)/stiffness

quick:
	@mkdir -p build/runs/quick3
	@$(IFEDEM) run $(CHAPTER)/cases/short.toml -o build/runs/quick3/short-s60 --force --quiet
	@$(IFEDEM) run $(CHAPTER)/cases/short.toml -o build/runs/quick3/short-s20 --force --quiet --set travel.slip_percent=20
	@$(IFEDEM) stiffness $(CHAPTER)/cases/B3-earth.toml $(CHAPTER)/cases/B6-earth.toml -o build/runs/quick3/stiffness
	@$(IFEDEM) report $(CHAPTER)/claims.csv build/runs/quick3/short-s60 build/runs/quick3/short-s20 build/runs/quick3/stiffness \
	  -o build/reports/quick3 --title "Chapter 3, quick: the machinery, not the numbers" --command "make quick-chapter3"
	@echo "report: build/reports/quick3/index.html"
