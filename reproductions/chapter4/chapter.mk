# Chapter 4 as a graph of files: bed → sunk tyre → travel (chapter 3's sweep.mk) → contact stress → checks, figures and
# report. Included from the top level's directory:
#   make -f reproductions/chapter4/chapter.mk reproduce
CHAPTER := reproductions/chapter4
SWEEP   := $(CHAPTER)/chapter.mk
# SCENE=fitted: the same travels in the scene that `ifedem fit` left (cases/fitted.toml)
OUT     := build/runs/chapter4$(addprefix -,$(SCENE))
REPORT  := build/reports/chapter4$(addprefix -,$(SCENE))
CASE    := $(CHAPTER)/cases/$(or $(SCENE),tyre).toml
COMMAND ?= make reproduce-chapter4$(addprefix $() SCENE=,$(SCENE))

# WHAT-tyre-sSLIP-rREALISATION; WHAT is `text`, or a variant; m5 is −5 %. A realisation is a packing seed and a phase of the tyre's columns.
SLIPS := 22 7.5 37.5 55 1 m5
MAIN  := $(foreach r,1 2 3 4,$(foreach s,$(SLIPS),text-tyre-s$(s)-r$(r))) $(foreach r,5 6 7 8,text-tyre-s22-r$(r))

# What the text leaves open, one run each at 22 % beside the eight of the main campaign, which must be there. The text has a
# statement about the controllers' gains, so theirs are made with the main campaign.
GAINS    := $(foreach l,drawbar torque,$(foreach t,P I D,$(foreach f,0.1 10,$(l)$(t)$(f))))
VARIANTS := rolling1 wall0 unlevelled loaded_slowly zeta0.05 zeta0.5 surface15 surface25 absolute \
            $(GAINS)
sets_of_text          :=
sets_of_rolling1      := --set contact.rolling_factor=1
sets_of_wall0         := --set contact.consolidation_friction_wall=0
sets_of_unlevelled    := --set bed.levelled_count=0
sets_of_loaded_slowly := --set stages.load_ramp_s=0.8
sets_of_zeta0.05      := --set contact.damping_ratio=0.05
sets_of_zeta0.5       := --set contact.damping_ratio=0.5 --set time_step_s=1e-5
sets_of_surface15     := --set wheel.surface_thickness_m=0.015
sets_of_surface25     := --set wheel.surface_thickness_m=0.025
sets_of_absolute      := --set wheel.damping_frame=absolute
sets_of_rigid         := --set wheel.body=rigid
sets_of_drawbarP0.1   := --set control.drawbar.proportional_N_m=1e5
sets_of_drawbarP10    := --set control.drawbar.proportional_N_m=1e7
sets_of_drawbarI0.1   := --set control.drawbar.integral_N_m_s=1e3
sets_of_drawbarI10    := --set control.drawbar.integral_N_m_s=1e5
sets_of_drawbarD0.1   := --set control.drawbar.derivative_N_s_m=1e3
sets_of_drawbarD10    := --set control.drawbar.derivative_N_s_m=1e5
sets_of_torqueP0.1    := --set control.torque.proportional_Nm_rad=1e4
sets_of_torqueP10     := --set control.torque.proportional_Nm_rad=1e6
sets_of_torqueI0.1    := --set control.torque.integral_Nm_rad_s=1e2
sets_of_torqueI10     := --set control.torque.integral_Nm_rad_s=1e4
sets_of_torqueD0.1    := --set control.torque.derivative_Nm_s_rad=1e2
sets_of_torqueD10     := --set control.torque.derivative_Nm_s_rad=1e4
# The step, from the default down; the text's own is `dt1.25e6`.
STEPS := dt2e5 dt1e5 dt5e6
sets_of_dt2e5   := --set time_step_s=2e-5
sets_of_dt1e5   := --set time_step_s=1e-5
sets_of_dt5e6   := --set time_step_s=5e-6
sets_of_dt1.25e6 := --set time_step_s=1.25e-6

# A tyre that cannot be flattened, as the text assumes: is it softness that decides the shape of the stresses?
RIGID := $(foreach s,$(SLIPS),rigid-tyre-s$(s)-r1)

# Plates on the same bed, N on 0.15 × 0.17 m: 5, 10, 20 and 40 kPa.
PLATES := plate-127.5N plate-255N plate-510N plate-1020N
PLATE_CASE := $(CHAPTER)/cases/plate.toml

run_of = $(1)-tyre-s22-r1
ifeq ($(SET),sensitivity)
RUNS := $(foreach v,$(VARIANTS),$(call run_of,$(v)))
else ifeq ($(SET),step)
RUNS := $(foreach v,$(STEPS),$(call run_of,$(v)))
else ifeq ($(SET),rigid)
RUNS := $(RIGID)
else ifeq ($(SET),text-step)
RUNS := $(call run_of,dt1.25e6)
else
RUNS := $(MAIN) $(if $(SCENE),,$(foreach g,$(GAINS),$(call run_of,$(g))))
endif
# Variants among the campaign's runs are measured apart.
main_runs = $(call fresh,$(filter $(MAIN),$(RUNS)))

.PHONY: reproduce runs report quick sensitivity step text-step rigid rigid-table beside-fitted
reproduce:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs
	@$(MAKE) --no-print-directory -f $(SWEEP) report

runs: sweep

sensitivity step text-step:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs SET=$@
	@$(MAKE) --no-print-directory -f $(SWEEP) table SET=$@

rigid:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs SET=rigid
	@$(MAKE) --no-print-directory -f $(SWEEP) rigid-table SET=rigid

include reproductions/chapter3/sweep.mk

part = $(word $(2),$(subst -, ,$(1)))
realisation_of = $(patsubst r%,%,$(call part,$(1),4))
sets_of = --set bed.seed=$(call realisation_of,$(1)) --set wheel.lug_phase_deg=$(PHASE_$(call realisation_of,$(1))) \
          $(sets_of_$(call part,$(1),1))
slip_of = --set travel.slip_percent=$(subst m,-,$(patsubst s%,%,$(call part,$(1),3)))
# Variants differ in what their beds are made of: each has its own.
bed_of  = bed-$(call part,$(1),1)-r$(call realisation_of,$(1))
sunk_of = sunk-$(call part,$(1),1)-r$(call realisation_of,$(1))

BEDS := $(sort $(foreach r,$(RUNS),$(call part,$(r),1)-tyre-s-r$(call realisation_of,$(r))))
$(foreach b,$(BEDS),$(eval $(call bed_rule,$(call bed_of,$(b)),$(CASE),$(call sets_of,$(b)))))
$(foreach b,$(BEDS),$(eval $(call sunk_rule,$(call sunk_of,$(b)),$(CASE),$(call sets_of,$(b)),$(call bed_of,$(b)))))
$(foreach r,$(RUNS),$(eval $(call travel_rule,$(r),$(CASE),$(call sets_of,$(r)) $(call slip_of,$(r)),$(call sunk_of,$(r)))))

load_of = --set wheel.load_N=$(patsubst plate-%N,%,$(1)) --set bed.seed=1
ifeq ($(SET),)
$(foreach p,$(PLATES),$(eval $(call sunk_rule,sunk-$(p),$(PLATE_CASE),$(call load_of,$(p)),bed-text-r1)))
$(foreach p,$(PLATES),$(eval $(call travel_rule,$(p),$(PLATE_CASE),$(call load_of,$(p)),sunk-$(p))))
travels: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(PLATES)))
endif

travels: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS)))

# Without the discs: at half their radii a travel costs eight times as much (speed_accuracy/ has larger ones).
DOUBT := $(CASE) --set travel.slip_percent=22 --only depth,length,mesh,step

# What the sensitivity runs and `doubt` found, if they were made.
FOUND = $(patsubst %/measurements.csv,%,$(wildcard $(OUT)/sensitivity/measurements.csv)) $(OUT)/gains $(doubted)

# Forces and sinkage of both scenes, travel by travel, and angles of contact, mean by mean.
beside-fitted:
	@awk -f reproductions/chapter3/beside_whole.awk $(REPORT)/runs.csv build/reports/chapter4-fitted/runs.csv > $(REPORT)/beside_fitted.csv
	@cp build/reports/chapter4-fitted/runs.csv $(REPORT)/fitted_runs.csv
	@awk -F, 'BEGIN { print "name,n,whole,scatter,fitted,scatter" } !/_(deg|kPa)_s/ { next } \
	  NR == FNR { whole[$$1] = $$5 "," $$2 "," $$4; next } { print $$1 "," whole[$$1] "," $$2 "," $$4 }' \
	  $(OUT)/stress/measurements.csv $(OUT)-fitted/stress/measurements.csv > $(REPORT)/beside_fitted_stress.csv
	@cat $(REPORT)/beside_fitted.csv $(REPORT)/beside_fitted_stress.csv

report: $(INPUTS)
	@$(IFEDEM) soil $(addprefix $(OUT)/,$(PLATES)) -o $(OUT)/soil
	@$(IFEDEM) stress $(main_runs) --soil $(OUT)/soil -o $(OUT)/stress
	@mkdir -p $(REPORT)
	@$(CHAPTER)/gains.sh $(OUT)/gains $(call fresh,$(call run_of,text) $(foreach g,$(GAINS),$(call run_of,$(g))))
	@cp $(OUT)/gains/gains.csv $(REPORT)/
	@$(IFEDEM) report $(CHAPTER)/claims.csv $(main_runs) $(OUT)/stress $(OUT)/soil $(FOUND) -o $(REPORT) \
	  --title "Chapter 4: contact stress under a tyre" --command "$(COMMAND)"
	@echo "report: $(REPORT)/index.html"
	@$(keep_doubt)
	@$(IFEDEM) check $(CHAPTER)/claims.csv $(main_runs) $(OUT)/stress $(OUT)/soil $(FOUND) -o $(REPORT)/checks.csv
	@set -- $(fresh_runs); [ $$# = $(words $(RUNS)) ] || { echo "$$(( $(words $(RUNS)) - $$# )) of $(words $(RUNS)) runs are missing"; exit 1; }

table: $(INPUTS)
	@mkdir -p $(REPORT)
	@$(IFEDEM) effects --defaults $(wildcard $(OUT)/text-tyre-s22-r*) --variants $(fresh_runs) -o $(OUT)/$(SET)
	@cp $(OUT)/$(SET)/effects.csv $(REPORT)/$(SET).csv
	@echo "table: $(REPORT)/$(SET).csv"

rigid-table: $(INPUTS)
	@mkdir -p $(REPORT)
	@$(IFEDEM) stress $(fresh_runs) -o $(OUT)/rigid
	@cp $(OUT)/rigid/measurements.csv $(REPORT)/rigid.csv
	@echo "table: $(REPORT)/rigid.csv"

QUICK := build/runs/quick4
quick:
	@mkdir -p $(QUICK)
	@for s in -5 7.5 22 55; do \
	  $(IFEDEM) run $(CHAPTER)/cases/short.toml -o $(QUICK)/short-s$$s --force --quiet --set travel.slip_percent=$$s || exit 1; done
	@$(IFEDEM) stress $(QUICK)/short-s* -o $(QUICK)/stress
	@$(IFEDEM) report $(CHAPTER)/claims.csv $(QUICK)/short-s* $(QUICK)/stress -o build/reports/quick4 \
	  --title "Chapter 4, quick: the machinery, not the numbers" --command "make quick-chapter4"
	@echo "report: build/reports/quick4/index.html"
