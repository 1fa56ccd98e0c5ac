# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The warnings that every target of the project is compiled with.

# In C++, -Wconversion of GCC leaves out signed to unsigned; clang's is brought in line.
function(pcl_cid_enable_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall
    -Wextra
    -Wconversion
    $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
    $<$<BOOL:${PCL_CID_WERROR}>:-Werror>)
endfunction()
