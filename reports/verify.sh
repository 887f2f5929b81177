#!/bin/sh
# Proves committed reports: reruns some of their runs from nothing (own stage cache) and compares state hashes.
#   verify.sh draw COUNT SEED   COUNT runs of each reports/chapterN/runs.csv, drawn with SEED
#   verify.sh runs NAME...      these runs
#   verify.sh quick             the quick runs of chapter 3 (reports/chapter3/quick.csv)
# Where a report is of another results version its hashes cannot be compared: it is stale, which is told and no failure.
# Exit 1 if a hash differs or a run fails.
set -u
: "${IFEDEM:=build/ifedem}" "${JOBS:=$(nproc)}"
export IFEDEM
version=$($IFEDEM --version | sed 's/.*results version \([0-9]*\).*/\1/')
failed=0

# run,state_hash,results_version of a runs.csv, a line each, by the names in its header
hashes_of() {
    awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) at[$k] = k; next }
             { print $at["run"], $at["state_hash"], $at["results_version"] }' "$1"
}

is_stale() { # file
    old=$(hashes_of "$1" | awk 'NR == 1 { print $3 }')
    [ -n "$old" ] || return 0 # no runs of its own
    [ "$old" = "$version" ] && return 1
    echo "stale: $1 is of results version $old, the program has $version"
}

compare() { # what, name, committed hash, hash now
    if [ "$3" = "$4" ]; then echo "equal: $1 $2 $3"
    else echo "DIFFERS: $1 $2: committed $3, now ${4:-nothing}"; failed=1; fi
}

rerun() { # N, name, committed hash
    out=build/verify/chapter$1
    rm -rf "$out/$2"
    make --no-print-directory -j"$JOBS" -f "reproductions/chapter$1/chapter.mk" OUT="$out" STAGES=build/verify/stages RUNS="$2" \
        "$out/$2/run.csv" > /dev/null || tail -n 2 "$out/logs/$2.log"
    compare "chapter $1" "$2" "$3" "$(awk -F, '$1 == "state_hash" { print $2 }' "$out/$2/run.csv" 2> /dev/null)"
}

mode=${1:?draw, runs or quick}
shift
if [ "$mode" = quick ]; then
    file=reports/chapter3/quick.csv
    is_stale $file && exit 0
    make --no-print-directory -f reproductions/chapter3/chapter.mk quick > /dev/null || exit 1
    hashes_of $file | while read -r name hash old; do
        compare "quick chapter 3" "$name" "$hash" "$(hashes_of build/reports/quick3/runs.csv | awk -v n="$name" '$1 == n { print $2 }')"
        [ $failed = 0 ] || exit 1
    done
    exit
fi
[ "$mode" = draw ] && echo "drawn with seed ${2:?seed}"
for file in reports/chapter*/runs.csv; do
    n=$(echo "$file" | sed 's/.*chapter\([0-9]*\).*/\1/')
    is_stale "$file" && continue
    if [ "$mode" = draw ]; then
        chosen=$(hashes_of "$file" | awk -v seed="$2" 'BEGIN { srand(seed) } { print rand(), $0 }' | sort -n | head -n "$1" | cut -d ' ' -f 2,3)
    else
        chosen=$(hashes_of "$file" | awk -v names=" $* " 'index(names, " " $1 " ") { print $1, $2 }')
    fi
    while read -r name hash; do
        [ -z "$name" ] || rerun "$n" "$name" "$hash"
    done << RUNS
$chosen
RUNS
done
exit $failed
