#!/bin/bash
# run_threads.sh BUILD: the tiny case on a bed of three blocks with 1 and with 3 threads. Fails on a race or on another hash.
set -eu
build=$1
for threads in 1 3; do
    TSAN_OPTIONS=halt_on_error=1 "$build"/ifedem run tests/reliability/tiny.toml -o "$build/run$threads" --stages "$build/stages$threads" \
        --set bed.disc_count=2500 --set bed.length_m=2 --set stages.consolidation_s=0.3 --set stages.sinkage_s=0.02 \
        --threads $threads --force --quiet | grep state-hash > "$build/hash$threads"
done
cmp "$build/hash1" "$build/hash3" && echo "threads: no race reported, one hash, $(cat "$build/hash3")"
