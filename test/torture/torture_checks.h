/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What must hold of every case.
 */

#pragma once

#include "torture_case.h"

#include <string>

namespace pcl_cid::test {

/** How a case ended. */
struct TortureVerdict {
  std::string fault;   ///< empty: all holds
  std::string refusal; ///< the documented exception that it ended with, if any
};

/** Run a case on 1 and on 3 threads, and check all that is promised. */
TortureVerdict
judge(const TortureCase& one);

} // namespace pcl_cid::test
