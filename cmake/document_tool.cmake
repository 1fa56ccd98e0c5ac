# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# cmake -DTOOL=... -DNAME=... -DWORK_DIR=... -DGZIP=gzip [-DEMULATOR=...]
#   -P document_tool.cmake
#
# WORK_DIR/NAME.1.gz, the manual page, and WORK_DIR/NAME, the completion.

file(MAKE_DIRECTORY ${WORK_DIR})
execute_process(COMMAND ${EMULATOR} ${TOOL} --completion
  OUTPUT_FILE ${WORK_DIR}/${NAME} COMMAND_ERROR_IS_FATAL ANY)
# -n: no time in it, so that the same sources make the same bytes.
execute_process(COMMAND ${EMULATOR} ${TOOL} --man-page
  COMMAND ${GZIP} -9n
  OUTPUT_FILE ${WORK_DIR}/${NAME}.1.gz COMMAND_ERROR_IS_FATAL ANY)
