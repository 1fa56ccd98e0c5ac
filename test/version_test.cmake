# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The version stands in project(VERSION); the files that repeat it must agree.

# cmake -DVERSION=... -DSOURCE_DIR=... -P version_test.cmake
function(expect_version file regex)
  file(READ ${SOURCE_DIR}/${file} text)
  if(NOT text MATCHES "${regex}")
    message(FATAL_ERROR "${file} names no version")
  endif()
  if(NOT CMAKE_MATCH_1 STREQUAL VERSION)
    message(FATAL_ERROR "${file} says ${CMAKE_MATCH_1}, project(VERSION) says ${VERSION}")
  endif()
endfunction()

expect_version(package.xml "<version>([^<]*)</version>")
expect_version(CITATION.cff "\nversion: ([^\n]*)\n")
expect_version(CHANGELOG.md "\n## ([0-9][^ \n]*)")
