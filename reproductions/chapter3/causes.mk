# What moves the wheel's H: the suspects, each with the runs that tell (README.md, "Causes"). Slip 60 %, 170 N, Earth, the whole bed, since a window
# of 0.4 m scatters by 7 N in H where a smaller bin's scatters by 20.
#   make causes-chapter3
CHAPTER := reproductions/chapter3
include $(CHAPTER)/realisations.mk
include $(CHAPTER)/whole.mk
OUT     := build/runs/chapter3-causes
IFEDEM  ?= build/ifedem

# WHAT-rREALISATION
# 1: damping of the layers, per second, all parts alike
LAYER   := $(foreach d,0 5 20,$(foreach r,1 2,damping$(d)-r$(r)))
# 3: the rim, elastic or rigid, at one step that both can take
RIM     := $(foreach r,1 2 3 4,elastic-r$(r)) rigid-r1 rigid-r2
# Beside them: speed, damping against the absolute velocity as Eq 2.3 has it (also in the rim or in the layers alone), half
# chord, no layers at all, and the two together
OTHER   := $(foreach w,speed0.05 speed0.2 absolute half-chord wheel-rigid absolute-half,$(foreach r,1 2,$(w)-r$(r))) \
           absolute-half-r3 wheel-rigid-half-r1 wheel-rigid-absolute-r1 absolute-rim-r1 absolute-layers-r1
# The bounce: hub mass changed through the rim's density (3000 kg/m3), and the rhythm of the lugs
BOUNCE  := rim750-r1 rim12000-r1 speed0.07-r1 pairs18-r1
# The four readings (damping × chord) of both wheels: which wheel pulls more? The defaults of three realisations are those of SCENE=whole.
READINGS := $(foreach w,absolute half-chord absolute-half b6-absolute b6-half-chord b6-absolute-half,$(foreach r,1 2 3,$(w)-r$(r)))
RUNS    := $(sort $(READINGS) $(RIM) $(LAYER) $(OTHER) $(BOUNCE))

realisation_of = $(lastword $(subst -r, ,$(1)))
what_of = $(patsubst %-r$(call realisation_of,$(1)),%,$(1))
case_of = $(CHAPTER)/cases/$(if $(filter b6-%,$(1)),B6,B3)-earth.toml
damp = $(foreach p,rim intermediate surface lug,--set wheel.$(p).damping_1_s=$(1))

sets_of_elastic     := --set time_step_s=1.5e-5 --set wheel.body=elastic
sets_of_rigid       := --set time_step_s=1.5e-5
sets_of_absolute    := --set wheel.damping_frame=absolute
sets_of_half-chord  := --set contact.rolling_chord=half
sets_of_wheel-rigid := --set wheel.body=rigid
sets_of_absolute-half        := $(sets_of_absolute) $(sets_of_half-chord)
sets_of_wheel-rigid-half     := $(sets_of_wheel-rigid) $(sets_of_half-chord)
sets_of_wheel-rigid-absolute := $(sets_of_wheel-rigid) $(sets_of_absolute)
sets_of_absolute-rim         := $(sets_of_absolute) $(foreach p,intermediate surface lug,--set wheel.$(p).damping_1_s=0)
sets_of_absolute-layers      := $(sets_of_absolute) --set wheel.rim.damping_1_s=0
sets_of_rim750      := --set wheel.rim.density_kg_m3=750
sets_of_rim12000    := --set wheel.rim.density_kg_m3=12000
sets_of_speed0.07   := --set travel.speed_m_s=0.07
sets_of_pairs18     := --set wheel.lug_pairs=18
sets_of_damping0    := $(call damp,0)
sets_of_damping5    := $(call damp,5)
sets_of_damping20   := $(call damp,20)
sets_of_speed0.05   := --set travel.speed_m_s=0.05
sets_of_speed0.2    := --set travel.speed_m_s=0.2

.PHONY: causes readings
readings: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(READINGS)))
	@mkdir -p build/reports/chapter3
	@$(IFEDEM) metrics $(addprefix $(OUT)/,$(READINGS)) -o build/reports/chapter3/readings.csv
	@echo "table: build/reports/chapter3/readings.csv"

causes: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS)))
	@mkdir -p build/reports/chapter3
	@$(IFEDEM) metrics $(addprefix $(OUT)/,$(RUNS)) -o build/reports/chapter3/causes.csv
	@echo "table: build/reports/chapter3/causes.csv"

define run_rule
$(OUT)/$(1)/run.csv: $(call case_of,$(1))
	@$(IFEDEM) run $(call case_of,$(1)) -o $(OUT)/$(1) --force --quiet $(WHOLE) --set travel.slip_percent=60 \
	  --set bed.seed=$(call realisation_of,$(1)) --set wheel.lug_phase_deg=$(PHASE_$(call realisation_of,$(1))) \
	  $(sets_of_$(patsubst b6-%,%,$(call what_of,$(1)))) > /dev/null && echo "done: $(1)"
endef
$(foreach r,$(RUNS),$(eval $(call run_rule,$(r))))
