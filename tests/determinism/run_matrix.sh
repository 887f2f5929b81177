#!/bin/sh
# One hash for the release build and compiler:level pairs (arguments, such as g++:O3), one and two threads, every vector width of this processor. Prints a table; exit 1 on
# a difference. A width that the processor lacks is "not run" and counted apart.
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
out=$root/build/matrix
mkdir -p "$out"
jobs=${JOBS:-$(nproc)}
case_file=$root/reproductions/chapter3/cases/short.toml
# A tenth of the short case: -O0 is slow.
less="--set stages.consolidation_s=0.12 --set stages.sinkage_s=0.04 --set travel.distance_m=0.004 --set travel.acceleration_time_s=0.02"
reference= passed=0 failed=0 not_run=0

run() { # label program threads width
    if [ "$4" = 8 ] && ! grep -q avx512f /proc/cpuinfo || [ "$4" = 4 ] && ! grep -q avx2 /proc/cpuinfo; then
        printf '%-28s %s\n' "$1" "not run: the processor lacks this width"; not_run=$((not_run + 1)); return
    fi
    rm -rf "$out/run" "$out/stages"
    # shellcheck disable=SC2086
    hash=$(IFEDEM_VECTOR_WIDTH=$4 "$2" run "$case_file" -o "$out/run" --stages "$out/stages" --quiet --threads "$3" $less |
        sed -n 's/^state-hash: //p')
    [ -n "$reference" ] || reference=$hash
    if [ -n "$hash" ] && [ "$hash" = "$reference" ]; then
        printf '%-28s %s\n' "$1" "$hash"; passed=$((passed + 1))
    else
        printf '%-28s %s differs from %s\n' "$1" "${hash:-no hash}" "$reference"; failed=$((failed + 1))
    fi
}

run "release t1 widest" "$root/build/ifedem" 1 "$(grep -q avx512f /proc/cpuinfo && echo 8 || echo 2)"
for pair in "$@"; do
    compiler=${pair%:*} level=${pair#*:} build=$out/$compiler-$level
    cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS_RELEASE="-$level" > "$build.log" 2>&1 &&
        cmake --build "$build" --target ifedem -j "$jobs" >> "$build.log" 2>&1 ||
        { echo "$compiler -$level does not build; see $build.log"; tail -5 "$build.log"; failed=$((failed + 1)); continue; }
    run "$compiler -$level t1 w2" "$build/ifedem" 1 2
    run "$compiler -$level t2 w8" "$build/ifedem" 2 8
    [ "$level" = O3 ] || continue
    run "$compiler -$level t1 w1" "$build/ifedem" 1 1
    run "$compiler -$level t1 w4" "$build/ifedem" 1 4
    run "$compiler -$level t1 w8" "$build/ifedem" 1 8
    GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F
    export GLIBC_TUNABLES
    run "$compiler -$level t1 w2 old glibc" "$build/ifedem" 1 2
    unset GLIBC_TUNABLES
done
echo "$passed equal, $failed different, $not_run not run"
[ "$failed" = 0 ]
