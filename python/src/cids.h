/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID itself: from a point to all, of pairs of points, of two groups.
 */

#pragma once

#include "scan.h"

#include <pcl_cid/core/distance_field.h>

#include <pybind11/pybind11.h>

namespace pcl_cid::python {

/** \brief A point of a scan in the frame of its field.
 *  \throws ValueError when it is not finite */
Eigen::Vector3f
localPoint(const Scan& scan, pcl::index_t index);

/** \brief CID from a place to each point of a scan by Eq. 2; NaN where that is not
 *  finite. May run without the GIL. */
std::vector<float>
cidsFrom(const Scan& scan,
         const Eigen::Vector3f& from,
         const ExecutionOptions& execution);

/** \brief point_cid() and group_cid(). */
void
bindCids(pybind11::module_& module);

} // namespace pcl_cid::python
