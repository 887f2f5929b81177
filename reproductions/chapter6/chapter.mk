# Chapter 6: the closing claim from chapter 5's measurements, and all chapters' verdicts on one page.
CHAPTER := reproductions/chapter6
REPORT  := build/reports/chapter6
IFEDEM  ?= build/ifedem

.PHONY: reproduce quick
reproduce:
	@mkdir -p $(REPORT)
	@[ ! -d build/runs/chapter5/measured ] || $(IFEDEM) check $(CHAPTER)/claims.csv build/runs/chapter5/measured -o $(REPORT)/checks.csv || true
	@$(CHAPTER)/ledger.sh build/reports/chapter?/checks.csv > $(REPORT)/ledger.md
	@echo "ledger: $(REPORT)/ledger.md"

quick: reproduce
