# Rules for runs that a health check may stop, which is a result like another; beside sweep.mk, which the includer includes first.
#   $(OUT)/NAME/ended        done, or stopped by a health check: nothing repeats it while the inputs stay
#   $(OUT)/NAME/stopped.txt  the check's words

# Runs that ended, as directories.
ended_runs = $$(for r in $(RUNS); do [ $(OUT)/$$r/ended -nt $(INPUTS) ] && echo $(OUT)/$$r; done)

# Starts the program and passes on what stops make; `code` is its exit code. 3: a health check stopped it.
start = $(1) & child=$$$$!; trap "kill $$$$child; wait $$$$child; exit 143" INT TERM; wait $$$$child; code=$$$$?

# NAME, case file, --set arguments, --bed or nothing, prerequisites. What a health check stops here the travel meets again.
define try_prepare_rule
$(if $(4),BED_FILES,SUNK_FILES) += $(OUT)/ready/$(1)
$(OUT)/ready/$(1): $(INPUTS) $(5)
	@$(call start,$(lock) $(IFEDEM) prepare $(4) $(2) $(3) --stages $(STAGES) --quiet > /dev/null 2> $(OUT)/logs/$(1).log); \
	[ $$$$code = 0 ] || [ $$$$code = 3 ] && touch $$@
endef

# NAME, case file, --set arguments, NAME of the sunk wheel
define trial_rule
LAST_FILES += $(OUT)/$(1)/ended
$(OUT)/$(1)/ended: $(INPUTS) | $(OUT)/ready/$(4)
	@if [ $(OUT)/$(1)/checkpoint.h5 -nt $(INPUTS) ]; then set -- resume $(OUT)/$(1); \
	else set -- run $(2) -o $(OUT)/$(1) --force $(3); fi; \
	$(call start,$(IFEDEM) "$$$$@" --quiet --stages $(STAGES) > /dev/null 2> $(OUT)/logs/$(1).log); \
	[ $$$$code != 3 ] || { rm -f $(OUT)/$(1)/run.csv; sed 's/^$(1): //' $(OUT)/logs/$(1).log | tail -n 1 > $(OUT)/$(1)/stopped.txt; }; \
	[ $$$$code = 0 ] || [ $$$$code = 3 ] && touch $$@
endef
