# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Rooms: the folders that a library is made of, in an order that the compiler enforces.

# pcl_cid_add_room(LIBRARY ROOM
#   [USES TARGET ...]    the rooms that it may include, with all that those may
#   [SEES TARGET ...]    the rooms of which it may include the public headers alone, with
#                        those of all that they use
#   [HEADERS FILE ...]   its public headers, below include/pcl_cid
#   SOURCES FILE ...
#   [LIBRARIES TARGET ...])
#
# An object library LIBRARY_ROOM. It is compiled with one folder of links in the place of
# the project's own: to its private headers ("room/file.h"), to its public ones
# (<pcl_cid/...>), and to those of the rooms that it uses. An include of any other room
# does not compile.
function(pcl_cid_add_room library name)
  cmake_parse_arguments(ROOM "" "" "USES;SEES;HEADERS;SOURCES;LIBRARIES" ${ARGN})
  set(room ${library}_${name})
  set(folders ${CMAKE_CURRENT_SOURCE_DIR})
  set(headers ${ROOM_HEADERS})
  foreach(header ${headers})
    if(NOT header MATCHES "^[a-z0-9_/]+\\.h$") # else a link would be laid over a folder
      message(FATAL_ERROR "room ${name}: '${header}' is not the name of a public header")
    endif()
  endforeach()
  foreach(used ${ROOM_USES})
    get_target_property(folders_of_used ${used} PCL_CID_FOLDERS)
    get_target_property(headers_of_used ${used} PCL_CID_HEADERS)
    list(APPEND folders ${folders_of_used})
    list(APPEND headers ${headers_of_used})
  endforeach()
  foreach(seen ${ROOM_SEES})
    get_target_property(headers_of_seen ${seen} PCL_CID_HEADERS)
    list(APPEND headers ${headers_of_seen})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  list(REMOVE_DUPLICATES headers)

  set(view ${PROJECT_BINARY_DIR}/rooms/${room})
  pcl_cid_make_view(${view} "${folders}" "${headers}")
  add_library(${room} OBJECT ${ROOM_SOURCES})
  set_target_properties(${room} PROPERTIES
    PCL_CID_FOLDERS "${folders}"
    PCL_CID_HEADERS "${headers}"
    POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${room} PRIVATE ${view})
  target_link_libraries(${room} PRIVATE ${ROOM_LIBRARIES})
  pcl_cid_compile_for(${library} ${room})
  pcl_cid_precompile_headers(${room})
endfunction()

# The folder of links.
function(pcl_cid_make_view view folders headers)
  file(REMOVE_RECURSE ${view})
  file(MAKE_DIRECTORY ${view})
  foreach(folder ${folders})
    cmake_path(GET folder FILENAME name)
    file(CREATE_LINK ${folder} ${view}/${name} SYMBOLIC)
  endforeach()
  foreach(header ${headers})
    set(file ${PROJECT_SOURCE_DIR}/include/pcl_cid/${header})
    if(NOT EXISTS ${file}) # one that CMake writes
      set(file ${generated_headers}/pcl_cid/${header})
    endif()
    cmake_path(GET header PARENT_PATH parent)
    file(MAKE_DIRECTORY ${view}/pcl_cid/${parent})
    file(CREATE_LINK ${file} ${view}/pcl_cid/${header} SYMBOLIC)
  endforeach()
endfunction()
