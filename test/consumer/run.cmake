# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Build and run a project that uses an installed pcl_cid, and the installed tools.

# cmake -DPREFIX=... -DWORK_DIR=... [-DBUILD_DIR=... (installed to PREFIX first)]
#   [-DCONFIGURE_ARGS=...] -P run.cmake
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(BUILD_DIR)
  file(REMOVE_RECURSE ${PREFIX})
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX})
endif()
file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK_DIR} -G Ninja
  -DCMAKE_PREFIX_PATH=${PREFIX} ${CONFIGURE_ARGS})
run(${CMAKE_COMMAND} --build ${WORK_DIR})
run(${WORK_DIR}/consumer)
foreach(tool pcl_cid_segment pcl_cid_abstract)
  run(${PREFIX}/bin/${tool} --version)
endforeach()
