/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID from one point to many: what a heat map shows.
 */

#pragma once

#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/pcl_cid_export.h>

#include <vector>

namespace pcl_cid {

/** \brief CID_p(p, q | S) by Eq. 2 for each of many points q, as in Fig. 1 of the
 *  paper.
 *
 *  Each is pointCID() to the bit; neighbors are visited one after another, because the
 *  sample that decides for one is a good first guess for the next (*ours*).
 *  \param[in] field the surface S
 *  \param[in] p,points finite, metres, in the frame of the surface, on it or off it
 *  \param[in] samples M, min_samples to max_samples
 *  \param[in] execution threads and progress; never change the result
 *  \return the CID from p to each of the points, metres
 *  \throws CIDException when M is out of range, CIDCancelled
 *  \note Cost: one pointCID() for each point, and a tree of the points. */
PCL_CID_EXPORT std::vector<float>
cidFrom(const DistanceField& field,
        const Eigen::Vector3f& p,
        const Points& points,
        int samples,
        const ExecutionOptions& execution = {});

} // namespace pcl_cid
