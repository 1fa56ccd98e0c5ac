# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A folder of files becomes a part of a program.

# pcl_cid_embed_page(TARGET
#   FOLDER FOLDER
#   [DEPENDS FILE ...])    what is newer than the folder's files once they have changed,
#                          as the stamp of the command that makes them
#
# A static library TARGET with embeddedPage() of studio/server/embedded_page.h. The files
# are read when it is built, so they may be made by the same build.
function(pcl_cid_embed_page target)
  cmake_parse_arguments(PAGE "" "FOLDER" "DEPENDS" ${ARGN})
  find_program(PCL_CID_GZIP gzip REQUIRED)
  set(script ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake)
  set(work ${CMAKE_CURRENT_BINARY_DIR}/${target})
  add_custom_command(
    OUTPUT ${work}/embedded_page.cpp
    COMMAND ${CMAKE_COMMAND}
      -DFOLDER=${PAGE_FOLDER} -DWORK_DIR=${work} -DGZIP=${PCL_CID_GZIP} -P ${script}
    DEPENDS ${PAGE_DEPENDS} ${script}
    COMMENT "Embedding ${PAGE_FOLDER}"
    VERBATIM)
  add_library(${target} STATIC ${work}/embedded_page.cpp)
  target_link_libraries(${target} PUBLIC studio_server)
  # The optimizer of the whole program may part the assembler from who uses its symbols.
  target_compile_options(${target} PRIVATE -fno-lto)
  # What it defines must not meet another file's, and the assembler must see it as it is.
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
endfunction()
