#!/bin/bash
# privileged.sh BUILD: the tests that need root: full disks, and sweeps on a cluster that loses a node. Lines `fault,tried,survived` go to
# BUILD/reliability-privileged.csv. What cannot be run here is told, and counted apart.
set -u -o pipefail
build=$1 csv=$1/reliability-privileged.csv failed=0 not_run=0
export IFEDEM=$build/ifedem
echo "fault,tried,survived" > "$csv"

skip() { # what, why
    echo "not run: $1 ($2)"
    not_run=$((not_run + 1))
}

log=$build/privileged.log
IFEDEM_RELIABILITY_CSV=$csv "$build/tests/faults_test" --gtest_brief=1 --gtest_filter='*Privileged*' > "$log" 2>&1 || { failed=1; cat "$log"; }
! grep -q '^not run' "$log" || skip "full disks" "mounting a file system needs privileges"

install_packages() {
    missing=
    for p in slurm-wlm munge parallel openssh-server iproute2; do dpkg -s $p > /dev/null 2>&1 || missing="$missing $p"; done
    [ -n "$missing" ] || return 0
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing > /dev/null
}

test_engines() {
    [ ! -d /dev/shm ] || export TMPDIR=/dev/shm # in memory: the runs sync often
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    make --no-print-directory -f tests/engines/chapter.mk runs OUT="$scratch/serial" STAGES="$scratch/stages-serial" JOBS=1 2> /dev/null || return 1
    local engine status
    for engine in slurm parallel; do
        status=0
        tests/engines/cluster.sh tests/engines/lose_node.sh $engine "$scratch" > "$scratch/faults" || status=$?
        case $status in
            0) cat "$scratch/faults"
               awk -F, -v fault="a node lost in the midst of a sweep (ENGINE=$engine)" \
                   '{ ++n; ok += $2 == "" } END { print fault "," n "," ok; exit ok < n }' "$scratch/faults" >> "$csv" || failed=1 ;;
            77) skip "ENGINE=$engine on a cluster" "$(cat "$scratch/faults")" ;;
            *) failed=1; echo "ENGINE=$engine ended with $status" ;;
        esac
    done
}
if [ "$(id -u)" = 0 ]; then
    install_packages && test_engines || failed=1
else
    skip "ENGINE=slurm on a cluster" "only root may install and start one"
    skip "ENGINE=parallel on a cluster" "only root may install and start one"
fi

cat "$csv"
echo "$(($(wc -l < "$csv") - 1)) faults tried, $not_run not run"
exit $failed
