/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The point types that the classes are compiled for.
 */

#pragma once

#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

// All of PCL's with x, y and z; a few where a build only serves tests, since each takes
// its time to compile.
#ifdef PCL_CID_FEW_POINT_TYPES
#define PCL_CID_POINT_TYPES (pcl::PointXYZ)(pcl::PointXYZRGB)(pcl::PointXYZRGBNormal)
#else
#define PCL_CID_POINT_TYPES PCL_XYZ_POINT_TYPES
#endif
