#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The site of the documentation in OUTPUT/html, without a warning and without a dead link.
#
#   make_site.sh FOLDER_OF_THE_PYTHON_PACKAGE OUTPUT

set -euo pipefail
python_folder=$(realpath "$1")
output=$(realpath -m "$2")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export PYTHONDONTWRITEBYTECODE=1

rm -rf "$output"
mkdir -p "$output"
/usr/bin/python3 doc/site/python_reference.py "$python_folder" "$output/python_reference.md"
{
  cat doc/site/Doxyfile
  echo "OUTPUT_DIRECTORY = $output"
  echo "INPUT += $output/python_reference.md"
} | doxygen -
/usr/bin/python3 doc/site/site_files.py "$output/html"
