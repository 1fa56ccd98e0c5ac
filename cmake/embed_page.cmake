# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# cmake -DFOLDER=... -DWORK_DIR=... -DGZIP=gzip -P embed_page.cmake
#
# Writes WORK_DIR/embedded_page.cpp, which has all files of FOLDER in it, compressed where
# that helps. The same files give the same bytes.

cmake_minimum_required(VERSION 3.22)

file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${FOLDER} ${FOLDER}/*)
list(SORT files)
if(NOT index.html IN_LIST files)
  message(FATAL_ERROR "${FOLDER}: has no index.html; build the page first")
endif()

file(REMOVE_RECURSE ${WORK_DIR}/files)
file(MAKE_DIRECTORY ${WORK_DIR}/files)
set(included "")
set(declared "")
set(rows "")
set(number 0)
foreach(file ${files})
  # As the assembler and C++ take it without quoting, and browsers ask for it.
  if(NOT file MATCHES "^[A-Za-z0-9_./-]+$")
    message(FATAL_ERROR
      "${FOLDER}/${file}: its name has other characters than letters, digits, '_', '.' and '-'")
  endif()
  set(stored ${WORK_DIR}/files/${number})
  if(file MATCHES "\\.(png|woff2)$") # compressed already
    set(is_gzip false)
    file(COPY_FILE ${FOLDER}/${file} ${stored})
  else()
    set(is_gzip true)
    execute_process(COMMAND ${GZIP} -9nc
      INPUT_FILE ${FOLDER}/${file} OUTPUT_FILE ${stored} COMMAND_ERROR_IS_FATAL ANY)
  endif()
  set(symbol pcl_cid_page_${number})
  string(REGEX REPLACE "([\\\\\"])" "\\\\\\1" quoted "${stored}")
  string(APPEND included
    "  .balign 16\n"
    "${symbol}:\n"
    "  .incbin \"${quoted}\"\n"
    "${symbol}_end:\n"
    "  .byte 0\n") # so that no file begins where another one ends
  string(APPEND declared
    "extern const char ${symbol}[];\nextern const char ${symbol}_end[];\n")
  string(APPEND rows "    {\"/${file}\", ${is_gzip}, ${symbol}, ${symbol}_end},\n")
  math(EXPR number "${number} + 1")
endforeach()

file(WRITE ${WORK_DIR}/embedded_page.cpp
"// Written by cmake/embed_page.cmake.

#include \"server/embedded_page.h\"

asm(R\"page(
  .pushsection .rodata
${included}  .popsection
)page\");

extern \"C\" {
${declared}}

namespace pcl_cid::studio {

const EmbeddedPage&
embeddedPage()
{
  static constexpr EmbeddedFile files[] = {
${rows}  };
  static const EmbeddedPage page(files);
  return page;
}

} // namespace pcl_cid::studio
")
