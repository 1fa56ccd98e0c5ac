# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The manual page of a tool and its completion in bash: the tool itself prints them, from
# the options that it takes.

# pcl_cid_document_tool(TOOL)
function(pcl_cid_document_tool tool)
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(STATUS "${tool} gets no manual page and no completion: it does not run here")
    return()
  endif()
  find_program(PCL_CID_GZIP gzip REQUIRED)
  set(script ${PROJECT_SOURCE_DIR}/cmake/document_tool.cmake)
  set(work ${CMAKE_CURRENT_BINARY_DIR}/documents)
  add_custom_command(
    OUTPUT ${work}/${tool}.1.gz ${work}/${tool}
    COMMAND ${CMAKE_COMMAND}
      "-DTOOL=$<TARGET_FILE:${tool}>" "-DEMULATOR=${CMAKE_CROSSCOMPILING_EMULATOR}"
      -DNAME=${tool} -DWORK_DIR=${work} -DGZIP=${PCL_CID_GZIP} -P ${script}
    DEPENDS ${tool} ${script}
    COMMENT "Documents of ${tool}"
    VERBATIM)
  add_custom_target(${tool}_documents ALL DEPENDS ${work}/${tool}.1.gz)
  install(FILES ${work}/${tool}.1.gz
    DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
  install(FILES ${work}/${tool}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tools)
endfunction()
