/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Whether tests run under a sanitizer, many times slower.
 */

#pragma once

namespace pcl_cid::test {

/** \brief What a sanitizer finds, it finds in the first few of many random cases; all
 * of them are for the tests without one. */
#ifdef PCL_CID_SANITIZED
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

} // namespace pcl_cid::test
