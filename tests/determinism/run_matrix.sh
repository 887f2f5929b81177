#!/bin/bash
# One hash for compilers, optimisation levels, threads and vector widths. Arguments: compiler:level pairs, such as g++:O3; the release build
# is always there. A wheel on 2400 discs through all three stages, 20,000 steps (-O0: 2,000 steps, and 2,000 of travel on the release's sunk wheel). Prints a table; exit 1 on a difference, which is
# then traced to its first step, body and component. A width that the processor lacks is "not run" and counted apart.
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
out=$root/build/matrix
mkdir -p "$out"
jobs=${JOBS:-$(nproc)}
release=$root/build/ifedem
case_file=$root/reproductions/chapter3/cases/short.toml
long="--set stages.consolidation_s=0.16 --set stages.sinkage_s=0.12 --set travel.distance_m=0.042 --set travel.acceleration_time_s=0.2"
brief="--set health.least_contacts=0 --set stages.consolidation_s=0.04 --set stages.sinkage_s=0.02 --set travel.distance_m=0.001 --set travel.acceleration_time_s=0.02"
travel="--set stages.consolidation_s=0.16 --set stages.sinkage_s=0.12 --set travel.distance_m=0.006 --set travel.acceleration_time_s=0.04"
passed=0 failed=0 not_run=0
declare -A reference

has_width() {
    case $1 in
        8) grep -q avx512f /proc/cpuinfo && grep -q avx512dq /proc/cpuinfo && grep -q avx512vl /proc/cpuinfo ;;
        4) grep -q avx2 /proc/cpuinfo ;;
        *) true ;;
    esac
}
widest() { if has_width 8; then echo 8; elif has_width 4; then echo 4; else echo 2; fi; }

# The hash after a scene (or up to a step of it), in a directory of its own.
hash_of() { # directory program threads width scene [more...]
    local directory=$1 program=$2 threads=$3 width=$4 scene=$5 stages=$1-stages; shift 5
    rm -rf "$directory" "$stages"
    [ "$scene" = travel ] && stages=$out/shared-stages
    # shellcheck disable=SC2086
    IFEDEM_VECTOR_WIDTH=$width "$program" run "$case_file" -o "$directory" --stages "$stages" --quiet --threads "$threads" ${!scene} "$@" \
        2> "$directory.log" | sed -n 's/^state-hash: //p'
}

# The first step after which two programs differ, by halving; the shared stages are not looked into.
locate() { # program threads width scene steps
    local same=0 differs=$5
    [ "$4" != travel ] || same=7000
    while [ $((differs - same)) -gt 1 ]; do
        local at=$(((same + differs) / 2))
        if [ "$(hash_of "$out/a" "$release" 1 "$(widest)" "$4" --stop-at-step $at)" = "$(hash_of "$out/b" "$1" "$2" "$3" "$4" --stop-at-step $at)" ]
        then same=$at; else differs=$at; fi
    done
    hash_of "$out/a" "$release" 1 "$(widest)" "$4" --stop-at-step "$differs" > /dev/null
    hash_of "$out/b" "$1" "$2" "$3" "$4" --stop-at-step "$differs" > /dev/null
    printf '    first difference: '
    "$release" compare "$out/a/checkpoint.h5" "$out/b/checkpoint.h5"
}

check() { # label program threads width scene-name
    local hash
    if ! has_width "$4"; then
        printf '%-34s %s\n' "$1" "not run: the processor lacks this width"; not_run=$((not_run + 1)); return
    fi
    hash=$(hash_of "$out/run" "$2" "$3" "$4" "$5")
    [ -n "${reference[$5]:-}" ] || reference[$5]=$hash
    if [ -n "$hash" ] && [ "$hash" = "${reference[$5]}" ]; then
        printf '%-34s %-6s %s\n' "$1" "$5" "$hash"; passed=$((passed + 1))
    else
        printf '%-34s %-6s %s differs from %s\n' "$1" "$5" "${hash:-no hash}" "${reference[$5]}"; failed=$((failed + 1))
        [ -z "$hash" ] || locate "$2" "$3" "$4" "$5" "$(sed -n 's/^total_steps,\([0-9]*\),.*/\1/p' "$out/run/run.csv")"
    fi
}

check "release t1 w$(widest)" "$release" 1 "$(widest)" long
check "release t1 w$(widest)" "$release" 1 "$(widest)" brief
rm -rf "$out/shared-stages"
check "release t1 w$(widest)" "$release" 1 "$(widest)" travel
for pair in "$@"; do
    compiler=${pair%:*} level=${pair#*:} build=$out/$compiler-$level
    cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS_RELEASE="-$level" > "$build.log" 2>&1 &&
        cmake --build "$build" --target ifedem -j "$jobs" >> "$build.log" 2>&1 ||
        { echo "$compiler -$level does not build; see $build.log"; tail -5 "$build.log"; failed=$((failed + 1)); continue; }
    program=$build/ifedem
    case $level in
        O0) for setting in "1 2" "2 8" "3 4" "8 1"; do check "$compiler -$level t${setting% *} w${setting#* }" "$program" $setting brief; done
            check "$compiler -$level t2 w2" "$program" 2 2 travel ;;
        O3) for threads in 1 2 3 4 8; do
                for width in 1 2 4 8; do check "$compiler -$level t$threads w$width" "$program" $threads $width long; done
            done
            GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F
            export GLIBC_TUNABLES
            check "$compiler -$level t1 w2 old glibc" "$program" 1 2 long
            unset GLIBC_TUNABLES ;;
        *)  for setting in "1 8" "2 2" "3 1" "4 8" "8 4"; do check "$compiler -$level t${setting% *} w${setting#* }" "$program" $setting long; done ;;
    esac
done
echo "$passed equal, $failed different, $not_run not run"
[ "$failed" = 0 ]
