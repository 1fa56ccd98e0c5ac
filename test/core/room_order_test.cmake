# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A room of the core may include the rooms before it, and nothing else of the project: an
# include that runs back up does not compile.
#
# cmake -DROOM=<name> -DSOURCE_DIR=<project> -DVIEW=<what the room sees> -DWORK_DIR=<dir>
#   -DCOMPILER=<c++> -DINCLUDES=<dir|dir|...> -P room_order_test.cmake

cmake_minimum_required(VERSION 3.22)

# The order, written down once more: what the build files say is what is tested.
set(order base field cid scan grouping merging hull fitting)
if(ROOM STREQUAL "score")
  set(allowed base score)
elseif(ROOM STREQUAL "boundary")
  set(allowed base field cid scan grouping boundary)
elseif(ROOM STREQUAL "session")
  set(allowed base field cid scan grouping boundary merging session)
elseif(ROOM STREQUAL "annotation")
  set(allowed base field cid scan grouping boundary merging session score annotation)
else()
  list(FIND order ${ROOM} last)
  if(last LESS 0)
    message(FATAL_ERROR "room ${ROOM} has no place in the order; give it one here")
  endif()
  math(EXPR length "${last} + 1")
  list(SUBLIST order 0 ${length} allowed)
endif()

set(public_of_base color execution frame named_instance point_set settings)
set(public_of_field distance_field)
set(public_of_cid cid_from concavity)
set(public_of_scan prepared_scan voxel_points)
set(public_of_grouping grouping smooth_patches)
set(public_of_boundary label_cleaning)
set(public_of_merging group_merging)
set(public_of_hull convex_part extreme_points hull_guarantees hull_primitive hull_tightness)
set(public_of_fitting hull_cid hull_fitting hull_simplification)
set(public_of_score evaluation instance_overlaps)
set(public_of_session label_action label_doubt label_session part_action part_session)
set(public_of_annotation annotation)

# The includes that must be possible and those that must not.
set(possible)
set(impossible "<pcl_cid/cid_base.h>" "<pcl_cid/cid_parameters.h>" "<pcl_cid/cid_sampler.h>")
set(known)
foreach(room ${order} boundary score session annotation)
  file(GLOB private RELATIVE ${SOURCE_DIR}/src/core ${SOURCE_DIR}/src/core/${room}/*.h)
  list(TRANSFORM private REPLACE "(.+)" "\"\\1\"")
  set(headers ${private})
  foreach(name ${public_of_${room}})
    list(APPEND headers "<pcl_cid/core/${name}.h>")
    list(APPEND known ${name}.h)
  endforeach()
  if(room IN_LIST allowed)
    list(APPEND possible ${headers})
  else()
    list(APPEND impossible ${headers})
  endif()
endforeach()

file(GLOB public RELATIVE ${SOURCE_DIR}/include/pcl_cid/core
  ${SOURCE_DIR}/include/pcl_cid/core/*.h)
list(SORT public)
list(SORT known)
if(NOT public STREQUAL known)
  message(FATAL_ERROR "public headers of the core are\n  ${public}\nbut this test knows\n  ${known}")
endif()

string(REPLACE "|" ";" folders "${INCLUDES}")
if(NOT VIEW IN_LIST folders)
  message(FATAL_ERROR "room ${ROOM} is not compiled with its view ${VIEW}, but with ${folders}")
endif()
foreach(folder ${folders})
  if(folder STREQUAL "${SOURCE_DIR}/include" OR folder MATCHES "^${SOURCE_DIR}/src")
    message(FATAL_ERROR "room ${ROOM} sees all of ${folder}")
  endif()
endforeach()
list(TRANSFORM folders PREPEND "-I")

# Compile a text as a file of the room would be.
function(compile name text result errors)
  set(file ${WORK_DIR}/room_order_${ROOM}_${name}.cpp)
  file(WRITE ${file} "${text}")
  execute_process(
    COMMAND ${COMPILER} -std=c++17 -fsyntax-only -w ${folders} ${file}
    RESULT_VARIABLE status ERROR_VARIABLE output OUTPUT_QUIET)
  set(${result} ${status} PARENT_SCOPE)
  set(${errors} "${output}" PARENT_SCOPE)
endfunction()

set(text)
foreach(header ${possible})
  string(APPEND text "#include ${header}\n")
endforeach()
compile(possible "${text}" status errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "room ${ROOM} cannot include what it may:\n${errors}")
endif()

set(text)
foreach(header ${impossible})
  string(APPEND text "#if __has_include(${header})\n#error ${ROOM} can include ${header}\n#endif\n")
endforeach()
compile(impossible "${text}" status errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${errors}")
endif()

# And what an author would see.
list(GET impossible -1 header)
compile(refused "#include ${header}\n" status errors)
if(status EQUAL 0 OR NOT errors MATCHES "No such file|not found")
  message(FATAL_ERROR "#include ${header} in room ${ROOM} was not refused as it should:\n${errors}")
endif()

# Nor by a path that leaves the room.
file(GLOB sources ${SOURCE_DIR}/src/core/${ROOM}/*.h ${SOURCE_DIR}/src/core/${ROOM}/*.cpp)
foreach(source ${sources})
  file(STRINGS ${source} climbs REGEX "#include *\"(\\.\\./|[^\"]*/\\.\\./)")
  if(climbs)
    message(FATAL_ERROR "${source}: ${climbs}")
  endif()
endforeach()
