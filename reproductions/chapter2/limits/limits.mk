# Maps of where methods fail, into build/runs/chapter2/limits (limits-quick: build/runs/quick2/limits). From the top level's directory, after `make build`:
#   make -f reproductions/chapter2/limits/limits.mk limits
JOBS        ?= $(shell nproc)
MAPS_OUT     = build/runs/$(if $(filter limits-quick,$@),quick2,chapter2)/limits
MAPS_TOPICS := scenes control elements contacts rolling coupling cost

.PHONY: limits limits-quick

limits limits-quick:
	@cmake --build build --target chapter2_limits -j $(JOBS) > /dev/null
	@mkdir -p $(MAPS_OUT)
	@printf '%s\n' $(MAPS_TOPICS) | xargs -P $(JOBS) -I{} build/chapter2_limits {} -o $(MAPS_OUT) $(if $(filter limits-quick,$@),--quick)
	@{ echo name,value,units,scatter,n,note; cat $(patsubst %,$(MAPS_OUT)/measured-%.csv,$(MAPS_TOPICS)); } > $(MAPS_OUT)/measurements.csv
