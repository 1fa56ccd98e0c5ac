#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Run a tool on every scan of a folder, by Snakemake; see doc/many_scans.md. What is done is kept
# in OUT_FOLDER: the same command goes on where it was stopped.
#
# usage: batch.sh TOOL DATASET_FOLDER OUT_FOLDER [--options FILE] [--cores N] [--threads 1]
#                 [--scans N] [options of Snakemake]
#   TOOL   segment, abstract, evaluate (what segment made) or all

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/workflow.sh"
start_workflow batch.py "$@"
