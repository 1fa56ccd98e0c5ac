#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Every reader of files under libFuzzer for some seconds each: files of at most 10 kB,
# none of which may take 64 MB or 2 seconds. Build folder: build/fuzz, with a corpus that
# grows from run to run, and what was found.
#
#   scripts/fuzz.sh SECONDS [READER ...]

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

seconds=${1:?usage: scripts/fuzz.sh SECONDS [READER ...]}
shift

step "Debian packages"
install_packages demo check more

step "Readers under libFuzzer"
build_preset fuzz
fuzz_reader=build/fuzz/bin/fuzz_reader
# Without a name it fails, and says which there are.
readers=${*:-$({ "$fuzz_reader" 2>&1 || true; } | sed -n 's/.*must name a reader://p')}
# Files are written and read again: in memory that is quick.
[ ! -d /dev/shm ] || export TMPDIR=/dev/shm

for reader in $readers; do
  step "$reader"
  corpus=build/fuzz/corpus/$reader
  mkdir -p "$corpus" build/fuzz/found
  run env PCL_CID_FUZZED="$reader" PCL_CID_CORPUS="$corpus" "$fuzz_reader" "$corpus" \
    -max_total_time="$seconds" -max_len=10240 -timeout=2 -malloc_limit_mb=64 \
    -artifact_prefix="build/fuzz/found/$reader-" -print_final_stats=1 -print_funcs=0 -verbosity=0
done
