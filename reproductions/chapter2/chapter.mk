# Chapter 2 as a graph of files: measurements and runs → checks → report. Included from the top level's directory:
#   make -f reproductions/chapter2/chapter.mk reproduce
# A topic is measured again when the program that measures it has been rebuilt.

CHAPTER := reproductions/chapter2
QUICK   ?=
IFEDEM  ?= build/ifedem
JOBS    ?= $(shell nproc)
OUT     := build/runs/$(if $(QUICK),quick2,chapter2)
REPORT  := build/reports/$(if $(QUICK),quick2,chapter2)
VERIFY  := build/chapter2_verify
COMMAND ?= make $(if $(QUICK),quick,reproduce)-chapter2

# The longest first, so that both cores end together. CalculiX and the travels only in full.
TOPICS  := heap sand footing silo packing traction contact elements integration $(if $(QUICK),,calculix)
ALL     := $(TOPICS) $(if $(QUICK),,travels)
DONE    := $(addprefix $(OUT)/,$(addsuffix /measurements.csv,$(TOPICS)))

# The maps of where methods fail: targets limits and limits-quick, results in the folder limits beside the topics.
LIMITS  := $(wildcard $(CHAPTER)/limits/limits.mk)
include $(LIMITS)
LIMITS_OUT := $(if $(LIMITS),$(OUT)/limits)

.PHONY: reproduce quick measure travels calculix-package report
.SECONDARY:

# Whatever fails, the rest is done and the report is written; its check then fails.
reproduce: $(if $(QUICK),,calculix-package)
	@cmake --build build --target chapter2_verify -j $(JOBS)
	-@$(MAKE) --no-print-directory -k -j$(JOBS) -f $(CHAPTER)/chapter.mk measure
	$(if $(QUICK),,-@$(MAKE) --no-print-directory -f $(CHAPTER)/chapter.mk travels)
	@$(MAKE) --no-print-directory -f $(CHAPTER)/chapter.mk report

quick:
	@$(MAKE) --no-print-directory -f $(CHAPTER)/chapter.mk QUICK=1 reproduce

measure: $(DONE) $(if $(LIMITS),$(if $(QUICK),limits-quick,limits))

$(OUT)/%/measurements.csv: $(VERIFY)
	@mkdir -p $(OUT)/$*
	@$(VERIFY) $* -o $(OUT)/$* $(if $(QUICK),--quick) > $(OUT)/$*/log.txt

travels:
	@$(MAKE) --no-print-directory -f $(CHAPTER)/travel.mk sweep
	@mkdir -p $(OUT)/travels
	@$(VERIFY) --travels $(OUT)/travel -o $(OUT)/travels > $(OUT)/travels/log.txt

calculix-package:
	@command -v ccx > /dev/null || { s=$$([ "$$(id -u)" = 0 ] || echo sudo); $$s apt-get update -qq && \
	  $$s env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends calculix-ccx; }

# Claims of both halves are judged together, so they and the figures are gathered in one folder first; the program reads
# the claims of a folder below, too.
JUDGED := $(OUT)/judged
DIRS   := $(addprefix $(OUT)/,$(ALL)) $(LIMITS_OUT)
report:
	@rm -rf $(JUDGED) && mkdir -p $(JUDGED) && cp $(CHAPTER)/*.gp $(CHAPTER)/*.csv $(JUDGED)
	@[ ! -d $(CHAPTER)/limits ] || cp -r $(CHAPTER)/limits $(JUDGED)
	@$(IFEDEM) report $(JUDGED)/claims.csv $(DIRS) -o $(REPORT) \
	  --title "Chapter 2: the formulation verified, and where each method fails" --command "$(COMMAND)"
	@echo "report: $(REPORT)/index.html"
	@$(if $(QUICK),,$(IFEDEM) check $(JUDGED)/claims.csv $(DIRS) -o $(REPORT)/checks.csv)
