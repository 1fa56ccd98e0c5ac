#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Build the tools and run both on the sample scan. Results: build/demo/

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

step "Debian packages"
install_packages demo

step "Libraries and tools"
build_preset release

step "The scan in parts: 100 seeds, each labelled once, and the labels of all points"
mkdir -p build/demo
run build/release/bin/pcl_cid_segment data/room.pcd build/demo/room_segmented.pcd \
  --labels-from label --html build/demo/room_segmented.html --report build/demo/room_segmented.json

step "The scan as 30 convex hulls"
run build/release/bin/pcl_cid_abstract data/room.pcd build/demo/room_hulls.obj \
  --parts 30 --viewpoints data/room_truth.json --labels build/demo/room_parts.pcd \
  --html build/demo/room_hulls.html --report build/demo/room_hulls.json

step "Results"
ls -l build/demo
echo "Open the .html files in a browser, the .pcd files with pcl_viewer (package pcl-tools), room_hulls.obj with a mesh viewer."
echo "Label the scan by hand, in the browser:"
echo "  build/release/bin/pcl_cid_studio data/room.pcd --session build/demo/room.session --classes s3dis"
