#!/bin/sh
# parallel.sh HOSTS LOGS COMMAND...: `COMMAND FILE` for each line of LOGS/missing.txt on the machines of HOSTS. What fails is tried twice
# more, on another machine if there is one. What stops it stops the tasks, which then write checkpoints.
set -u
hosts=$(realpath "$1") logs=$2
shift 2
unset MAKEFLAGS MFLAGS MAKELEVEL # of the make that called: a task has no job server
parallel --will-cite --quote --sshloginfile "$hosts" --ssh "ssh -o BatchMode=yes -o ServerAliveInterval=15" --workdir "$PWD" \
    --retries 3 --termseq TERM,10000,KILL --joblog "$logs/parallel.csv" "$@" {} < "$logs/missing.txt" > "$logs/make.log" 2>&1 &
parallel=$!
# At the first signal parallel waits for its tasks, at the second it stops them.
trap 'kill $parallel; sleep 0.5; kill $parallel 2> /dev/null; wait $parallel; exit 143' HUP INT TERM
wait $parallel || exit 1 # its own code is the number of failures
exec "$(dirname "$0")/all_there.sh" "$logs"
