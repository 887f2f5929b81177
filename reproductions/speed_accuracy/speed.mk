# Cost against error, chapter by chapter; what is run stands in plan3.mk, plan4.mk and plan5.mk. From the top level's directory:
#   make speed-accuracy                     chapters 3, 4 and 5: prints its CPU time first; may be stopped, the same command goes on
#   make speed-accuracy CHAPTER=4           one chapter; REALISATIONS=3: packings and phases of the variants that have several
#   make speed-accuracy-plan                what would be run, and what of it is there already
#   make quick-speed-accuracy               the machinery on small bins
# FINISHED=build/runs: chapters' campaigns below it. A run of theirs that is the same, key for key, is taken over instead of made.
#   N=3, 4 or 5   the chapter of this call

HERE  := reproductions/speed_accuracy
SWEEP := $(HERE)/speed.mk
# The command line's CHAPTER is the user's: a number. sweep.mk wants the directory.
override CHAPTER := reproductions/chapter$(N)
FINISHED ?= build/runs
REALISATIONS ?= 2
KIND    := $(if $(QUICK),quick_)speed_accuracy
OUT     := build/runs/$(KIND)/chapter$(N)
REPORTS := build/reports/$(KIND)
REPORT  := $(REPORTS)/chapter$(N)
COMMAND ?= make $(if $(QUICK),quick-)speed-accuracy
comma   := ,
TITLE   := Speed against accuracy$(if $(QUICK),$(comma) quick): chapter $(N)
# A disc-step, for the estimate.
NS := 16

step_set  = --set time_step_s=$(1)
radii_set = --set soil.radii_m=[$(1),$(2),$(3)]
PLATES :=
include $(HERE)/plan$(N).mk

# WHAT-sSLIP-rREALISATION, realisation by realisation, so that the variants take turns on the machine and its mood strikes all alike.
ALL_REALISATIONS := $(wordlist 1,$(REALISATIONS),1 2 3 4 5 6 7 8)
runs_of = $(foreach w,$(1),$(foreach s,$(SLIPS),$(w)-s$(s)-r$(2)))
RUNS := $(foreach r,$(ALL_REALISATIONS),$(call runs_of,$(SEVERAL) $(if $(filter 1,$(r)),$(SINGLE)),$(r))) $(MORE)

.PHONY: speed-accuracy plan adopt points guide
speed-accuracy: plan
	@$(MAKE) --no-print-directory -f $(SWEEP) adopt
	-@$(MAKE) --no-print-directory -f $(SWEEP) sweep
	@$(MAKE) --no-print-directory -f $(SWEEP) points

include reproductions/chapter3/sweep.mk
include $(HERE)/trials.mk
CASES += $(wildcard $(HERE)/cases/short$(N).toml)

part = $(word $(2),$(subst -, ,$(1)))
what = $(call part,$(1),1)
realisation_of = $(patsubst r%,%,$(call part,$(1),3))
phase_of = $(PHASE_$(call realisation_of,$(1)))
case_of = $(if $(filter $(1),$(PLATES)),$(PLATE_CASE),$(or $(case_$(firstword $(subst _, ,$(call what,$(1))))),$(CASE)))
sets_of = $(if $(filter $(1),$(PLATES)),--set bed.seed=1 --set wheel.load_N=$(patsubst plate-%N,%,$(1)),--set \
  bed.seed=$(call realisation_of,$(1)) $(if $(call phase_of,$(1)),--set wheel.lug_phase_deg=$(call phase_of,$(1))) $(set_$(call what,$(1))))
slip_of = $(if $(filter $(1),$(PLATES)),,--set travel.slip_percent=$(patsubst s%,%,$(call part,$(1),2)))
sunk_of = $(if $(filter $(1),$(PLATES)),sunk-$(1),sunk-$(call what,$(1))-r$(call realisation_of,$(1)))
bed_of = bed-$(if $(filter $(call what,$(1)),$(WHOLE_BED) plate),whole,$(call what,$(1)))-r$(or $(call realisation_of,$(1)),1)
times_of = $(or $(TIMES_$(call what,$(1))),$(TIMES_$(firstword $(subst _, ,$(call what,$(1))))),1)

# What would be run: a line a run with its sunk wheel, how much dearer its disc-steps are, what `ifedem find` says, and whether it ended.
ELSEWHERE := $(patsubst %/case.toml,%,$(wildcard $(FINISHED)/chapter$(N)/*/case.toml $(FINISHED)/chapter$(N)-*/*/case.toml))
plan_line = e=to_make; [ $(OUT)/$(1)/ended -nt $(INPUTS) ] && e=ended; \
  f=$$($(IFEDEM) find $(call case_of,$(1)) $(filter-out --allow-unstable,$(call sets_of,$(1)) $(call slip_of,$(1))) $$among) || exit 1; \
  echo "$(1) $(call sunk_of,$(1)) $(call times_of,$(1)) $$f $$e";
plan: $(INPUTS)
	@$(if $(ELSEWHERE),among="--among $(ELSEWHERE)"; ){ $(foreach r,$(RUNS) $(PLATES),$(call plan_line,$(r))) } > $(OUT)/plan.txt
	@awk 'function cost(steps) { return steps * $$3 * $(NS) * 1e-9 } { ++n } $$7 == "ended" { ++ended; next } $$6 != "-" { ++taken; next } \
	  { ++made; s += cost($$5) + (seen[$$2]++ ? 0 : cost($$4)) } END { \
	  printf "chapter $(N): %d runs, %d done, %d to take over, %d to make: about %.0f CPU min, %.0f min on $(JOBS) cores\n", \
	  n, ended, taken, made, s / 60, s / 60 / $(JOBS) }' $(OUT)/plan.txt

# Takes over what is the same. A run that was, and is not there any more in the state that the inputs want, is made.
adopt: $(INPUTS)
	@while read run sunk times stages travel from state; do d=$(OUT)/$$run; \
	  [ $$state = to_make ] || continue; rm -f $$d/taken_over.txt; [ $$from != - ] || continue; \
	  mkdir -p $$d; for f in case.toml run.csv series.csv contact_blocks.csv contact_balance.csv; do \
	    [ ! -f $$from/$$f ] || cp $$from/$$f $$d/ || exit 1; done; \
	  rm -f $$d/stopped.txt; echo $$from > $$d/taken_over.txt; touch $$d/ended; done < $(OUT)/plan.txt

points: $(INPUTS)
	@$(if $(PLATES),$(IFEDEM) soil $(addprefix $(OUT)/,$(PLATES)) -o $(OUT)/soil > /dev/null)
	@$(IFEDEM) points $(HERE)/references$(N).csv $(ended_runs) --finest $(FINEST) -o $(REPORT) --title "$(TITLE)" \
	  --command "$(COMMAND)$(if $(QUICK),, CHAPTER=$(N))" $(if $(PLATES),--soil $(OUT)/soil --plates $(addprefix $(OUT)/,$(PLATES)))
	@echo "points: $(REPORT)/points.csv, page: $(REPORT)/index.html"

# One page over the chapters that have points.
guide:
	@$(IFEDEM) points-guide $(patsubst %/points.csv,%,$(wildcard $(REPORTS)/chapter*/points.csv)) -o $(REPORTS) --command "$(COMMAND)"
	@echo "how to read them, what each second buys: $(REPORTS)/index.html"

TO_MAKE := $(filter-out $(patsubst $(OUT)/%/taken_over.txt,%,$(wildcard $(addprefix $(OUT)/,$(addsuffix /taken_over.txt,$(RUNS) $(PLATES))))),$(RUNS) $(PLATES))
# One run of each sunk wheel, and of each bed, stands for it.
first_of = $(foreach x,$(sort $(foreach r,$(2),$(call $(1),$(r)))),$(firstword $(foreach r,$(2),$(if $(filter $(x),$(call $(1),$(r))),$(r)))))
$(foreach r,$(call first_of,bed_of,$(TO_MAKE)),$(eval $(call try_prepare_rule,$(call bed_of,$(r)),$(call case_of,$(r)),$(call sets_of,$(r)),--bed,)))
$(foreach r,$(call first_of,sunk_of,$(TO_MAKE)),$(eval $(call try_prepare_rule,$(call sunk_of,$(r)),$(call case_of,$(r)),$(call sets_of,$(r)),,| $(OUT)/ready/$(call bed_of,$(r)))))
$(foreach r,$(TO_MAKE),$(eval $(call trial_rule,$(r),$(call case_of,$(r)),$(call sets_of,$(r)) $(call slip_of,$(r)),$(call sunk_of,$(r)))))

travels: $(addprefix $(OUT)/,$(addsuffix /ended,$(TO_MAKE)))
