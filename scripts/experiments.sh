#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Run an experiment of the paper on a dataset, by Snakemake; see doc/experiments.md. What is done
# is kept in OUT_FOLDER: the same command goes on where it was stopped.
#
# usage: experiments.sh EXPERIMENT DATASET_FOLDER OUT_FOLDER [--cores N] [--starts 5] [--seeds 100]
#                       [--scans N] [--methods LIST] [--threads 1] [options of Snakemake]
#   EXPERIMENT   tables, seeds, purity, noise, heatmap, labels, peers, raw, clicks or all

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/workflow.sh"
start_workflow main.py "$@"
