#!/bin/sh
# ifedem against LAMMPS, LIGGGHTS and YADE on the same beds: see ../README.md. One core, codes taking turns. Environment: REPS, STEPS, WARM, CPU.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
out=$root/build/bench/peers
export STEPS="${STEPS:-1000}" WARM="${WARM:-300}" CPU="${CPU:-0}" STEP_BENCH="$root/build/tests/bench/step_bench"
reps=${REPS:-5}

missing=
for pair in lmp:lammps liggghts:liggghts yade:yade python3:python3; do
    command -v "${pair%:*}" > /dev/null || missing="$missing ${pair#*:}"
done
[ -z "$missing" ] || { echo "Packages are missing. Run: apt-get install --no-install-recommends$missing" >&2; exit 2; }
[ -x "$STEP_BENCH" ] || { echo "$STEP_BENCH is missing. Run: cmake --build build --target step_bench" >&2; exit 2; }

mkdir -p "$out"
cd "$out"
rm -f ./*
cp "$here"/*.in "$here"/*.py .
for bed in bed20k flow20k; do gunzip -c "$here/$bed.csv.gz" > $bed.csv; done

runs="ifedem:none lammps:none liggghts:none yade:none ifedem:rolling ifedem:spring"
runs="$runs lammps:spring liggghts:spring yade:spring"

echo code,law,state,repeat,steps,cpu_s,ns_particle_step,contacts_a_disc,mean_height_m,mean_vx_m_s,kinetic_J,peak_MB > runs.csv
alike=0
for repeat in $(seq "$reps"); do
    for state in settled flow; do for run in $runs; do
        line=$(python3 one_run.py "${run%:*}" "${run#*:}" $state "$repeat")
        echo "$line" | tee -a runs.csv
    done; done
    [ "$repeat" != 1 ] || python3 table.py alike runs.csv || { alike=1; echo "The beds do not behave alike: take the costs with care."; }
done
python3 table.py cost runs.csv "$root/build/bench-peers.csv"
exit $alike
