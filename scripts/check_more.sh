#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What needs builds of its own: the tests under sanitizers, a robotics workspace, and a
# project that uses the static libraries. Build folders: build/<preset>, build/colcon

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

# colcon_package: what a robotics workspace does with package.xml; static libraries
# here, so that both kinds are consumed (the shared ones by the test `packages`).
colcon_package() {
  local workspace=$PWD/build/colcon
  mkdir -p "$workspace"
  # Left alone, colcon has Ninja wait while the machine's load is high. -O0: what is asked
  # here is whether it builds and links, and -O3 takes far longer. A robot needs no
  # studio, and its packages no Python module; other builds have all point types.
  run env MAKEFLAGS=-j"$(nproc)" CMAKE_BUILD_PARALLEL_LEVEL="$(nproc)" colcon --log-base "$workspace/log" build \
    --paths . --build-base "$workspace/build" --install-base "$workspace/install" \
    --event-handlers console_direct- \
    --cmake-args -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE='-O0 -DNDEBUG' \
      -DBUILD_SHARED_LIBS=OFF -DPCL_CID_BUILD_STUDIO=OFF -DPCL_CID_BUILD_PYTHON=OFF \
      -DPCL_CID_FEW_POINT_TYPES=ON "${unity_build[@]}"
  run cmake -DPREFIX="$workspace/install/pcl_cid" -DWORK_DIR="$workspace/consumer" \
    -P test/consumer/run.cmake
}

step "Debian packages"
install_packages demo check more

step "Tests under AddressSanitizer and UndefinedBehaviorSanitizer"
build_preset asan
test_preset asan

step "Threaded tests under ThreadSanitizer"
build_preset tsan
test_preset tsan

step "colcon build, and a project that uses the static libraries"
colcon_package

step "Summary"
summary asan tsan
