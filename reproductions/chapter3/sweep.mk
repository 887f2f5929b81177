# Rules of a sweep: bed → sunk wheel → travel. The includer sets OUT and RUNS and evaluates bed_rule, sunk_rule and
# travel_rule for its files. Finished work is repeated only when the text of a case or the results version changes;
# a travel that was interrupted goes on from its checkpoint.
#   $(OUT)/inputs.txt     all that the runs depend on
#   $(OUT)/ready/NAME     an empty file: this bed or sunk wheel is in the stage cache
#   $(OUT)/NAME/run.csv   a finished travel; an includer whose runs may be stopped by a health check writes NAME/ended for both
#   $(OUT)/logs/NAME.log  what the program said on its error stream

include $(CHAPTER)/realisations.mk
IFEDEM ?= build/ifedem
JOBS   ?= $(shell nproc)
STAGES ?= build/stages
CASES  := $(filter-out %/short.toml,$(wildcard $(CHAPTER)/cases/*.toml))
INPUTS := $(OUT)/inputs.txt

.SECONDARY:
.PHONY: sweep travels FORCE

# Renewed only when its text changes, so that rebuilding the program or touching a case does not repeat the sweep.
$(INPUTS): FORCE
	@mkdir -p $(OUT)/ready $(OUT)/logs
	@{ $(IFEDEM) --version | sed 's/.*results version \([0-9]*\).*/results version \1/'; cat $(CASES); } > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# NAME, case file, --set arguments. The recipes become the program by exec, so that a signal to make reaches it.
define bed_rule
$(OUT)/ready/$(1): $(INPUTS)
	@$(IFEDEM) prepare --bed $(2) $(3) --stages $(STAGES) --quiet > /dev/null 2> $(OUT)/logs/$(1).log && touch $$@
endef

# NAME, case file, --set arguments, NAME of the bed
define sunk_rule
$(OUT)/ready/$(1): $(INPUTS) | $(OUT)/ready/$(4)
	@$(IFEDEM) prepare $(2) $(3) --stages $(STAGES) --quiet > /dev/null 2> $(OUT)/logs/$(1).log && touch $$@
endef

# NAME, case file, --set arguments, NAME of the sunk wheel
define travel_rule
$(OUT)/$(1)/run.csv: $(INPUTS) | $(OUT)/ready/$(4)
	@exec > /dev/null 2> $(OUT)/logs/$(1).log; \
	if [ $(OUT)/$(1)/checkpoint.h5 -nt $(INPUTS) ]; then exec $(IFEDEM) resume $(OUT)/$(1) --stages $(STAGES) --quiet; \
	else exec $(IFEDEM) run $(2) -o $(OUT)/$(1) --force --quiet --stages $(STAGES) $(3); fi
endef

# Runs that are done, as directories; what failed is not among them, nor what an older program left.
fresh_runs = $$(for r in $(RUNS); do [ $(OUT)/$$r/run.csv -nt $(INPUTS) ] && echo $(OUT)/$$r; done)

# All travels, whatever fails; then the list of what did. Both make and the watcher run beside the shell, so that it can
# stop them when it is stopped.
sweep: $(INPUTS)
	@$(MAKE) --no-print-directory -k -j$(JOBS) -f $(SWEEP) travels > $(OUT)/logs/make.log 2>&1 & runs=$$!; \
	$(IFEDEM) watch $(addprefix $(OUT)/,$(RUNS)) & watcher=$$!; \
	trap 'kill $$runs $$watcher 2> /dev/null; wait; echo "stopped; the same command goes on"; exit 130' INT TERM; \
	wait $$runs; status=$$?; kill $$watcher 2> /dev/null; \
	for r in $(RUNS); do [ $(OUT)/$$r/run.csv -nt $(INPUTS) ] || [ $(OUT)/$$r/ended -nt $(INPUTS) ] || { echo "failed: $$r (log: $(OUT)/logs/$$r.log)"; tail -n 2 $(OUT)/logs/$$r.log 2> /dev/null; }; done; \
	exit $$status
