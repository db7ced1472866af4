#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the files for Slurm that ship on a Slurm of one node, which is started for that on the loopback
# interface, and compares what they write with what stigc alone writes. Exits with 77 where no Slurm
# can be started.
#
#     slurm_test.sh STIGC STIGC_MPI|- SOURCES
set -euo pipefail
stigc=$1 mpi=$2 sources=$3
left_out() { printf 'left out: %s\n' "$1"; exit 77; }
PATH=$PATH:/usr/sbin:/sbin
for program in munged slurmctld slurmd sbatch scontrol sinfo python3; do
  command -v "$program" >/dev/null || left_out "there is no $program (scripts/install.sh slurm)"
done
[[ $(id -u) -eq 0 ]] || left_out 'slurmd wants to be root'

work=$(mktemp -d)
chmod 755 "$work"
servers=()
stop() {
  local pid
  for pid in "${servers[@]}"; do kill "$pid" 2>/dev/null || true; done
  for pid in "${servers[@]}"; do wait "$pid" 2>/dev/null || true; done
  rm -rf "$work"
}
trap stop EXIT
cd "$work"
mkdir munge state spool

# Keys, sockets, ports and logs of its own: a Slurm that runs here already is left alone.
head -c 1024 /dev/urandom >munge/key
chmod 600 munge/key
munged --foreground --force --num-threads=2 --key-file="$work/munge/key" \
  --socket="$work/munge/socket" --pid-file="$work/munge/pid" --seed-file="$work/munge/seed" \
  --log-file="$work/munge/log" >munge/out 2>&1 &
servers+=($!)
node=$(hostname -s)
read -r control_port node_port < <(python3 - <<'PORTS'
import socket
held = [socket.socket() for _ in range(2)]
for one in held:
    one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in held))
PORTS
)
cat >slurm.conf <<CONF
ClusterName=stigc
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$control_port
SlurmdPort=$node_port
CommunicationParameters=NoAddrCache
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
SlurmdParameters=config_overrides
MpiDefault=pmix
ReturnToService=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=8 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
printf 'CgroupAutomount=no\n' >cgroup.conf
export SLURM_CONF=$work/slurm.conf
for _ in {1..50}; do [[ -S munge/socket ]] && break; sleep 0.1; done
slurmctld -D -c >slurmctld.out 2>&1 &
servers+=($!)
slurmd -D -c -N "$node" >slurmd.out 2>&1 &
servers+=($!)
for _ in {1..100}; do
  [[ $(timeout 5 sinfo -h -o %T 2>/dev/null) == idle ]] && break
  sleep 0.2
done
if [[ $(timeout 5 sinfo -h -o %T 2>/dev/null) != idle ]]; then
  tail -n 5 munge/out munge/log slurmctld.out slurmctld.log slurmd.out slurmd.log 2>/dev/null || true
  left_out 'no Slurm could be started'
fi

# The programs, and the files that plans name.
export STIGC=$stigc STIGC_MPI=$mpi
# As root in a container, more ranks than cores.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none
cat >plan.yaml <<'PLAN'
stigc_sweep: 1
command: explore
file: rulesets/wall.yaml
options: {agents: 1, box: [20, 20, 20], steps: 20000}
vary: {seed: 1..12}
PLAN
cat >search.yaml <<'PLAN'
stigc_search: 1
name: on-a-cluster
method: genetic
score: [{objective: modules}]
rules: 8
box: 10
deposits: 100
batch: 64
evaluations: 256
PLAN
"$stigc" sweep plan.yaml -q -o whole.jsonl >/dev/null
"$stigc" search search.yaml -q --threads 1 -o whole.sqlite >whole.txt

# submit NAME OPTIONS… FILE ARGUMENTS…: to the end of the job, whose output stands in NAME.out.
submit() {
  local name=$1
  shift
  timeout 120 sbatch --wait --quiet -o "$work/$name.out" "$@" && return
  printf 'the job failed: %s\n' "$name" >&2
  cat "$name.out" >&2 || true
  tail -n 20 slurmctld.log slurmd.log >&2
  exit 1
}
content() { sed -n 's/^ *content *//p' "$1"; }
alike() {
  [[ -n $(content whole.txt) && $(content "$1") == "$(content whole.txt)" ]] ||
    { printf 'another content: %s\n' "$1" >&2; cat "$1" >&2; exit 1; }
  printf 'the same: %s\n' "$1"
}
same() { cmp whole.jsonl "$1" && printf 'the same: %s\n' "$1"; }

submit sweep --array=1-3 "$sources/studies/sweep.sbatch" plan.yaml results/sweep
"$stigc" merge results/sweep-*.jsonl -q -o results/sweep.jsonl >/dev/null
same results/sweep.jsonl
submit search.txt --cpus-per-task=2 "$sources/studies/search.sbatch" search.yaml results/search
alike search.txt.out
if [[ $mpi == - ]]; then
  printf 'no stigc-mpi: its files are left out\n'
  exit 0
fi
submit sweep-mpi --ntasks=3 "$sources/studies/sweep-mpi.sbatch" plan.yaml results/sweep-mpi
same results/sweep-mpi.jsonl
submit search-mpi.txt --ntasks=3 "$sources/studies/search-mpi.sbatch" search.yaml \
  results/search-mpi
alike search-mpi.txt.out
