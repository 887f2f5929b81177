# Chapter 3 as a graph of files: bed → sunk wheel → travel (sweep.mk) → checks, figures and report. Included from the top
# level's directory:
#   make -f reproductions/chapter3/chapter.mk reproduce

CHAPTER := reproductions/chapter3
SWEEP   := $(CHAPTER)/chapter.mk
# SCENE=whole: the same travels in the scene from which `ifedem fit` began (cases/whole.toml), three times as long
OUT     := build/runs/chapter3$(addprefix -,$(SCENE))
REPORT  := build/reports/chapter3$(addprefix -,$(SCENE))
COMMAND ?= make reproduce-chapter3$(addprefix $() SCENE=,$(SCENE))
include $(CHAPTER)/whole.mk
scene_sets := $(if $(SCENE),$(WHOLE))

# WHEEL-PLANET-LOAD-sSLIP-rREALISATION, what the text gives numbers for first. A realisation is a packing seed and a lug phase.
SLIPS := 0 10 20 30 40 50 60 70
LOADS := 170 100 50 130 70
slips_of = $(foreach s,$(SLIPS),$(1)-s$(s)-r1)
more_of  = $(foreach r,$(2),$(1)-r$(r))
RUNS := $(call slips_of,B3-earth-170N) $(call more_of,B3-earth-170N-s60,2 3 4 5 6 7 8) \
        $(call slips_of,B3-mars-64.4N) $(call more_of,B3-mars-64.4N-s60,2 3 4 5 6 7 8) \
        $(foreach w,B3-earth-170N B3-mars-64.4N,$(foreach s,20 70,$(call more_of,$(w)-s$(s),2 3))) \
        $(call slips_of,B6-earth-170N) $(call slips_of,B6-mars-64.4N) \
        $(foreach w,B6-earth-170N B6-mars-64.4N B3-earth-100N B3-earth-50N,$(call more_of,$(w)-s60,2 3)) \
        $(foreach l,$(wordlist 2,5,$(LOADS)),$(foreach w,B3 B6,$(call slips_of,$(w)-earth-$(l)N)))

.PHONY: reproduce runs report quick sensitivity fidelity beside-whole

# FIDELITY=dissertation CASE=B3-earth-170N-s60-r1: this run with the text's own step, all three stages, against its 45,400 s.
ifeq ($(FIDELITY),dissertation)
reproduce: fidelity
else
# Plain commands, so that a signal to make reaches the sweep. Whatever failed there is told, and the report is written.
reproduce:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs
	@$(MAKE) --no-print-directory -f $(SWEEP) report
endif

runs: sweep

include $(CHAPTER)/sweep.mk

part = $(word $(2),$(subst -, ,$(1)))
case_of = $(CHAPTER)/cases/$(call part,$(1),1)-$(call part,$(1),2).toml
realisation_of = $(patsubst r%,%,$(lastword $(subst -, ,$(1))))
bed_of = $(call part,$(1),2)-r$(call realisation_of,$(1))
sunk_of = $(call part,$(1),1)-$(call part,$(1),2)-$(call part,$(1),3)-r$(call realisation_of,$(1))
sets_of = --set bed.seed=$(call realisation_of,$(1)) --set wheel.lug_phase_deg=$(PHASE_$(call realisation_of,$(1))) \
          --set wheel.load_N=$(patsubst %N,%,$(call part,$(1),3)) $(scene_sets)
slip_of = --set travel.slip_percent=$(patsubst s%,%,$(call part,$(1),4))

SUNK := $(sort $(foreach r,$(RUNS),$(call sunk_of,$(r))))
BEDS := $(sort $(foreach r,$(RUNS),$(call bed_of,$(r))))
$(foreach b,$(BEDS),$(eval $(call bed_rule,$(b),$(CHAPTER)/cases/B3-$(call part,$(b),1).toml,--set bed.seed=$(call realisation_of,$(b)) $(scene_sets))))
$(foreach s,$(SUNK),$(eval $(call sunk_rule,$(s),$(call case_of,$(s)),$(call sets_of,$(s)),$(call bed_of,$(s)))))
$(foreach r,$(RUNS),$(eval $(call travel_rule,$(r),$(call case_of,$(r)),$(call sets_of,$(r)) $(call slip_of,$(r)),$(call sunk_of,$(r)))))

travels: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS))) $(OUT)/stiffness/stiffness_summary.csv

LAST_FILES += $(OUT)/stiffness/stiffness_summary.csv
$(OUT)/stiffness/stiffness_summary.csv: $(INPUTS)
	@exec > /dev/null 2> $(OUT)/logs/stiffness.log; \
	exec $(IFEDEM) stiffness $(CHAPTER)/cases/B3-earth.toml $(CHAPTER)/cases/B6-earth.toml -o $(OUT)/stiffness

DOUBT := $(CHAPTER)/cases/B3-earth.toml --set travel.slip_percent=60

# What the sensitivity sweep and `doubt` found, if they were run.
FOUND = $(patsubst %/effects.csv,%,$(wildcard build/runs/chapter3-sensitivity/effects.csv)) $(doubted)

sensitivity:
	@$(MAKE) --no-print-directory -f $(CHAPTER)/sensitivity.mk sensitivity

# Both scenes' tables of runs, travel by travel.
beside-whole:
	@awk -f $(CHAPTER)/beside_whole.awk build/reports/chapter3-whole/runs.csv $(REPORT)/runs.csv > $(REPORT)/beside_whole.csv
	@cp build/reports/chapter3-whole/runs.csv $(REPORT)/whole_runs.csv
	@cat $(REPORT)/beside_whole.csv

report: $(INPUTS)
	@$(IFEDEM) report $(CHAPTER)/claims.csv $(fresh_runs) $(OUT)/stiffness $(FOUND) -o $(REPORT) \
	  --title "Chapter 3: an elastic rover wheel on sand" --command "$(COMMAND)"
	@echo "report: $(REPORT)/index.html"
	@$(keep_doubt)
	@cp $(OUT)/B3-earth-170N-s60-r1/snapshot.png $(REPORT)/wheel.png 2> /dev/null || true # the README's picture
	@awk -f $(CHAPTER)/equal_slip.awk $(REPORT)/runs.csv > $(REPORT)/equal_slip.csv
	@$(IFEDEM) check $(CHAPTER)/claims.csv $(fresh_runs) $(OUT)/stiffness $(FOUND) -o $(REPORT)/checks.csv
	@set -- $(fresh_runs); [ $$# = $(words $(RUNS)) ] || { echo "$$(( $(words $(RUNS)) - $$# )) of $(words $(RUNS)) runs are missing"; exit 1; }

# The text does not say which stages its 45,400 s hold, so both ratios are printed.
THREADS ?= 1
FIDELITY_OUT := build/runs/chapter3-dissertation
TEXT_STEP := $(if $(filter mars,$(call part,$(CASE),2)),5e-6,1e-5)
FIDELITY_SETS = $(call sets_of,$(CASE)) $(WHOLE) --set time_step_s=$(TEXT_STEP) --threads $(THREADS) --stages $(FIDELITY_OUT)/stages --quiet
fidelity:
	$(if $(filter $(CASE),$(RUNS)),,$(error CASE '$(CASE)' is not a run of this chapter. Write it like B3-earth-170N-s60-r1))
	@mkdir -p $(FIDELITY_OUT); rm -rf $(FIDELITY_OUT)/stages
	@$(IFEDEM) prepare $(call case_of,$(CASE)) $(FIDELITY_SETS) > $(FIDELITY_OUT)/prepare.txt
	@$(IFEDEM) run $(call case_of,$(CASE)) -o $(FIDELITY_OUT)/$(CASE) --force $(FIDELITY_SETS) $(call slip_of,$(CASE)) > $(FIDELITY_OUT)/travel.txt
	@cat $(FIDELITY_OUT)/travel.txt
	@cat $(FIDELITY_OUT)/prepare.txt $(FIDELITY_OUT)/travel.txt | sed -n 's/.* wall_s=\([0-9.]*\).*/\1/p' | \
	awk '{ s[NR] = $$1 } END { printf "travel %.1f s: %.0f times faster than 45400 s; all three stages %.1f s: %.0f times\n", s[2], 45400/s[2], s[1]+s[2], 45400/(s[1]+s[2]) }'

quick:
	@mkdir -p build/runs/quick3
	@$(IFEDEM) run $(CHAPTER)/cases/short.toml -o build/runs/quick3/short-s60 --force --quiet
	@$(IFEDEM) run $(CHAPTER)/cases/short.toml -o build/runs/quick3/short-s20 --force --quiet --set travel.slip_percent=20
	@$(IFEDEM) stiffness $(CHAPTER)/cases/B3-earth.toml $(CHAPTER)/cases/B6-earth.toml -o build/runs/quick3/stiffness
	@$(IFEDEM) report $(CHAPTER)/claims.csv build/runs/quick3/short-s60 build/runs/quick3/short-s20 build/runs/quick3/stiffness \
	  -o build/reports/quick3 --title "Chapter 3, quick: the machinery, not the numbers" --command "make quick-chapter3"
	@echo "report: build/reports/quick3/index.html"
