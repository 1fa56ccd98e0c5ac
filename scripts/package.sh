#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Debian packages, in build/package/packages: built, read by lintian, unpacked and used.
#
#   scripts/package.sh [--clean-root DIR]
#
# With --clean-root, a Debian of nothing but the base is made in DIR (by debootstrap, as root,
# with the network), the packages are installed there, and what they have is used there.

set -euo pipefail
clean_root=
if [ $# -eq 2 ] && [ "$1" = --clean-root ]; then
  clean_root=$(realpath -m "$2")
elif [ $# -ne 0 ]; then
  echo "usage: scripts/package.sh [--clean-root DIR]" >&2
  exit 2
fi
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

if [ -n "$clean_root" ] && [ "$(id -u)" -ne 0 ]; then
  echo "scripts/package.sh: --clean-root needs root" >&2
  exit 1
elif [ -n "$clean_root" ] && [ -e "$clean_root" ]; then
  echo "scripts/package.sh: $clean_root is there already; choose another folder" >&2
  exit 1
fi

step "Debian packages that are needed"
install_packages demo check package

step "Build"
build_preset package

step "Packages, unpacked and used"
run /usr/bin/python3 test/packages/packages_test.py build/package

step "lintian"
run lintian --fail-on error --suppress-tags bad-distribution-in-changes-file build/package/packages/*.deb

if [ -n "$clean_root" ]; then
  step "A Debian of nothing but the base"
  run bash test/packages/clean_root.sh build/package/packages "$clean_root"
fi

step "Packages"
ls -l build/package/packages/*.deb
