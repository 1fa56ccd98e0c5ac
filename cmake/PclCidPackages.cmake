# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Debian packages by CPack, one for each component of the installation.

set(library_version ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_COMPONENTS_ALL runtime dev tools python)
if(NOT TARGET pcl_cid_python)
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL python)
endif()
set(runtime_package libpcl-cid${library_version})
set(dev_package libpcl-cid-dev)
set(tools_package pcl-cid-tools)
set(python_package python3-pcl-cid)

# What Debian wants in each package beside the files of its component.
set(documents ${PROJECT_BINARY_DIR}/debian)
set(contact "pcl_cid contributors <maintainers@pcl-cid.example>")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(debian_version ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
file(READ LICENSE license)
string(REGEX REPLACE "^[^\n]*\n\n[^\n]*\n[^\n]*\n\n" "" license "${license}")
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(STRIP "${license}" license)
string(REPLACE "\n" "\n " license "${license}")
configure_file(cmake/debian_copyright.in ${documents}/copyright @ONLY)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC) # or SOURCE_DATE_EPOCH
configure_file(cmake/debian_changelog.in ${documents}/changelog.Debian @ONLY)
configure_file(CHANGELOG.md ${documents}/changelog COPYONLY)
find_program(PCL_CID_GZIP gzip REQUIRED)
execute_process(COMMAND ${PCL_CID_GZIP} -9nf changelog changelog.Debian
  WORKING_DIRECTORY ${documents} COMMAND_ERROR_IS_FATAL ANY)
foreach(component ${CPACK_COMPONENTS_ALL})
  install(FILES
      ${documents}/copyright ${documents}/changelog.gz ${documents}/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${${component}_package}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${${component}_package})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CONTACT "${contact}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})

set(same_version "(= ${debian_version})")
set(about "CID between two points of a scan is the largest distance from the segment\nthat joins them to the scan: large across free space, small within one\nconvex part. It needs no mesh, no normals and no training.")

set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "${about}\n\nThis package has the shared libraries.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
# What dpkg-shlibdeps and ldconfig want to know of libraries.
file(WRITE ${documents}/shlibs "")
foreach(library pcl_cid pcl_cid_io)
  file(APPEND ${documents}/shlibs
    "lib${library} ${library_version} ${runtime_package} (>= ${PROJECT_VERSION})\n")
endforeach()
file(WRITE ${documents}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${documents}/shlibs ${documents}/triggers)

set(CPACK_COMPONENT_DEV_DESCRIPTION
  "${about}\n\nThis package has what programs are built with: headers, CMake and pkg-config\nfiles.")
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${runtime_package} ${same_version}, libpcl-dev")

set(CPACK_COMPONENT_TOOLS_DESCRIPTION
  "${about}\n\nThis package has programs for scans in files: pcl_cid_segment labels points,\npcl_cid_abstract makes convex hulls for collision checks, pcl_cid_evaluate\nand pcl_cid_simulate score labels, and pcl_cid_studio labels scans by hand in\nthe browser.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${runtime_package} ${same_version}")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "bash-completion, xdg-utils, www-browser")

set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "${about}\n\nThis package has the module pcl_cid for Python 3, on arrays of numpy.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
math(EXPR next_python "${PCL_CID_PYTHON_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "${runtime_package} ${same_version}, python3 (>= 3.${PCL_CID_PYTHON_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-tqdm")

include(CPack)
