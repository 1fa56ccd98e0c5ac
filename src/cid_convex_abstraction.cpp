/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CIDConvexAbstraction for all PCL point types with x, y and z.
 */

#include <pcl_cid/impl/cid_convex_abstraction.hpp>

#include "point_types.h"

PCL_INSTANTIATE(CIDConvexAbstraction, PCL_CID_POINT_TYPES)
