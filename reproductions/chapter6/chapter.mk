# Chapter 6 simulates nothing: the closing claim from chapter 5's measurements, and every statement of the text on one page.
#   make -f reproductions/chapter6/chapter.mk reproduce    build/reports/, from what this machine has computed, else from reports/
#   make -f reproductions/chapter6/chapter.mk front-page   reports/, from reports/ alone
CHAPTER  := reproductions/chapter6
PAGE     := build/reports
IFEDEM   ?= build/ifedem
CHAPTERS := 2 3 4 5

# The first that is there.
first = $(firstword $(wildcard $(1)))
report_of = $(patsubst %/checks.csv,%,$(call first,$(if $(COMMITTED),,build/reports/chapter$(1)/checks.csv) reports/chapter$(1)/checks.csv))
# Chapter 5 as run, or as committed.
MEASURED := $(patsubst %/measurements.csv,%,$(call first,$(if $(COMMITTED),,build/runs/chapter5/measured/measurements.csv) reports/chapter5/measurements.csv))

.PHONY: reproduce quick front-page page
reproduce quick:
	@$(MAKE) --no-print-directory -f $(CHAPTER)/chapter.mk page

front-page:
	@$(MAKE) --no-print-directory -f $(CHAPTER)/chapter.mk page COMMITTED=1 PAGE=reports

page: $(if $(MEASURED),$(PAGE)/chapter6/checks.csv)
	@$(IFEDEM) ledger $(CHAPTER)/conclusions.csv $(foreach c,$(CHAPTERS),$(call report_of,$(c))) \
	  $(if $(MEASURED),$(PAGE)/chapter6,$(call report_of,6)) -o $(PAGE)
	@echo "page: $(PAGE)/index.html"

.PHONY: $(PAGE)/chapter6/checks.csv
$(PAGE)/chapter6/checks.csv:
	-@$(IFEDEM) check $(CHAPTER)/claims.csv $(MEASURED) -o $@
