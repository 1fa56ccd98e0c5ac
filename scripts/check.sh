#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# One build, warnings as errors, and all the tests. Build folder: build/dev. What takes
# builds of its own (sanitizers, colcon, static libraries) is in check_more.sh.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

step "Debian packages"
install_packages demo check

step "Format"
find include src tools studio/app studio/server python test doc -name '*.h' -o -name '*.hpp' -o -name '*.cpp' |
  xargs clang-format --dry-run --Werror
echo "All files are formatted."
if grep -rnE '[a-z.;)] \\(throws|return|param|note)\b' include src tools studio/app studio/server python; then
  echo "clang-format has pulled a command of Doxygen into the line before it." >&2
  exit 1
fi

step "Tests, warnings as errors"
# Without debug information, which the preset has: nobody looks at it here.
build_preset dev -DPCL_CID_REQUIRE_PARSERS=ON -DPCL_CID_TEST_PROCESSES=16 \
  -DCMAKE_CXX_FLAGS_DEBUG='-O2 -D_GLIBCXX_ASSERTIONS'
test_preset dev

step "Summary"
summary dev
