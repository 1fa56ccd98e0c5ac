#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Tell Snakemake how a job of Slurm is: running, success or failed.
#
# usage: slurm_status.sh JOB_ID

set -uo pipefail

# The controller forgets a job some minutes after its end; accounting, where there is one, does not.
if told=$(scontrol show job --oneliner "$1" 2>&1); then
  state=$(sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p' <<<"$told")
elif [[ $told == *"Invalid job id"* ]]; then
  state=$(sacct --noheader --allocations --parsable2 --format=State --jobs="$1" 2>/dev/null)
else
  state=RUNNING  # The controller does not answer: ask again.
fi

case $state in
  COMPLETED*) echo success ;;
  PENDING* | CONFIGURING* | RUNNING* | COMPLETING* | SUSPENDED* | STOPPED* | RE* | SIGNALING* | STAGE_OUT*)
    echo running
    ;;
  *) echo failed ;;
esac
