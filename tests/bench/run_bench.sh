#!/bin/sh
# Cost of a step on both beds, at rest and avalanching, with the case's step and that of the peers: every run's line in
# build/bench/step.csv, the summary in build/bench.csv. Run on an otherwise idle machine. Environment: THREADS (such as "1 2"), BEDS, CPU.
set -eu
cd "$(dirname "$0")/../.."
out=build/bench
mkdir -p "$out"
rm -f "$out/step.csv"
cpu=${CPU:-0}
for threads in ${THREADS:-1}; do
    [ "$threads" = 1 ] && pin="taskset -c $cpu" || pin=
    for bed in ${BEDS:-20k 46k}; do for state in settled flow; do for dt in 4e-5 1e-5; do
        $pin build/tests/bench/step_bench --bed "$bed" --$state --dt "$dt" --threads "$threads" --cache "$out" --csv "$out/step.csv" > "$out/last.txt"
        awk '{ v[$1] = $2 } END {
            printf "%s %-8s dt %s, %d threads: %.1f ns (%.1f to %.1f) a particle-step, lists %.0f %%, %.2f contacts a disc\n", v["bed"], v["state"],
                v["step_s"], v["threads"], v["cpu_ns_particle_step"], v["cpu_ns_least"], v["cpu_ns_most"], 100 * v["list_share"], v["contacts_a_disc"] }' "$out/last.txt"
    done; done; done
done
# One thread: CPU time. More: wall time, which is what they are for.
awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) at[$k] = k; print "name,value,unit,threads"; next }
    { name = "particle_step_" $at["bed"]
      if ($at["state"] != "flow") name = name "_" $at["state"]
      if ($at["step_s"] != "4e-05") name = name "_dt" $at["step_s"]
      print name "," ($at["threads"] == 1 ? $at["cpu_ns_particle_step"] : $at["wall_ns_particle_step"]) ",ns," $at["threads"] }' \
    "$out/step.csv" > build/bench.csv
cat build/bench.csv
