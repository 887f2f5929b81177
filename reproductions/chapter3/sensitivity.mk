# What each choice that the text leaves open does in the whole scene (cases/whole.toml), where no saving of ours can hide it: one input
# changed, the rest as chosen (choices.csv), B3 under 170 N on Earth at 0, 20 and 60 % slip, against runs of the same packing and lug phase. Two readings of the text are whole condition
# sets: damping against the absolute velocity with half the chord, eight realisations at 60 % on Earth and on Mars.
#   make -f reproductions/chapter3/sensitivity.mk sensitivity
#   make -f reproductions/chapter3/sensitivity.mk literal        that second reading alone, sixteen travels

CHAPTER := reproductions/chapter3
SWEEP   := $(CHAPTER)/sensitivity.mk
OUT     := build/runs/chapter3-sensitivity
DEFAULT := build/runs/chapter3-whole
include $(CHAPTER)/whole.mk

# One step each way where there are two ways; --set arguments of each.
all_parts = $(foreach p,rim intermediate surface lug,--set wheel.$(p).damping_1_s=$(1))
set_layer15    := --set wheel.surface_thickness_m=0.015
set_layer25    := --set wheel.surface_thickness_m=0.025
set_lug3       := --set wheel.lug_thickness_m=0.003
set_lug9       := --set wheel.lug_thickness_m=0.009
set_gap10      := --set wheel.lug_gap_m=0.01
set_gap30      := --set wheel.lug_gap_m=0.03
set_rings      := --set wheel.intermediate_rings=8 --set wheel.surface_rings=4
set_undamped   := $(call all_parts,0)
set_damped20   := $(call all_parts,20)
set_absolute   := --set wheel.damping_frame=absolute
set_zeta01     := --set contact.damping_ratio=0.1
set_zeta04     := --set contact.damping_ratio=0.4
set_half       := --set contact.rolling_chord=half
set_sign       := --set contact.rolling_scheme=sign
set_attraction := --set contact.contact_end=attraction
set_bed14      := --set bed.length_m=1.4
set_bed18      := --set bed.length_m=1.8
set_discwalls  := --set bed.walls=discs
set_lugtip     := --set travel.slip_radius=lug-tip
set_step2      := --set time_step_s=2e-5
set_explicit   := --set control.scheme=explicit
set_both       := $(set_absolute) $(set_half)
set_slow       := --set travel.speed_m_s=0.01 --set travel.distance_m=0.4

# The bed of these is not the default's.
OWN_BED := zeta01 zeta04 half sign attraction bed14 bed18 discwalls step2 both

# WHAT-PLANET-sSLIP-rREALISATION; what says most first. A travel at 10 mm/s takes ten times as long: half the way, once.
ONE_BY_ONE := half absolute layer15 layer25 zeta01 zeta04 lug3 lug9 gap10 gap30 lugtip bed14 bed18 discwalls undamped damped20 \
              sign attraction explicit rings step2
LITERAL := $(foreach r,1 2 3 4 5 6 7 8,both-earth-s60-r$(r) both-mars-s60-r$(r))
RUNS := $(LITERAL) both-earth-s0-r1 both-earth-s20-r1 $(foreach w,$(ONE_BY_ONE),$(foreach s,60 20 0,$(w)-earth-s$(s)-r1)) slow-earth-s60-r1

.PHONY: sensitivity literal
sensitivity:
	@$(MAKE) --no-print-directory -k -j$(JOBS) -f $(CHAPTER)/chapter.mk SCENE=whole $(addsuffix /run.csv,$(DEFAULTS))
	-@$(MAKE) --no-print-directory -f $(SWEEP) sweep
	@$(IFEDEM) effects --defaults $(DEFAULTS) --variants $(fresh_runs) -o $(OUT)
	@mkdir -p build/reports/chapter3 && cp $(OUT)/effects.csv build/reports/chapter3/effects.csv
	@echo "table: build/reports/chapter3/effects.csv; make reproduce-chapter3 puts it into the report"

literal:
	-@$(MAKE) --no-print-directory -f $(SWEEP) sweep RUNS="$(LITERAL)"
	@mkdir -p build/reports/chapter3
	@$(IFEDEM) metrics $(wildcard $(addprefix $(OUT)/,$(LITERAL))) -o build/reports/chapter3/literal.csv
	@echo "table: build/reports/chapter3/literal.csv"

include $(CHAPTER)/sweep.mk

part = $(word $(2),$(subst -, ,$(1)))
realisation_of = $(patsubst r%,%,$(lastword $(subst -, ,$(1))))
case_of = $(CHAPTER)/cases/B3-$(call part,$(1),2).toml
sunk_of = $(call part,$(1),1)-$(call part,$(1),2)-r$(call realisation_of,$(1))
bed_of = $(if $(filter $(call part,$(1),1),$(OWN_BED)),bed-$(call part,$(1),1),bed-default)-$(call part,$(1),2)-r$(call realisation_of,$(1))
set_of_bed = $(if $(filter default,$(call part,$(1),2)),,$(set_$(call part,$(1),2)))
sets_of = $(WHOLE) --set bed.seed=$(call realisation_of,$(1)) --set wheel.lug_phase_deg=$(PHASE_$(call realisation_of,$(1))) $(set_$(call part,$(1),1))
slip_of = --set travel.slip_percent=$(patsubst s%,%,$(call part,$(1),3))
default_of = $(DEFAULT)/B3-$(call part,$(1),2)-$(if $(filter mars,$(call part,$(1),2)),64.4N,170N)-$(call part,$(1),3)-r$(call realisation_of,$(1))

DEFAULTS := $(sort $(foreach r,$(RUNS),$(call default_of,$(r))))
SUNK := $(sort $(foreach r,$(RUNS),$(call sunk_of,$(r))))
BEDS := $(sort $(foreach r,$(RUNS),$(call bed_of,$(r))))
$(foreach b,$(BEDS),$(eval $(call bed_rule,$(b),$(CHAPTER)/cases/B3-$(call part,$(b),3).toml,$(WHOLE) --set bed.seed=$(call realisation_of,$(b)) $(call set_of_bed,$(b)))))
$(foreach s,$(SUNK),$(eval $(call sunk_rule,$(s),$(call case_of,$(s)),$(call sets_of,$(s)),$(call bed_of,$(s)))))
$(foreach r,$(RUNS),$(eval $(call travel_rule,$(r),$(call case_of,$(r)),$(call sets_of,$(r)) $(call slip_of,$(r)),$(call sunk_of,$(r)))))

travels: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS)))
