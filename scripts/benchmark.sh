#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Measure times and memory; see doc/benchmark.md. Results: build/benchmark/
#
# usage: benchmark.sh [--quick | --write-doc]
#   --quick      rooms of 20,000 and 200,000 points, few rounds
#   --write-doc  also put tables and pictures into doc/

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

mode=${1:-full}
case "$#$mode" in
  0full | 1--quick | 1--write-doc) ;;
  *)
    sed -n 's/^# \?//; /^usage/,/^$/p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac
results=build/benchmark
bin=build/release/bin
# That of Debian, which has Debian's matplotlib.
python=/usr/bin/python3
literal_seconds=10
if [ "$mode" = --quick ]; then
  literal_seconds=3
fi

# end_to_end ROUNDS WORK ... -- INPUT ...: measure on one input.
end_to_end() {
  local rounds=$1 works=()
  shift
  while [ "$1" != -- ]; do
    works+=("$1")
    shift
  done
  shift
  run "$bin/cid_end_to_end" "$@" --rounds "$rounds" --measure "${works[@]}" \
    --literal-seconds "$literal_seconds" --csv "$results/results.csv"
}

# room ROUNDS POINTS WORK ...: measure on both rooms of this size.
room() {
  local rounds=$1 points=$2 scan
  shift 2
  for scan in even sensor; do
    end_to_end "$rounds" "$@" -- --room "$scan" --points "$points"
  done
}

# real_scan NAME WORK ...: measure on a scan of ../shared/data.
real_scan() {
  local file=../shared/data/$1
  shift
  if [ -e "$file" ]; then
    end_to_end 3 "$@" -- "$file"
    end_to_end 1 check -- "$file"
  else
    echo "Skipped: there is no $file."
  fi
}

describe_machine() {
  echo "Processor: $(lscpu | sed -n 's/^Model name: *//p'), $(nproc) cores"
  echo "Memory: $(free --giga | awk '/^Mem:/ {print $2}') GB"
  echo "System: $(. /etc/os-release && echo "$PRETTY_NAME"), Linux $(uname -r)"
  echo "Compiler: $(c++ --version | head -n 1), build of type Release"
  echo "Date: $(date --iso-8601)"
}

# The numbers of threads of the curve: 1, 2, 4, ... up to all.
threads_of_curve() {
  local threads
  for ((threads = 1; threads <= $(nproc); threads *= 2)); do
    echo "segment:100:$threads"
  done
}

# The figures that are compared are taken several times a round, on both sides of the literal method
# where that is the other one: the machine's speed changes from one second to the next.
measure_small_rooms() {
  local rounds=$1 points
  local seeds_and_merging=(seeds:100:2 merge:100:2 cut:100:2)
  seeds_and_merging+=("${seeds_and_merging[@]}")
  for points in 20000 200000; do
    room "$rounds" "$points" segment:100:2 segment:100:2 literal:100:2 segment:100:2 \
      segment:100:2 defaults:100:2 sample:100:2 "${seeds_and_merging[@]}" \
      "${seeds_and_merging[@]}" extend:110:2 sample:110:2 handle:100:2 segment:10:2 segment:30:2 \
      segment:300:2 segment:1000:2 "${curve[@]}"
    room 1 "$points" check:100:2
  done
}

measure_large_rooms() {
  local one_side=(segment:100:2 "${curve[@]}")
  one_side+=("${one_side[@]}")
  room 3 254456 segment:100:2
  room 2 1000000 "${one_side[@]}" literal:100:2 defaults:100:2 sample:100:2 extend:110:2 \
    sample:110:2 handle:100:2 add:100:2 remove:100:2 segment:1000:2 "${one_side[@]}"
  room 2 10000000 segment:100:2 literal:100:2
  room 1 1000000 check:100:2
  room 1 10000000 check:100:2
}

measure_real_scans() {
  local scan
  for scan in office1 room_scan1 mosd_learn41; do
    real_scan "$scan.pcd" segment:100:2 literal:100:2 defaults:100:2
  done
}

# The sample scan, beside processes that never wait: five pairs in turn.
measure_busy_machine() {
  end_to_end 5 busy:100:1 busy:100:2 busy_cpu:100:1 busy_cpu:100:2 -- data/room.pcd
}

measure_reading() {
  room 5 1000000 read_pcd:1:1 pcl_pcd:1:1 read_ascii_pcd:1:1 pcl_ascii_pcd:1:1 read_ply:1:1 pcl_ply:1:1
}

step "Debian packages"
install_packages demo benchmark

step "Libraries and benchmarks"
build_preset release -DPCL_CID_BUILD_BENCHMARKS=ON

step "Measurements"
mkdir -p "$results"
rm -f "$results/results.csv"
describe_machine | tee "$results/machine.txt"
# Those of 2 threads are measured anyway.
mapfile -t curve < <(threads_of_curve | grep -v ':2$')
if [ "$mode" = --quick ]; then
  measure_small_rooms 2
  measure_busy_machine
  measure_reading
else
  measure_small_rooms 3
  measure_busy_machine
  measure_reading
  measure_large_rooms
  measure_real_scans
fi

step "Single steps"
run "$bin/cid_kernels" --benchmark_out="$results/kernels.json" \
  --benchmark_out_format=json

step "Tables and pictures"
run "$python" scripts/plot_benchmark.py "$results"
if [ "$mode" = --write-doc ]; then
  run "$python" scripts/benchmark_table.py "$results" --doc doc/benchmark.md
  mkdir -p doc/images
  for picture in time_points time_seeds time_threads memory_points; do
    run cp "$results/$picture.png" "doc/images/benchmark_$picture.png"
  done
else
  run "$python" scripts/benchmark_table.py "$results"
fi
cat "$results/table.md"
