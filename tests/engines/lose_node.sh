#!/bin/bash
# lose_node.sh ENGINE DIR: the travels of chapter.mk on cluster.sh's two nodes. n2 is killed in the midst of a travel, and with Slurm the
# travel on n1 is put back into the queue, which asks it to stop. DIR/serial holds the same travels, made one after another on this
# machine. Prints `name,trouble` for each travel; no trouble is the serial run's hash, and what was stopped must have been resumed.
set -eu
engine=$1 dir=$2 out=$2/$1
printf '1/ssh -F %s %s\n' "$SSH_CONFIG" n1 "$SSH_CONFIG" n2 > "$dir/hosts"
make --no-print-directory -f tests/engines/chapter.mk runs ENGINE="$engine" HOSTS="$dir/hosts" OUT="$out" STAGES="$dir/stages-$engine" \
    > "$dir/$engine.log" 2>&1 &
sweep=$!

# `found` becomes the travel on the node with this first process, once it has a checkpoint: without another process, for it is a matter
# of milliseconds.
find_travel() {
    found=
    for p in /proc/[0-9]*; do
        [ "$p/ns/net" -ef "/proc/$1/ns/net" ] || continue
        mapfile -d '' -t words 2> /dev/null < "$p/cmdline" || continue
        for word in "${words[@]}"; do
            if [ "${word%/*}" = "$out" ] && [ -f "$word/checkpoint.h5" ]; then found=${word##*/}; fi
        done
    done
}

stopped=
while kill -0 $sweep 2> /dev/null; do
    find_travel "$NODE1"; first=$found
    find_travel "$NODE2"; second=$found
    if [ -z "$first" ] || [ -z "$second" ]; then sleep 0.05; continue; fi
    kill -KILL "$NODE2"
    stopped=$second
    [ "$engine" != slurm ] || { scontrol requeue "$(squeue -h -w n1 -t R -o %i)" && stopped="$first $second"; }
    # A run that begins anew empties its directory.
    for name in $stopped; do touch "$out/$name/was_stopped"; done
    break
done
# Slurm starts what it has requeued after two minutes; here at once.
while [ "$engine" = slurm ] && kill -0 $sweep 2> /dev/null; do
    for job in $(squeue -h -t PD -o '%i %r' | awk '$2 == "BeginTime" { print $1 }'); do scontrol update JobId="$job" StartTime=now; done
    sleep 1
done
status=0
wait $sweep || status=$?
[ $status = 0 ] || { cat "$dir/$engine.log" "$out"/logs/*; echo "make ended with $status"; } >&2

value_of() { awk -F, -v name="$2" '$1 == name { print $2 }' "$1/run.csv" 2> /dev/null; }
for run in "$dir"/serial/*/run.csv; do
    name=$(basename "$(dirname "$run")") trouble=
    [ "$(value_of "$dir/serial/$name" state_hash)" = "$(value_of "$out/$name" state_hash)" ] || trouble="other hash or none"
    case " $stopped " in *" $name "*)
        [ -f "$out/$name/was_stopped" ] || trouble="$trouble; not resumed" ;;
    esac
    echo "$name,$trouble"
done
[ -n "$stopped" ] || echo "none,no travel was stopped: nothing was tested"
