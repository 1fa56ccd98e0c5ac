/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The distance that no pair of points reaches.
 */

#pragma once

#include <limits>

namespace pcl_cid {

/** \brief What a smallest distance starts from, and a limit that cuts nothing. */
constexpr float infinity = std::numeric_limits<float>::infinity();

} // namespace pcl_cid
