#!/bin/bash
# cluster.sh COMMAND...: COMMAND on a cluster of two nodes with one core each, made of network namespaces on this machine and gone when
# COMMAND ends. Nodes are n1 (10.99.0.11) and n2 (10.99.0.12) with slurmd and sshd; this side is 10.99.0.1 with slurmctld and munged. The
# directory tree is shared. COMMAND finds the nodes' first processes in NODE1 and NODE2 (killing one takes its node away), SLURM_CONF,
# and ssh's settings in SSH_CONFIG. Exit 77, with the reason, where this cannot be done.
set -eu
if [ -z "${CLUSTER_DIR:-}" ]; then
    isolated=(unshare --net --mount --pid --uts --fork --kill-child --mount-proc)
    "${isolated[@]}" sh -c 'ip link add bridge0 type bridge && ip link add veth0 type veth peer name veth1 && mount -t tmpfs none /run' 2> /dev/null ||
        { echo "network namespaces, bridges and mounts need privileges"; exit 77; }
    CLUSTER_DIR=$(mktemp -d) && export CLUSTER_DIR
    trap 'rm -rf "$CLUSTER_DIR"' EXIT
    "${isolated[@]}" "$0" "$@"
    exit
fi

in_time() { # what, command...: until it succeeds
    local what=$1; shift
    for _ in $(seq 600); do "$@" > /dev/null 2>&1 && return; sleep 0.1; done
    echo "cluster: $what did not come up" >&2
    tail -n 5 "$CLUSTER_DIR"/*.log >&2
    exit 1
}

hostname master
mount -t tmpfs none /run # sockets and process numbers of this cluster only
ip link set lo up
ip link add bridge0 type bridge
ip addr add 10.99.0.1/24 dev bridge0
ip link set bridge0 up

mkdir /run/munge /run/sshd
head -c 1024 /dev/urandom > /run/munge/key
chown -R munge: /run/munge
chmod 400 /run/munge/key
setpriv --reuid=munge --regid=munge --clear-groups munged --origin=127.0.0.1 --key-file=/run/munge/key --pid-file=/run/munge/pid \
    --log-file=/run/munge/log --seed-file=/run/munge/seed

export SLURM_CONF=$CLUSTER_DIR/slurm.conf
cat > "$SLURM_CONF" << CONF
ClusterName=test
SlurmctldHost=master(10.99.0.1)
SlurmUser=root
StateSaveLocation=$CLUSTER_DIR/state
SlurmdSpoolDir=$CLUSTER_DIR/spool-%n
SlurmctldPidFile=/run/slurmctld.pid
SlurmdPidFile=/run/slurmd-%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,sched_min_interval=0,batch_sched_delay=0
SlurmdTimeout=10
ReturnToService=1
NodeName=n1 NodeAddr=10.99.0.11 CPUs=1 RealMemory=1000 State=UNKNOWN
NodeName=n2 NodeAddr=10.99.0.12 CPUs=1 RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=n1,n2 Default=YES State=UP
CONF
echo "CgroupPlugin=cgroup/v1" > "$CLUSTER_DIR/cgroup.conf"

ssh-keygen -q -t ed25519 -N "" -f "$CLUSTER_DIR/host_key"
ssh-keygen -q -t ed25519 -N "" -f "$CLUSTER_DIR/user_key"
export SSH_CONFIG=$CLUSTER_DIR/ssh_config
cat > "$SSH_CONFIG" << CONF
IdentityFile $CLUSTER_DIR/user_key
StrictHostKeyChecking no
UserKnownHostsFile /dev/null
LogLevel ERROR
BatchMode yes
ServerAliveInterval 2
ServerAliveCountMax 2
Host n1
    HostName 10.99.0.11
Host n2
    HostName 10.99.0.12
CONF
cat > "$CLUSTER_DIR/sshd_config" << CONF
HostKey $CLUSTER_DIR/host_key
AuthorizedKeysFile $CLUSTER_DIR/user_key.pub
StrictModes no
PidFile none
CONF

cat > "$CLUSTER_DIR/node.sh" << 'NODE'
until ip link set "$1" up 2> /dev/null; do sleep 0.05; done
hostname "$1"
ip link set lo up
ip addr add "$2/24" dev "$1"
/usr/sbin/sshd -f "$CLUSTER_DIR/sshd_config"
exec slurmd -D -N "$1"
NODE
is_apart() { [ "$(readlink /proc/self/ns/net)" != "$(readlink "/proc/$1/ns/net")" ]; }
start_node() { # name, address
    # Processes of its own too, so that nothing of a node survives its first one.
    unshare --net --uts --pid --mount --fork --kill-child --mount-proc sh "$CLUSTER_DIR/node.sh" "$1" "$2" > "$CLUSTER_DIR/$1.log" 2>&1 &
    disown # its end is wanted, and not to be told
    ip link add "$1" type veth peer name "bridge-$1"
    ip link set "bridge-$1" master bridge0 up
    in_time "namespace of $1" is_apart $!
    ip link set "$1" netns $!
}

mkdir "$CLUSTER_DIR/state"
slurmctld -D > "$CLUSTER_DIR/slurmctld.log" 2>&1 &
start_node n1 10.99.0.11; NODE1=$!
start_node n2 10.99.0.12; NODE2=$!
export NODE1 NODE2
in_time "n1 in Slurm" sh -c 'sinfo -h -n n1 -t idle | grep -q n1'
in_time "n2 in Slurm" sh -c 'sinfo -h -n n2 -t idle | grep -q n2'
"$@"
