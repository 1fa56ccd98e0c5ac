#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What needs builds of its own: the tests under sanitizers, a robotics workspace, a
# project that uses the static libraries, and a wheel. Build folders: build/<preset>,
# build/colcon, build/temp.*

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

# colcon_package: what a robotics workspace does with package.xml; static libraries
# here, so that both kinds are consumed (the shared ones by the test `package`).
colcon_package() {
  local workspace=$PWD/build/colcon
  mkdir -p "$workspace"
  # Left alone, colcon has Ninja wait while the machine's load is high. -O1: what is asked
  # here is whether it builds and links, and -O3 takes twice as long. A robot needs no
  # studio.
  run env MAKEFLAGS=-j"$(nproc)" CMAKE_BUILD_PARALLEL_LEVEL="$(nproc)" colcon --log-base "$workspace/log" build \
    --paths . --build-base "$workspace/build" --install-base "$workspace/install" \
    --event-handlers console_direct- \
    --cmake-args -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE='-O1 -DNDEBUG' \
      -DBUILD_SHARED_LIBS=OFF -DPCL_CID_BUILD_STUDIO=OFF "${unity_build[@]}"
  run cmake -DPREFIX="$workspace/install/pcl_cid" -DWORK_DIR="$workspace/consumer" \
    -P test/consumer/run.cmake
}

# python_wheel: pip builds the Python module with the library inside, for a fresh
# environment.
python_wheel() {
  local environment=$PWD/build/venv
  rm -rf "$environment"
  run /usr/bin/python3 -m venv --system-site-packages "$environment"
  run "$environment/bin/pip" install --no-build-isolation .
  (cd "$environment" &&
    run bin/python -c "import pcl_cid; print(pcl_cid.Scan([[0, 0, 0]]).parts(count=1))")
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

step "A wheel of the Python module"
python_wheel

step "Summary"
summary asan tsan
