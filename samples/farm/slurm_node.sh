#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Sets up a Slurm cluster on this machine, for trying bake.slurm and jobs.slurm: installs Debian's
# slurm-wlm, configures it for this host and starts its daemons. A cluster of several nodes has one
# slurmd per node, each with a name, a port, a spool folder and a log of its own. It is meant for a
# virtual machine or a container and must run as root. If the machine already has a slurm.conf of its
# own, nothing is changed.
#
#     samples/farm/slurm_node.sh [NODES]  sets up and starts the cluster, with one node or up to nine
#     samples/farm/slurm_node.sh stop     stops the daemons
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
# shellcheck source=samples/setup/packages.sh
source "$root/samples/setup/packages.sh"

readonly conf=/etc/slurm/slurm.conf
readonly mark='# made by foamtex samples/farm/slurm_node.sh'
readonly state=/var/spool/foamtex_slurm

((EUID == 0)) || die "has to run as root"

stop_daemons() {
    local file
    for file in "$state"/*.pid; do
        [[ ! -f $file ]] || kill "$(<"$file")" 2>/dev/null || true
    done
    [[ ! -f /run/munge/munged.pid ]] || kill "$(</run/munge/munged.pid)" 2>/dev/null || true
}

write_conf() {
    local host names ports
    host=$(hostname -s)
    names="node[1-$1]"
    ports="[17001-$((17000 + $1))]"
    cat >"$conf" <<CONF
$mark
ClusterName=foam
SlurmctldHost=$host
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmctldPidFile=$state/slurmctld.pid
SlurmdPidFile=$state/slurmd-%n.pid
SlurmctldLogFile=$state/slurmctld.log
SlurmdLogFile=$state/slurmd-%n.log
StateSaveLocation=$state/state
SlurmdSpoolDir=$state/spool-%n
NodeName=$names NodeHostname=$host Port=$ports CPUs=$(nproc) State=UNKNOWN
PartitionName=foam Nodes=$names Default=YES MaxTime=INFINITE State=UP
CONF
}

start_daemons() {
    local k
    install -d -o munge -g munge -m 0755 /run/munge
    install -d "$state/state"
    pgrep -x munged >/dev/null || runuser -u munge -- munged
    slurmctld
    for ((k = 1; k <= $1; ++k)); do
        install -d "$state/spool-node$k"
        slurmd -N "node$k"
    done
}

wait_until_idle() {
    local tries
    for ((tries = 0; tries < 30; ++tries)); do
        [[ $(sinfo -h -N -o %T 2>/dev/null | grep -cx idle) == "$1" ]] && return
        sleep 1
    done
    die "the nodes do not come up; see $state/*.log and 'sinfo -R'"
}

if [[ ${1:-} == stop ]]; then
    stop_daemons
    exit
fi
nodes=${1:-1}
[[ $nodes =~ ^[1-9]$ ]] || die "'$nodes' is not a number of nodes from 1 to 9"
if [[ -f $conf ]] && ! grep -qxF "$mark" "$conf"; then
    die "$conf is there already; it is left alone"
fi
ensure_packages slurm-wlm munge
stop_daemons
while pgrep -x slurmctld >/dev/null || pgrep -x slurmd >/dev/null; do sleep 0.2; done
rm -rf -- "$state"
write_conf "$nodes"
start_daemons "$nodes"
wait_until_idle "$nodes"
say "$nodes nodes take jobs: sbatch, squeue, sinfo -N"
