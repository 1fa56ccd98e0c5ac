/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CIDSampler for all PCL point types with x, y and z.
 */

#include <pcl_cid/impl/cid_sampler.hpp>

#include "point_types.h"

PCL_INSTANTIATE(CIDSampler, PCL_CID_POINT_TYPES)
