#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What the scripts of this folder share; sourced by them, from the project's folder.

# step TEXT: a headline.
step() {
  printf '\n== %s\n' "$*"
}

# run COMMAND ...: print a command, then run it.
run() {
  printf '$'
  printf ' %q' "$@"
  printf '\n'
  "$@"
}

# listed_packages USE ...: the packages of scripts/packages.txt for the given uses, less
# those whose command is there from somewhere else.
listed_packages() {
  local use package command
  for use in "$@"; do
    awk -v use="$use" '$1 !~ /^#/ && $2 ~ "(^|,)" use "(,|$)" {print $1, $3}' \
      scripts/packages.txt
  done | while read -r package command; do
    [ -n "$command" ] && command -v "$command" >/dev/null || echo "$package"
  done
}

# install_packages USE ...: install what is missing; without network when nothing is.
install_packages() {
  local package missing=() as_root=()
  for package in $(listed_packages "$@"); do
    dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null |
      grep -q '^install ok installed$' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    echo "All Debian packages are there."
    return
  fi
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  export DEBIAN_FRONTEND=noninteractive
  run "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=600 -qq update
  run "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 -qq \
    install --yes --no-install-recommends "${missing[@]}"
}

# Up to 12 sources are compiled as one: they share the time that PCL's headers take.
unity_build=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12)

# build_preset NAME [OPTION ...]: configure and build one preset of CMakePresets.json.
build_preset() {
  run cmake --preset "$@" "${unity_build[@]}"
  run cmake --build --preset "$1" --parallel "$(nproc)"
}

# test_preset NAME: run the tests of a preset; the output is kept for the summary.
test_preset() {
  run ctest --preset "$1" --parallel "$(nproc)" | tee "build/$1/ctest.log"
}

# summary NAME ...: how the tests of some presets went: what ctest counts are processes
# for some presets, hence the test cases, too, and those that were skipped.
summary() {
  local preset cases
  for preset in "$@"; do
    cases=build/$preset/Testing/Temporary/LastTest.log
    echo "$preset: $(grep 'tests passed' "build/$preset/ctest.log");" \
      "test cases passed: $(grep -c '^\[       OK \]' "$cases")," \
      "skipped: $(grep -c '^\[  SKIPPED \].*ms)$' "$cases")"
  done
}
