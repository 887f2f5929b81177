# The front door: every target sets up what it needs (packages by apt, program by CMake) and then does its work.
# `make help` lists them. JOBS=n limits the cores; a sweep uses one core a case, since cases are independent.

# compiler:level pairs of test-determinism
MATRIX    ?= clang++:O0 clang++:O2 clang++:O3 g++:O0 g++:O2 g++:O3
JOBS      ?= $(shell nproc)
FUZZ_SECONDS ?= 1800
BUILD     := build
CXX_FAST  := clang++
IFEDEM    := $(BUILD)/ifedem
PACKAGES  := clang clang-format cmake ninja-build g++ gnuplot-nox libomp-dev libeigen3-dev libgsl-dev libhdf5-dev libgtest-dev \
             libfmt-dev libcli11-dev libtomlplusplus-dev libclang-rt-14-dev fonts-dejavu-core pkg-config
PEERS     := lammps liggghts yade
SUDO      := $(shell [ "$$(id -u)" = 0 ] || echo sudo)

export JOBS IFEDEM

# Debian packages that are missing; of a target that needs more than the build.
define install
missing=; for p in $(1); do dpkg -s $$p > /dev/null 2>&1 || missing="$$missing $$p"; done; \
[ -z "$$missing" ] || { echo "installing$$missing"; $(SUDO) apt-get update -qq && \
  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $$missing; }
endef

.PHONY: help setup build test test-determinism bench bench-peers speed-accuracy speed-accuracy-plan quick-speed-accuracy causes-chapter3 verify-reports check sanitize sanitize-unit clean
.DEFAULT_GOAL := help

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z][a-z0-9% -]*:.*## / { sub(/%/, "N", $$1); printf "%-22s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

setup: $(BUILD)/.packages ## install Debian packages that are missing

$(BUILD)/.packages: Makefile
	@mkdir -p $(BUILD)
	@$(call install,$(PACKAGES))
	@touch $@

build: $(BUILD)/.packages ## configure and compile the program
	@[ -f $(BUILD)/build.ninja ] || cmake -S . -B $(BUILD) -G Ninja -DCMAKE_CXX_COMPILER=$(CXX_FAST)
	@cmake --build $(BUILD) --target ifedem -j $(JOBS)

test: build ## unit, verification, stability, determinism and reliability tests
	@cmake --build $(BUILD) -j $(JOBS)
	@ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

test-determinism: build ## one hash for compilers, optimisation levels, threads and vector widths
	@tests/determinism/run_matrix.sh $(MATRIX)

.PHONY: test-all test-reliability test-privileged test-tsan fuzz check-pages check-paraview front-page docs check-format tidy
# Each in turn, all of them whatever fails, and one line a part at the end.
ALL_TESTS := test tidy test-determinism test-reliability test-privileged sanitize test-tsan fuzz quick-chapter2 quick-chapter3 quick-chapter4 quick-chapter5 quick-chapter6 quick-speed-accuracy verify-reports check-pages check-paraview
test-all: ## everything that can be tested, in two hours or so: what CI leaves out too
	@failed=; for t in $(ALL_TESTS); do $(MAKE) --no-print-directory $$t || failed="$$failed $$t"; done; \
	for t in $(ALL_TESTS); do case " $$failed " in *" $$t "*) echo "FAILED  $$t";; *) echo "passed  $$t";; esac; done; [ -z "$$failed" ]

test-reliability: build ## kill, stop, damage, fill: build/reliability.csv (ten minutes)
	@cmake --build $(BUILD) --target tests_reliability -j $(JOBS)
	@echo "fault,tried,survived" > $(BUILD)/reliability.csv
	@IFEDEM_RELIABILITY_CSV=$(BUILD)/reliability.csv $(BUILD)/tests/faults_test --gtest_brief=1 --gtest_filter=-*Privileged*
	@IFEDEM_RELIABILITY_CSV=$(BUILD)/reliability.csv $(BUILD)/tests/bad_input_test --gtest_brief=1
	@cat $(BUILD)/reliability.csv

test-privileged: build ## what only root may do: full disks, sweeps on a cluster that loses a node (installs slurm-wlm, parallel, sshd)
	@cmake --build $(BUILD) --target faults_test -j $(JOBS)
	@tests/privileged.sh $(BUILD)

test-tsan: $(BUILD)/.packages ## threads under ThreadSanitizer: a test of the soil's elements, and a run of three threads with one thread's hash
	@cmake -S . -B $(BUILD)-tsan -G Ninja -DCMAKE_CXX_COMPILER=$(CXX_FAST) -DIFEDEM_TSAN=ON -DCMAKE_CXX_FLAGS_RELEASE=-O1 > /dev/null
	@cmake --build $(BUILD)-tsan -j $(JOBS) --target ifedem soil_elements_test
	@TSAN_OPTIONS=halt_on_error=1 $(BUILD)-tsan/tests/soil_elements_test --gtest_brief=1 --gtest_filter=*threads*
	@tests/tsan/run_threads.sh $(BUILD)-tsan

fuzz: build ## case reader, mesh reader and checkpoint decoder, FUZZ_SECONDS each: build/fuzz.csv
	@cmake -S . -B $(BUILD)-fuzz -G Ninja -DCMAKE_CXX_COMPILER=$(CXX_FAST) -DIFEDEM_FUZZ=ON -DCMAKE_CXX_FLAGS_RELEASE=-O2 > /dev/null
	@cmake --build $(BUILD)-fuzz -j $(JOBS) --target case_fuzzer mesh_fuzzer checkpoint_fuzzer
	@tests/fuzz/run_fuzzers.sh $(FUZZ_SECONDS)

bench: build ## cost of a step on dense beds (idle machine): build/bench.csv
	@cmake --build $(BUILD) --target step_bench -j $(JOBS)
	@tests/bench/run_bench.sh

bench-peers: build ## ifedem against LAMMPS, LIGGGHTS and YADE (idle machine): build/bench-peers.csv
	@$(call install,$(PEERS))
	@cmake --build $(BUILD) --target step_bench -j $(JOBS)
	@tests/bench/peers/run_peers.sh

sanitize sanitize-unit: $(BUILD)/.packages ## tests (all, or the unit tests) under AddressSanitizer and UndefinedBehaviorSanitizer
	@cmake -S . -B $(BUILD)-sanitize -G Ninja -DCMAKE_CXX_COMPILER=$(CXX_FAST) -DIFEDEM_SANITIZE=ON -DCMAKE_CXX_FLAGS_RELEASE=-O1 > /dev/null
	@cmake --build $(BUILD)-sanitize -j $(JOBS) --target $(if $(filter sanitize-unit,$@),tests_unit,all)
	@LSAN_OPTIONS=suppressions=$(CURDIR)/tests/lsan.supp:print_suppressions=0 ctest --test-dir $(BUILD)-sanitize --output-on-failure -j $(JOBS) $(if $(filter sanitize-unit,$@),-L unit)

# FIDELITY=dissertation CASE=B3-earth-170N-s60-r1 THREADS=n: one run of chapter 3 with the text's own step
reproduce-chapter%: build ## simulate, check and report a chapter: reproduce-chapter3 (ENGINE=slurm, or parallel HOSTS=file: on other machines)
	@$(MAKE) --no-print-directory -f reproductions/chapter$*/chapter.mk reproduce

quick-chapter%: build ## the same machinery on short runs, under two minutes
	@$(MAKE) --no-print-directory -f reproductions/chapter$*/chapter.mk quick

sensitivity-chapter%: build ## chapters 3, 4, 5: what each choice that the text leaves open does to the results
	@$(MAKE) --no-print-directory -f reproductions/chapter$*/chapter.mk sensitivity

doubt-chapter%: build ## chapters 3, 4, 5: what moves in the case with twice its size and fineness, or half its step
	@$(MAKE) --no-print-directory -f reproductions/chapter$*/chapter.mk doubt

SPEED = $(MAKE) --no-print-directory -f reproductions/speed_accuracy/speed.mk
SPEED_CHAPTERS := $(or $(CHAPTER),3 4 5)
speed-accuracy: build ## charts of cost against error, CHAPTER=3, 4, 5 or all (an hour of CPU each, resumable): build/reports/speed_accuracy/
	@for n in $(SPEED_CHAPTERS); do $(SPEED) N=$$n speed-accuracy || exit 1; done
	@$(SPEED) N=$(firstword $(SPEED_CHAPTERS)) guide

speed-accuracy-plan: build ## what of it is to be made, and its CPU time
	@for n in $(SPEED_CHAPTERS); do $(SPEED) N=$$n plan || exit 1; done

quick-speed-accuracy: build ## the same machinery on small bins, under three minutes
	@for n in $(SPEED_CHAPTERS); do $(SPEED) N=$$n QUICK=1 speed-accuracy || exit 1; done
	@$(SPEED) N=$(firstword $(SPEED_CHAPTERS)) QUICK=1 guide

causes-chapter3: build ## the runs behind "Causes" in chapter 3's README
	@$(MAKE) --no-print-directory -j$(JOBS) -f reproductions/chapter3/causes.mk causes

# QUICK=1: the quick runs alone. NAMES="run ...": these. Else three runs of each report, drawn with SEED.
SEED ?= $(shell date +%s)
verify-reports: build ## rerun some runs of the committed reports from nothing and compare hashes
	@reports/verify.sh $(if $(QUICK),quick,$(if $(NAMES),runs $(NAMES),draw 3 $(SEED)))

check-pages: ## reports in headless Chromium at the width of a phone and a desk (installs chromium)
	@$(call install,chromium)
	@tests/pages/check_pages.sh $(wildcard reports/index.html reports/*/index.html $(BUILD)/reports/index.html $(BUILD)/reports/*/index.html)

check-paraview: build ## a run's discs.xdmf and wheel.xdmf as ParaView reads them, without a screen (installs paraview)
	@$(call install,paraview python3-paraview python3-h5py)
	@tests/paraview/check_paraview.sh $(BUILD)

front-page: build ## reports/index.html and README.md from the committed reports, after a chapter's was renewed
	@$(MAKE) --no-print-directory -f reproductions/chapter6/chapter.mk front-page

docs: ## the library's documentation by Doxygen: build/docs/html/index.html
	@$(call install,doxygen)
	@mkdir -p $(BUILD)/docs && doxygen lib/Doxyfile

check-format: $(BUILD)/.packages ## clang-format over all code
	@find lib tests reproductions -name '*.?pp' | xargs clang-format --dry-run -Werror

tidy: build check-format ## that, and clang-tidy over the library (six to eight minutes on two cores)
	@$(call install,clang-tidy)
	@ls lib/*/*.cpp | xargs -P $(JOBS) -I{} clang-tidy -p $(BUILD) --quiet {} 2> /dev/null

check: check-format ## what a contributor runs before a commit: format, tests
	@$(MAKE) --no-print-directory test

clean: ## remove everything that was built or simulated
	rm -rf $(BUILD) $(BUILD)-sanitize $(BUILD)-fuzz $(BUILD)-tsan
