#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The site of the documentation, build/docs/html/index.html: all pages of doc/, the public headers
# and the Python module, with search. A warning or a dead link is an error.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

step "Debian packages"
install_packages demo docs

step "The Python module, whose docstrings are the reference"
run cmake --preset release "${unity_build[@]}"
run cmake --build --preset release --parallel "$(nproc)" --target pcl_cid_python_package

step "Site"
run bash doc/site/make_site.sh build/release/python build/docs
echo "Open build/docs/html/index.html"
