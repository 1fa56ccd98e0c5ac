# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# cmake -DSOURCE=... -DWORK_DIR=... -DNPM=npm -P build_page.cmake
#
# Builds a page of npm in a copy of its folder: WORK_DIR/dist. The source tree stays as it
# is. What the lock file names is fetched when that has changed.

cmake_minimum_required(VERSION 3.22)

# What was deleted in the source must not stay in the copy.
file(GLOB copied ${WORK_DIR}/*)
list(FILTER copied EXCLUDE REGEX "/node_modules$")
if(copied)
  file(REMOVE_RECURSE ${copied})
endif()
file(COPY ${SOURCE}/ DESTINATION ${WORK_DIR}
  PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE PATTERN dist_picture EXCLUDE)

set(fetched ${WORK_DIR}/node_modules/.fetched-by-lock-file)
set(known "")
if(EXISTS ${fetched})
  file(READ ${fetched} known)
endif()
file(SHA256 ${WORK_DIR}/package-lock.json wanted)
if(NOT known STREQUAL wanted)
  execute_process(COMMAND ${NPM} ci --no-audit --no-fund --loglevel=error
    WORKING_DIRECTORY ${WORK_DIR} COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${fetched} ${wanted})
endif()
execute_process(COMMAND ${NPM} run --silent build
  WORKING_DIRECTORY ${WORK_DIR} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
