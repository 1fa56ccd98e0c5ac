#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The site of the documentation in build/docs/html, without a warning and without a dead link.
#
#   make_site.sh FOLDER_OF_THE_PYTHON_PACKAGE

set -euo pipefail
python_folder=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export PYTHONDONTWRITEBYTECODE=1

rm -rf build/docs
mkdir -p build/docs
/usr/bin/python3 doc/site/python_reference.py "$python_folder" build/docs/python_reference.md
doxygen doc/site/Doxyfile
/usr/bin/python3 doc/site/site_files.py build/docs/html
