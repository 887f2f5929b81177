# Cost against error: one change each from chapter 3's default, B3 under 170 N on Earth at 20 and 60 % slip, three realisations.
#   make speed-accuracy          the whole: prints its CPU time first; may be stopped, the same command goes on
#   make quick-speed-accuracy    the machinery on a small bin

CHAPTER := reproductions/chapter3
HERE    := reproductions/speed_accuracy
SWEEP   := $(HERE)/speed.mk
FINEST  := step0.25

# WHAT: --set arguments, and its work as a share of the default's for the estimate (disc-steps, 0 where the end comes soon; modified
# Euler, elastic rims, elements and finer meshes with what a step costs more).
step_set = --set time_step_s=$(1)
set_step0.25   := $(call step_set,1e-5)
set_step0.5    := $(call step_set,2e-5)
set_step1.5    := $(call step_set,6e-5)
set_step2      := $(call step_set,8e-5)
set_step2.25   := $(call step_set,9e-5)
# Beyond limits that are certain: a sunk bed as it stands (near 1e-4 s), then the wheel's elements (1.5e-4 s), then an isolated pair of
# discs (2.1e-4 s). Run all the same, to show the end.
set_step3      := $(call step_set,1.2e-4) --allow-unstable
set_step4      := $(call step_set,1.6e-4) --allow-unstable
set_step5      := $(call step_set,2e-4) --allow-unstable
set_step6      := $(call step_set,2.4e-4) --allow-unstable
set_euler1     := --set integrator=modified-euler-one
set_euler2     := --set integrator=modified-euler-two
set_rigid      := --set wheel.body=rigid
set_elastic    := --set wheel.body=elastic $(call step_set,1.5e-5)
set_coarse     := --set wheel.intermediate_rings=2 --set wheel.surface_rings=1
set_fine       := --set wheel.intermediate_rings=8 --set wheel.surface_rings=4
set_speed0.05  := --set travel.speed_m_s=0.05
set_speed0.2   := --set travel.speed_m_s=0.2
# The soil of a radius r times as large has 1/r² of the discs; half the depth has half of them.
set_discs1.5   := --set soil.radii_m=[0.003,0.00375,0.0045] --set bed.disc_count=8652
set_discs2     := --set soil.radii_m=[0.004,0.005,0.006] --set bed.disc_count=4867
set_depth0.5   := --set bed.disc_count=9734
set_depth0.75  := --set bed.disc_count=14601
# Half the bed's height as elements under the discs, with the elastic constants of this sand (chapter 2: 0.71 MPa and 0.04) and the
# density of its bulk.
soil_elements = --set elements.columns=$(1) --set elements.rows=1 --set elements.block_height_m=$(2) \
                --set elements.material.young_Pa=0.71e6 --set elements.material.poisson=0.04 --set contact.friction_elements=0.6
set_elements0.5 := $(call soil_elements,10,0.135) --set bed.disc_count=9734
# Three quarters of the bin end 0.275 m beyond a travel of 0.5 m; the window is the same share of it.
set_length0.75 := --set bed.length_m=1.125 --set bed.disc_count=14601 --set travel.distance_m=0.5
# The savings together. Discs twice as large bear twice the step, as far as the wheel's elements do.
set_discs2_step3 := $(set_discs2) $(call step_set,1.2e-4)
set_lean       := --set soil.radii_m=[0.003,0.00375,0.0045] --set bed.length_m=1.125 --set bed.disc_count=6489 \
                  --set travel.distance_m=0.5 $(call step_set,8e-5)

WORK_default := 1
WORK_step0.25 := 4
WORK_step0.5 := 2
WORK_step1.5 := 0.67
WORK_step2 := 0.5
WORK_step2.25 := 0.44
WORK_step3 := 0.33
WORK_step4 := 0
WORK_step5 := 0
WORK_step6 := 0
WORK_discs2_step3 := 0.08
WORK_elements0.5 := 0.6
WORK_euler1 := 1.2
WORK_euler2 := 2
WORK_rigid := 1
WORK_elastic := 3
WORK_coarse := 1
WORK_fine := 1.5
WORK_speed0.05 := 1.8
WORK_speed0.2 := 0.6
WORK_discs1.5 := 0.44
WORK_discs2 := 0.25
WORK_depth0.5 := 0.5
WORK_depth0.75 := 0.75
WORK_length0.75 := 0.5
WORK_lean := 0.11

# The bed of these is the default's.
DEFAULT_BED := default rigid coarse fine speed0.05 speed0.2

# Realisation by realisation, so that the variants take turns on the machine and its mood strikes all alike.
VARIANTS := $(FINEST) default step2 discs2 depth0.5 rigid step0.5 step1.5 step2.25 step3 step4 step5 step6 discs1.5 depth0.75 \
            elements0.5 length0.75 lean discs2_step3 euler1 euler2 elastic coarse fine speed0.05 speed0.2
REALISATIONS := 1 2 3
CASE   := $(CHAPTER)/cases/B3-earth.toml
OUT    := build/runs/speed_accuracy
REPORT := build/reports/speed_accuracy
TITLE  := Speed against accuracy: chapter 3
COMMAND ?= make speed-accuracy
# CPU seconds of the default: a travel, and the bed and the sunk wheel that the slips of a realisation share.
TRAVEL_S := 70
STAGES_S := 25

ifdef QUICK
FINEST := step0.5
VARIANTS := $(FINEST) default step2 step4 depth0.75 elements0.5
set_depth0.75 := --set bed.disc_count=1800
set_elements0.5 := $(call soil_elements,4,0.045) --set bed.disc_count=1200
REALISATIONS := 1 2
CASE   := $(HERE)/cases/short.toml
OUT    := build/runs/quick_speed_accuracy
REPORT := build/reports/quick_speed_accuracy
TITLE  := Speed against accuracy, quick: the machinery, not the numbers
COMMAND := make quick-speed-accuracy
TRAVEL_S := 2
STAGES_S := 2
endif

# WHAT-PLANET-sSLIP-rREALISATION
RUNS := $(foreach r,$(REALISATIONS),$(foreach w,$(VARIANTS),$(w)-earth-s60-r$(r) $(w)-earth-s20-r$(r)))

.PHONY: speed-accuracy points
speed-accuracy:
	@echo "$(foreach w,$(VARIANTS),$(WORK_$(w)))" | awk '{ for (k = 1; k <= NF; ++k) w += $$k; \
	  s = w * $(words $(REALISATIONS)) * (2 * $(TRAVEL_S) + $(STAGES_S)); \
	  printf "$(words $(RUNS)) runs, about %.0f CPU min in all: %.0f min on $(JOBS) cores (what is done is not repeated)\n", s / 60, s / 60 / $(JOBS) }'
	-@$(MAKE) --no-print-directory -f $(SWEEP) sweep
	@$(MAKE) --no-print-directory -f $(SWEEP) points

include $(CHAPTER)/sweep.mk
include $(HERE)/trials.mk
CASES += $(HERE)/cases/short.toml
points: $(INPUTS)
	@$(IFEDEM) points $(HERE)/references.csv $(ended_runs) --finest $(FINEST) -o $(REPORT) --title "$(TITLE)" --command "$(COMMAND)"
	@echo "points: $(REPORT)/points.csv, page: $(REPORT)/index.html"

part = $(word $(2),$(subst -, ,$(1)))
realisation_of = $(patsubst r%,%,$(lastword $(subst -, ,$(1))))
sunk_of = $(call part,$(1),1)-earth-r$(call realisation_of,$(1))
bed_of = bed-$(if $(filter $(call part,$(1),1),$(DEFAULT_BED)),default,$(call part,$(1),1))-earth-r$(call realisation_of,$(1))
seed_of = --set bed.seed=$(call realisation_of,$(1))
sets_of = $(call seed_of,$(1)) --set wheel.lug_phase_deg=$(PHASE_$(call realisation_of,$(1))) $(set_$(call part,$(1),1))
slip_of = --set travel.slip_percent=$(patsubst s%,%,$(call part,$(1),3))

SUNK := $(sort $(foreach r,$(RUNS),$(call sunk_of,$(r))))
BEDS := $(sort $(foreach r,$(RUNS),$(call bed_of,$(r))))
$(foreach b,$(BEDS),$(eval $(call try_prepare_rule,$(b),$(CASE),$(call seed_of,$(b)) $(set_$(call part,$(b),2)),--bed,)))
$(foreach s,$(SUNK),$(eval $(call try_prepare_rule,$(s),$(CASE),$(call sets_of,$(s)),,| $(OUT)/ready/$(call bed_of,$(s)))))
$(foreach r,$(RUNS),$(eval $(call trial_rule,$(r),$(CASE),$(call sets_of,$(r)) $(call slip_of,$(r)),$(call sunk_of,$(r)))))

travels: $(addprefix $(OUT)/,$(addsuffix /ended,$(RUNS)))
