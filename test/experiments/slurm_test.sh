#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The experiments and the batch by Slurm: starts one of a single node on this machine, as root,
# with files and ports of its own, runs the workflows on it by the profile, and compares what
# they make with that of a local run. A scan that fails is among the scans, and one run is killed.
#
# usage: slurm_test.sh [PROGRAMS_FOLDER]
#   PROGRAMS_FOLDER   default: build/dev/bin

set -euo pipefail
programs=$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../../build/dev/bin}")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/common.sh
project=$PWD

step "Debian packages"
install_packages workflow slurm

[ "$(id -u)" -eq 0 ] || exec sudo bash "$project/test/experiments/slurm_test.sh" "$programs"

folder=$(mktemp -d)
daemons=()
stop() {
  # In the order of the start backward; the controller writes its state first.
  local i
  for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do
    kill "${daemons[i]}" 2>/dev/null && wait "${daemons[i]}" || true
  done
  rm -rf "$folder"
}
trap stop EXIT

# free_port: one that nobody listens on.
free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'
}

# within SECONDS COMMAND ...: until it succeeds.
within() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || { echo "not within the time: $*" >&2; return 1; }
    sleep 0.2
  done
}

step "Slurm"
mkdir -m 755 "$folder"/{munge,state,spool}
chmod 755 "$folder"
dd if=/dev/urandom of="$folder/munge/key" bs=1 count=1024 status=none
chmod 400 "$folder/munge/key"
munged --foreground --force --num-threads=2 --key-file="$folder/munge/key" \
  --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" \
  --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" >"$folder/munged.log" 2>&1 &
daemons+=($!)
within 20 munge --socket="$folder/munge/socket" --no-input

host=$(hostname -s)
cat >"$folder/slurm.conf" <<EOF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=8000
PartitionName=all Nodes=$host Default=YES State=UP MaxTime=INFINITE
EOF
export SLURM_CONF=$folder/slurm.conf
slurmctld -D >/dev/null 2>&1 &
daemons+=($!)
slurmd -D >/dev/null 2>&1 &
daemons+=($!)
idle() { sinfo --noheader --format=%t | grep -q idle; }
within 60 idle || { tail "$folder"/*.log >&2; exit 1; }
sinfo

step "Scans"
scans=$folder/scans
mkdir "$scans"
"$programs/make_dataset_folders" "$scans"
echo "no cloud" >"$scans/broken.pcd"

profile=(--profile scripts/experiments/profiles/slurm --latency-wait 5)

# jobs_in FOLDER: how many jobs of Slurm a workflow has had.
jobs_in() {
  find "$1" -path '*/logs/slurm/*.log' | wc -l
}

# both NAME EXIT_CODE COMMAND_LINE ARGUMENTS ...: run a workflow here and by Slurm.
both() {
  local name=$1 code=$2 command_line=$3 first=$4 kind failed
  shift 4
  for kind in local slurm; do
    local more=()
    [ $kind = local ] || more=("${profile[@]}")
    failed=0
    run /usr/bin/python3 -B "scripts/experiments/$command_line" "$first" "$scans" \
      "$folder/$name-$kind" "$@" "${more[@]}" --programs "$programs" \
      >"$folder/$name-$kind.out" 2>"$folder/$name-$kind.err" || failed=$?
    tail -n 3 "$folder/$name-$kind.err"
    [ "$failed" = "$code" ] || { cat "$folder/$name-$kind.err" >&2; return 1; }
  done
  [ "$(jobs_in "$folder/$name-slurm")" -gt 0 ]
}

step "Experiment"
both tables 1 main.py tables --starts 1 --seeds 20
grep -q "  broken.pcd (tables): pcl_cid_segment: " "$folder/tables-slurm.err"
cmp "$folder"/tables-{local,slurm}/tables.csv
cmp "$folder"/tables-{local,slurm}/tables.md

step "Batch"
echo "segment --labels-from label --seeds 20" >"$folder/options"
both batch 1 batch.py evaluate --options "$folder/options"
cmp "$folder"/batch-{local,slurm}/evaluate.csv
for cloud in Area_1/office_1 scans/scene0000_00; do
  cmp "$folder"/batch-{local,slurm}/segment/$cloud.pcd
done

step "Batch that is killed when its jobs have begun"
batch=(/usr/bin/python3 -B scripts/experiments/batch.py evaluate "$scans" "$folder/killed-slurm"
  --options "$folder/options" "${profile[@]}" --programs "$programs")
setsid "${batch[@]}" >"$folder/killed.out" 2>"$folder/killed.err" &
killed=$!
within 60 grep -q "^Submitted job" "$folder/killed.err"
kill -KILL -- -$killed
wait $killed || true
[ ! -e "$folder/killed-slurm/evaluate.csv" ]
"${batch[@]}" >"$folder/killed.out" 2>"$folder/killed.err" || [ $? = 1 ]
cmp "$folder"/{batch-local,killed-slurm}/evaluate.csv
# Jobs that ran meanwhile were taken up.
[ "$(jobs_in "$folder/killed-slurm")" = "$(jobs_in "$folder/batch-slurm")" ] ||
  { cat "$folder/killed.err" >&2; exit 1; }

step "Summary"
echo "The workflows make the same by Slurm as without it, killed or not: $(jobs_in "$folder") jobs."
