# Rules of a sweep: bed → sunk wheel → travel. The includer sets OUT and RUNS and evaluates bed_rule, sunk_rule and
# travel_rule for its files. Finished work is repeated only when the text of a case or the results version changes;
# a travel that was interrupted goes on from its checkpoint.
#   $(OUT)/inputs.txt     all that the runs depend on
#   $(OUT)/ready/NAME     an empty file: this bed or sunk wheel is in the stage cache
#   $(OUT)/NAME/run.csv   a finished travel; an includer whose runs may be stopped by a health check writes NAME/ended for both
#   $(OUT)/logs/NAME.log  what the program said on its error stream
# ENGINE=slurm or parallel makes the same files on other machines (engines/README.md).

include $(dir $(lastword $(MAKEFILE_LIST)))../engines/engine.mk
include $(CHAPTER)/realisations.mk
IFEDEM ?= build/ifedem
JOBS   ?= $(shell nproc)
STAGES ?= build/stages
CASES  := $(filter-out %/short.toml,$(wildcard $(CHAPTER)/cases/*.toml))
INPUTS := $(OUT)/inputs.txt

.SECONDARY:
.PHONY: sweep travels doubt FORCE

# Renewed only when its text changes, so that rebuilding the program or touching a case does not repeat the sweep. Tasks share
# the file and only compare: a machine that has another program must not repeat the sweep of all.
inputs_text = { $(IFEDEM) --version | sed 's/.*results version \([0-9]*\).*/results version \1/'; cat $(CASES); }
refuse_task = { echo "$$(hostname): $(INPUTS) does not fit (program or cases are others here). Share one directory?"; exit 1; }
$(INPUTS): FORCE
	@mkdir -p $(OUT)/ready $(OUT)/logs
	@$(inputs_text) | cmp -s - $@ || $(if $(TASK),$(refuse_task),{ $(inputs_text) > $@.new && mv $@.new $@; })

# Of two tasks that need the same bed or sunk wheel one makes it, the other waits for it and finds it in the stage cache.
lock = exec flock --no-fork $(OUT)/ready/$(1).lock

# NAME, case file, --set arguments. The recipes become the program by exec, so that a signal to make reaches it.
define bed_rule
BED_FILES += $(OUT)/ready/$(1)
$(OUT)/ready/$(1): $(INPUTS)
	@$(lock) $(IFEDEM) prepare --bed $(2) $(3) --stages $(STAGES) --quiet > /dev/null 2> $(OUT)/logs/$(1).log
	@touch $$@
endef

# NAME, case file, --set arguments, NAME of the bed
define sunk_rule
SUNK_FILES += $(OUT)/ready/$(1)
$(OUT)/ready/$(1): $(INPUTS) | $(OUT)/ready/$(4)
	@$(lock) $(IFEDEM) prepare $(2) $(3) --stages $(STAGES) --quiet > /dev/null 2> $(OUT)/logs/$(1).log
	@touch $$@
endef

# NAME, case file, --set arguments, NAME of the sunk wheel
define travel_rule
LAST_FILES += $(OUT)/$(1)/run.csv
$(OUT)/$(1)/run.csv: $(INPUTS) | $(OUT)/ready/$(4)
	@exec > /dev/null 2> $(OUT)/logs/$(1).log; \
	if [ $(OUT)/$(1)/checkpoint.h5 -nt $(INPUTS) ]; then exec $(IFEDEM) resume $(OUT)/$(1) --stages $(STAGES) --quiet; \
	else exec $(IFEDEM) run $(2) -o $(OUT)/$(1) --force --quiet --stages $(STAGES) $(3); fi
endef

# Those of the runs that are done, as directories; what failed is not among them, nor what an older program left.
fresh = $$(for r in $(1); do [ $(OUT)/$$r/run.csv -nt $(INPUTS) ] && echo $(OUT)/$$r; done)
fresh_runs = $(call fresh,$(RUNS))

# DOUBT: case, condition and options. What moves with twice its size and fineness; the report has the table.
doubt: $(INPUTS)
	@$(IFEDEM) doubt $(DOUBT) --jobs $(JOBS) --stages $(STAGES) -o $(OUT)/doubt
keep_doubt = $(if $(doubted),cp $(doubted)/doubt.csv $(REPORT)/,:)
doubted = $(patsubst %/doubt.csv,%,$(wildcard $(OUT)/doubt/doubt.csv))

# All travels, whatever fails; then the list of what did. Both the engine and the watcher run beside the shell, so that it can
# stop them when it is stopped.
sweep: $(INPUTS)
	@$(missing_files) > $(OUT)/logs/missing.txt
	@$(launch_$(ENGINE)) & runs=$$!; \
	$(IFEDEM) watch $(addprefix $(OUT)/,$(RUNS)) & watcher=$$!; \
	trap 'kill $$runs $$watcher 2> /dev/null; wait; echo "stopped; the same command goes on"; exit 130' INT TERM; \
	wait $$runs; status=$$?; kill $$watcher 2> /dev/null; [ $$status != 5 ] || exit 5; \
	for r in $(RUNS); do [ $(OUT)/$$r/run.csv -nt $(INPUTS) ] || [ $(OUT)/$$r/ended -nt $(INPUTS) ] || { echo "failed: $$r (log: $(OUT)/logs/$$r.log)"; tail -n 2 $(OUT)/logs/$$r.log 2> /dev/null; }; done; \
	exit $$status
