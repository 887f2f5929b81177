# Who makes the files of a sweep (README.md): make on this machine, or tasks elsewhere that are `make FILE` each, so that
# the rules stay the only description of what depends on what. sweep.mk includes this.
#   ENGINE=make, slurm or parallel, HOSTS=file   chosen by the user
#   TASK=1                                       set in a task

ENGINE  ?= make
ENGINES := $(dir $(lastword $(MAKEFILE_LIST)))

# In the order of the graph: what a task needs is done, or being done, when it starts. The rules add to them; a chapter adds to
# LAST_FILES what it wants beside travels.
BED_FILES  :=
SUNK_FILES :=
LAST_FILES :=

missing_files = for f in $(BED_FILES) $(SUNK_FILES) $(LAST_FILES); do [ $$f -nt $(INPUTS) ] || echo $$f; done
task = $(MAKE) --no-print-directory -f $(SWEEP) TASK=1 IFEDEM=$(IFEDEM) STAGES=$(STAGES) $(MAKEOVERRIDES)

# Each makes the files of $(OUT)/logs/missing.txt and ends with 0, with 5 if it could not even begin, or else with another code.
launch_make     = $(MAKE) --no-print-directory -k -j$(JOBS) -f $(SWEEP) travels > $(OUT)/logs/make.log 2>&1
launch_slurm    = $(ENGINES)slurm.sh $(OUT)/logs $(task)
launch_parallel = $(ENGINES)parallel.sh $(HOSTS) $(OUT)/logs $(task)

# A task's machine need not be able to start others.
ifndef TASK
ifeq ($(filter make slurm parallel,$(ENGINE)),)
$(error ENGINE=$(ENGINE) is not known (there are make, slurm and parallel). Choose one of them)
endif
ifeq ($(ENGINE)$(shell command -v sbatch),slurm)
$(error sbatch is not found (ENGINE=slurm submits to a Slurm cluster). Install slurm-client, or call make where jobs are submitted)
endif
ifeq ($(ENGINE),parallel)
ifeq ($(shell parallel --version 2> /dev/null | grep GNU),)
$(error GNU parallel is not found (ENGINE=parallel starts runs with it). Install the package parallel)
endif
ifeq ($(wildcard $(HOSTS)),)
$(error HOSTS=$(HOSTS) is no file (ENGINE=parallel reads the machines from it). Write one with a line a machine, like 8/node1 for eight cores; : is this one)
endif
endif
endif
