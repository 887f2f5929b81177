# Why the elastic wheel's H is low: the first three causes, each with the runs that tell (README.md, "Causes").
#   make causes-chapter3
CHAPTER := reproductions/chapter3
OUT     := build/runs/chapter3-causes
CASE    := $(CHAPTER)/cases/small-earth.toml
WHOLE   := $(CHAPTER)/cases/B3-earth.toml

# 1 and 2: damping of the layers (per second, all parts alike) and speed
DAMPINGS := 0 1 5 20
SPEEDS   := 0.2 0.1 0.05
LAYER    := $(foreach d,$(DAMPINGS),$(foreach v,$(SPEEDS),damping$(d)-speed$(v)))
# 3: the rim, elastic or rigid, at one step that both can take; on the whole bed, where a window of 0.4 m scatters by 5 N in H instead of 20.
# The campaign's eight rigid ones at 4e-5 s stand beside them.
RIM      := $(foreach r,1 2 3 4,rim-elastic-r$(r)) rim-rigid-r1 rim-rigid-r2
# Beside them: the whole wheel rigid
BODY     := wheel-rigid-r1 wheel-rigid-r2 wheel-rigid-rim-r1 wheel-rigid-rim-r2
# 4: damping against the absolute velocity, as Eq 2.3 has it; 7: half chord
OTHER    := absolute-r1 absolute-r2 half-chord-r1 half-chord-r2
RUNS     := $(RIM) $(LAYER) $(BODY) $(OTHER)

damp = $(foreach p,rim intermediate surface lug,--set wheel.$(p).damping_1_s=$(1))
PHASE_1 := 0
PHASE_2 := 18.541
PHASE_3 := 7.082
PHASE_4 := 25.623
realisation_of = $(patsubst r%,%,$(lastword $(subst -, ,$(1))))
seed = --set bed.seed=$(call realisation_of,$(1)) --set wheel.lug_phase_deg=$(PHASE_$(call realisation_of,$(1)))

sets-damping = $(call damp,$(patsubst damping%,%,$(word 1,$(subst -, ,$(1))))) \
               --set travel.speed_m_s=$(patsubst speed%,%,$(word 2,$(subst -, ,$(1))))
sets-rim = $(call seed,$(1)) --set time_step_s=1.5e-5 --set travel.slip_percent=60 --set wheel.body=$(if $(findstring elastic,$(1)),elastic,rigid-rim)
sets-wheel = $(call seed,$(1)) --set wheel.body=$(if $(findstring rim,$(1)),rigid-rim,rigid)
sets-absolute = $(call seed,$(1)) --set wheel.damping_frame=absolute
sets-half = $(call seed,$(1)) --set contact.rolling_chord=half

.PHONY: causes
causes: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS)))
	@mkdir -p build/reports/chapter3
	@$(IFEDEM) metrics $(addprefix $(OUT)/,$(RUNS)) -o build/reports/chapter3/causes.csv
	@echo "table: build/reports/chapter3/causes.csv"

define run_rule
$(OUT)/$(1)/run.csv: $(CASE) $(WHOLE)
	@$(IFEDEM) run $(if $(filter rim-%,$(1)),$(WHOLE),$(CASE)) -o $(OUT)/$(1) --force --quiet \
	  $(call sets-$(firstword $(subst -, ,$(patsubst damping%,damping-%,$(1)))),$(1)) > /dev/null && echo "done: $(1)"
endef
$(foreach r,$(RUNS),$(eval $(call run_rule,$(r))))
