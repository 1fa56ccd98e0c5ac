#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Run an experiment of the paper on a dataset; see doc/experiments.md. What is done is kept in
# OUT_FOLDER: the same command goes on where it was stopped.
#
# usage: experiments.sh EXPERIMENT DATASET_FOLDER OUT_FOLDER [--jobs N] [--starts 5]
#                       [--seeds 100] [--scans N] [--methods LIST]
#   EXPERIMENT   tables, seeds, purity, noise, heatmap, labels, peers, raw, clicks or all

set -euo pipefail
started_in=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
project=$PWD
# That of Debian, which has Debian's numpy and matplotlib.
python=/usr/bin/python3

if [ $# -lt 3 ]; then
  sed -n 's/^# \?//; /^usage/,/^$/p' scripts/experiments.sh >&2
  exit 2
fi

step "Debian packages"
install_packages demo benchmark

step "Libraries and programs"
run cmake --preset release -DPCL_CID_BUILD_BENCHMARKS=ON
run cmake --build --preset release --parallel "$(nproc)" \
  --target pcl_cid_segment pcl_cid_abstract pcl_cid_evaluate pcl_cid_simulate \
    cid_perturb cid_peers

step "Experiment"
cd "$started_in"
exec "$python" -B "$project/scripts/experiments/main.py" "$@" --programs "$project/build/release/bin"
