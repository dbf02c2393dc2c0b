#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Sets up a Slurm cluster of one node on this machine, for trying bake.slurm: installs Debian's
# slurm-wlm, configures it for this host and starts its daemons. It is meant for a virtual machine or
# a container and must run as root. If the machine already has a slurm.conf of its own, nothing is changed.
#
#     samples/farm/slurm_node.sh          sets up and starts the cluster
#     samples/farm/slurm_node.sh stop     stops the daemons
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
# shellcheck source=samples/setup/packages.sh
source "$root/samples/setup/packages.sh"

readonly conf=/etc/slurm/slurm.conf
readonly mark='# made by foamtex samples/farm/slurm_node.sh'

((EUID == 0)) || die "has to run as root"

stop_daemons() {
    local daemon
    for daemon in slurmd slurmctld; do
        [[ ! -f /run/$daemon.pid ]] || kill "$(<"/run/$daemon.pid")" 2>/dev/null || true
    done
    [[ ! -f /run/munge/munged.pid ]] || kill "$(</run/munge/munged.pid)" 2>/dev/null || true
}

write_conf() {
    local host
    host=$(hostname -s)
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
SlurmctldPidFile=/run/slurmctld.pid
SlurmdPidFile=/run/slurmd.pid
StateSaveLocation=/var/spool/slurmctld
SlurmdSpoolDir=/var/spool/slurmd
NodeName=$host CPUs=$(nproc) State=UNKNOWN
PartitionName=foam Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
}

start_daemons() {
    install -d -o munge -g munge -m 0755 /run/munge
    install -d /var/spool/slurmctld /var/spool/slurmd /var/log/slurm
    pgrep -x munged >/dev/null || runuser -u munge -- munged
    pgrep -x slurmctld >/dev/null || slurmctld
    pgrep -x slurmd >/dev/null || slurmd
}

wait_until_idle() {
    local tries
    for ((tries = 0; tries < 30; ++tries)); do
        [[ $(sinfo -h -o %T 2>/dev/null) == idle ]] && return
        sleep 1
    done
    die "the node does not come up; see /var/log/slurm and 'sinfo -R'"
}

if [[ ${1:-} == stop ]]; then
    stop_daemons
    exit
fi
if [[ -f $conf ]] && ! grep -qxF "$mark" "$conf"; then
    die "$conf is there already; it is left alone"
fi
ensure_packages slurm-wlm munge
write_conf
start_daemons
wait_until_idle
say "the node $(hostname -s) takes jobs: sbatch, squeue"
