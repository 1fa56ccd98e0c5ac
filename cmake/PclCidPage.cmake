# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The pages of the browser, built by npm where it is there: the studio's, which
# pcl_cid_studio has in it, and that of --html, which the other tools have.
#
# PCL_CID_PAGE_DIR: the folder that they are built in, with dist/ and
# dist_picture/picture.html; PCL_CID_PAGE_DIR.stamp is newer than these; the target
# studio_page_files makes them.

find_program(PCL_CID_NPM npm)
if(NOT PCL_CID_NPM)
  return()
endif()

set(page_source ${PROJECT_SOURCE_DIR}/studio/page)
file(GLOB page_files CONFIGURE_DEPENDS
  ${page_source}/*.html ${page_source}/*.json ${page_source}/*.js)
file(GLOB_RECURSE page_sources CONFIGURE_DEPENDS
  ${page_source}/src/* ${page_source}/mock/* ${page_source}/test/*)
set(PCL_CID_PAGE_DIR ${PROJECT_BINARY_DIR}/studio/page)
add_custom_command(
  OUTPUT ${PCL_CID_PAGE_DIR}.stamp
  COMMAND ${CMAKE_COMMAND}
    -DSOURCE=${page_source} -DWORK_DIR=${PCL_CID_PAGE_DIR} -DNPM=${PCL_CID_NPM}
    -P ${PROJECT_SOURCE_DIR}/cmake/build_page.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${PCL_CID_PAGE_DIR}.stamp
  DEPENDS ${page_files} ${page_sources} ${PROJECT_SOURCE_DIR}/cmake/build_page.cmake
  COMMENT "Building the pages of the studio and of --html"
  VERBATIM)
add_custom_target(studio_page_files DEPENDS ${PCL_CID_PAGE_DIR}.stamp)
