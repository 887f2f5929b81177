#!/bin/sh
# slurm.sh LOGS COMMAND...: one job array, `COMMAND FILE` for each line of LOGS/missing.txt in its order. Waits until no task is left;
# what stops it cancels the array, whose tasks then write checkpoints.
set -u
logs=$1
shift
unset MAKEFLAGS MFLAGS MAKELEVEL # of the make that called: a task has no job server
: > "$logs/make.log"
tasks=$(wc -l < "$logs/missing.txt")
[ "$tasks" -gt 0 ] || exit 0
job=$(sbatch --parsable --array="1-$tasks" --output="$logs/make.log" "$(dirname "$0")/slurm_task.sh" "$logs/missing.txt" "$@") || {
    echo "sbatch refused $tasks tasks (its reason is above). Set SBATCH_ACCOUNT, SBATCH_PARTITION or what else your cluster asks for?" >&2
    exit 5
}
job=${job%%;*} # of several clusters
trap 'scancel "$job"; exit 143' HUP INT TERM
# A failing squeue says nothing about the tasks: the controller may be away for a while.
while ! left=$(squeue --me --noheader --format=%F) || echo "$left" | grep -qx "$job"; do
    sleep 2 &
    wait $!
done
exec "$(dirname "$0")/all_there.sh" "$logs"
