# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# How experiments.sh and batch.sh start a workflow; sourced by them.

# start_workflow COMMAND_LINE ARGUMENTS ...: install and build what is missing, then start. What
# is told before goes to the standard error, for --dag writes to the standard output.
start_workflow() {
  local command_line=$1 started_in=$PWD project
  shift
  cd "$(dirname "${BASH_SOURCE[0]}")/.."
  source scripts/common.sh
  project=$PWD
  if [ $# -lt 3 ]; then
    sed -n 's/^# \?//; /^usage/,/^$/p' "$project/scripts/$(basename "$0")" >&2
    exit 2
  fi
  {
    step "Debian packages"
    install_packages demo workflow

    step "Libraries and programs"
    run cmake --preset release -DPCL_CID_BUILD_BENCHMARKS=ON
    run cmake --build --preset release --parallel "$(nproc)" \
      --target pcl_cid_segment pcl_cid_abstract pcl_cid_evaluate pcl_cid_simulate \
        cid_perturb cid_peers

    step "Workflow"
  } >&2
  cd "$started_in"
  # Debian's Python, which has Debian's Snakemake, numpy and matplotlib.
  exec /usr/bin/python3 -B "$project/scripts/experiments/$command_line" "$@" \
    --programs "$project/build/release/bin"
}
