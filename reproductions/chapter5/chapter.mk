# Chapter 5 as a graph of files: bed → sunk tyre → travel (the sweep's rules of chapter 3) → measurements → checks, report.
# Included from the top level's directory:
#   make -f reproductions/chapter5/chapter.mk reproduce

CHAPTER := reproductions/chapter5
SWEEP   := $(CHAPTER)/chapter.mk
OUT     := build/runs/chapter5
REPORT  := build/reports/chapter5
COMMAND ?= make reproduce-chapter5

# REGION-sSLIP-rREALISATION, and -WHAT for a variant
SLIPS   := 0 10 20 30 40 50 60 70
REGIONS := small middle large row discs

# What the text leaves open, WHAT:key=value, one change each on the small region at 40 %.
VARIED  := discs1451:elements.pattern_discs=1451 handover:elements.stress_handover=mean \
           massfull:elements.pattern_mass_factor=1 friction0.5:contact.friction_elements=0.5 \
           damping0:elements.material.damping_1_s=0 damping50:elements.material.damping_1_s=50 \
           interval100:elements.conversion_interval_steps=100 interval2500:elements.conversion_interval_steps=2500 \
           step2e5:time_step_s=2e-5
ifeq ($(SET),sensitivity)
RUNS    := small-s40-r1 $(foreach v,$(VARIED),small-s40-r1-$(firstword $(subst :, ,$(v))))
else ifeq ($(SET),handover)
# Beyond the text: the stress handed over at every conversion, beside the campaign's runs.
RUNS    := $(foreach s,$(SLIPS),small-s$(s)-r1 small-s$(s)-r1-handover)
else ifeq ($(SET),adaptive)
# Beyond the text: the soil decides which blocks are discs. Three to begin with hold the tyre's contact, 0.2 m.
VARIED  += $(addprefix adaptive:,elements.region=adaptive elements.first_disc_column=4 elements.disc_columns=3)
compared = $(addsuffix -$(1),discs $(2) small) small-$(1)-adaptive
RUNS    := $(foreach r,1 2 3 4 5 6 7 8,$(foreach s,0 10,$(call compared,s$(s)-r$(r),large))) \
           $(foreach r,1 2 3 4,$(call compared,s40-r$(r)))
else
# Upheaval with the text's count of discs: one a region.
# Whether the small region is as discs only at 40 %, in forces and in shear stress, is told by eight realisations.
MAIN    := $(foreach g,$(REGIONS),$(foreach s,$(SLIPS),$(g)-s$(s)-r1)) $(foreach g,small middle large,$(g)-s70-r1-discs1451) \
           $(foreach r,2 3 4 5 6 7 8,$(foreach g,small discs,$(g)-s40-r$(r)))
# Whether results approach those of discs only as the region grows is a matter of a few newtons: eight realisations at 0 and 10 %.
MORE    := $(foreach r,2 3 4 5 6 7 8,$(foreach g,small large discs,$(foreach s,0 10,$(g)-s$(s)-r$(r))))
RUNS    ?= $(if $(filter more,$(SET)),$(MORE),$(MAIN))
endif

.PHONY: reproduce more runs report quick sensitivity table handover handover-table adaptive adaptive-table

reproduce:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs
	@$(MAKE) --no-print-directory -f $(SWEEP) report

more:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs SET=more
	@$(MAKE) --no-print-directory -f $(SWEEP) report

runs: sweep

include reproductions/chapter3/sweep.mk

part = $(word $(2),$(subst -, ,$(1)))
case_of = $(CHAPTER)/cases/$(call part,$(1),1).toml
set_of = $(patsubst $(1):%,--set %,$(filter $(1):%,$(VARIED)))
sets_of = --set bed.seed=$(patsubst r%,%,$(call part,$(1),3)) $(call set_of,$(call part,$(1),4))
slip_of = --set travel.slip_percent=$(patsubst s%,%,$(call part,$(1),2))
# Variants differ in what their beds are made of: each has its own.
sunk_of = $(call part,$(1),1)-s-$(call part,$(1),3)$(addprefix -,$(call part,$(1),4))

SUNK := $(sort $(foreach r,$(RUNS),$(call sunk_of,$(r))))
$(foreach s,$(SUNK),$(eval $(call bed_rule,bed-$(s),$(call case_of,$(s)),$(call sets_of,$(s)))))
$(foreach s,$(SUNK),$(eval $(call sunk_rule,$(s),$(call case_of,$(s)),$(call sets_of,$(s)),bed-$(s))))
$(foreach r,$(RUNS),$(eval $(call travel_rule,$(r),$(call case_of,$(r)),$(call sets_of,$(r)) $(call slip_of,$(r)),$(call sunk_of,$(r)))))

DOUBT := $(CHAPTER)/cases/small.toml --set travel.slip_percent=40

travels: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS))) $(OUT)/confined/measurements.csv

LAST_FILES += $(OUT)/confined/measurements.csv
$(OUT)/confined/measurements.csv: $(INPUTS)
	@exec > $(OUT)/logs/confined.log 2>&1; exec $(IFEDEM) confined $(CHAPTER)/cases/small.toml -o $(OUT)/confined

# Of `more` what there is.
report: $(INPUTS)
	@$(CHAPTER)/measure/measure.sh $(IFEDEM) $(OUT)/measured $(fresh_runs) $(call fresh,$(MORE))
	@$(IFEDEM) report $(CHAPTER)/claims.csv $(OUT)/measured $(OUT)/confined $(doubted) -o $(REPORT) \
	  --title "Chapter 5: soil that changes between elements and discs" --command "$(COMMAND)"
	@$(keep_doubt)
	@cp $(OUT)/measured/runs.csv $(OUT)/measured/measurements.csv $(REPORT)/
	@echo "report: $(REPORT)/index.html"
	@$(IFEDEM) check $(CHAPTER)/claims.csv $(OUT)/measured $(OUT)/confined -o $(REPORT)/checks.csv
	@set -- $(fresh_runs); [ $$# = $(words $(RUNS)) ] || { echo "$$(( $(words $(RUNS)) - $$# )) of $(words $(RUNS)) runs are missing"; exit 1; }

sensitivity:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs SET=sensitivity
	@$(MAKE) --no-print-directory -f $(SWEEP) table SET=sensitivity

# Means over the last 0.3 m, the campaign's run first: what, the change, the values and their differences from that run.
table: $(INPUTS)
	@mkdir -p $(REPORT)
	@$(CHAPTER)/measure/measure.sh $(IFEDEM) $(OUT)/sensitivity $(fresh_runs)
	@awk -F, -v varied="$(VARIED)" -f $(CHAPTER)/measure/differences.awk $(OUT)/sensitivity/runs.csv > $(REPORT)/sensitivity.csv
	@cat $(REPORT)/sensitivity.csv
	@set -- $(fresh_runs); [ $$# = $(words $(RUNS)) ] || { echo "$$(( $(words $(RUNS)) - $$# )) of $(words $(RUNS)) runs are missing"; exit 1; }

handover:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs SET=handover
	@$(MAKE) --no-print-directory -f $(SWEEP) handover-table SET=handover

handover-table: $(INPUTS)
	@mkdir -p $(REPORT)
	@$(CHAPTER)/measure/measure.sh $(IFEDEM) $(OUT)/handover $(fresh_runs)
	@awk -f $(CHAPTER)/measure/handover.awk $(OUT)/handover/runs.csv $(OUT)/handover/epochs.csv > $(REPORT)/handover.csv
	@cat $(REPORT)/handover.csv

adaptive:
	-@$(MAKE) --no-print-directory -f $(SWEEP) runs SET=adaptive
	@$(MAKE) --no-print-directory -f $(SWEEP) adaptive-table SET=adaptive

adaptive-table: $(INPUTS)
	@mkdir -p $(REPORT)
	@$(CHAPTER)/measure/measure.sh $(IFEDEM) $(OUT)/adaptive $(fresh_runs)
	@awk -f $(CHAPTER)/measure/adaptive.awk $(OUT)/adaptive/runs.csv > $(REPORT)/adaptive.csv
	@cat $(REPORT)/adaptive.csv

# The machinery, not the numbers: one block of confined compression and a short travel with a conversion.
QUICK := build/runs/quick5
quick:
	@mkdir -p $(QUICK)
	@$(IFEDEM) confined $(CHAPTER)/cases/small.toml -o $(QUICK)/confined
	@$(IFEDEM) run $(CHAPTER)/cases/short.toml -o $(QUICK)/small-s40-r1 --force --quiet
	@$(CHAPTER)/measure/measure.sh $(IFEDEM) $(QUICK)/measured $(QUICK)/small-s40-r1
	@$(IFEDEM) report $(CHAPTER)/claims.csv $(QUICK)/measured $(QUICK)/confined \
	  -o build/reports/quick5 --title "Chapter 5, quick: the machinery, not the numbers" --command "make quick-chapter5"
	@echo "report: build/reports/quick5/index.html"
