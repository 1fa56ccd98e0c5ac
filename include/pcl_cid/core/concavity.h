/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Concavity-Induced Distance of two points and of two groups: Eq. 1 to 3.
 */

#pragma once

#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <limits>

namespace pcl_cid {

/** \brief Fewest and most samples on a segment (M). Up to the upper limit the position
 *  of a sample is exact to the last bit of float. */
constexpr int min_samples = setting::samples.least;
constexpr int max_samples = setting::samples.most;

/** \brief Sample l of M on the segment pq: x_l = p + (q - p) l / (M - 1).
 *
 *  Written as (p (M - 1 - l) + q l) / (M - 1) in double: sample l of pq and sample M -
 *  1 - l of qp are then the same to the bit, which makes CID symmetric to the bit; both
 *  ends are exactly p and q, and every sample of a segment of length 0 is p.
 *  \param[in] sample l, 0 to samples - 1
 *  \param[in] samples M, min_samples to max_samples */
inline Eigen::Vector3f
segmentSample(const Eigen::Vector3f& p,
              const Eigen::Vector3f& q,
              int sample,
              int samples)
{
  const double to_q = sample;
  const double to_p = samples - 1 - sample;
  return ((p.cast<double>() * to_p + q.cast<double>() * to_q) / (to_p + to_q))
      .cast<float>();
}

/** \brief CID_p(p, q | S) by Eq. 2: the largest d(x; S) over M equally spaced samples
 *  of the segment pq, both ends included.
 *
 *  Exact, yet most samples are never evaluated: any surface point n bounds d at all
 *  samples at once, d(x) <= |x - n| (*ours*). Memory is O(M).
 *  \param[in] field the surface S
 *  \param[in] p,q ends of the segment, metres, in the frame of the surface
 *  \param[in] samples M, min_samples to max_samples; not checked
 *  \param[in] limit give up as soon as the CID is known to be at least this
 *  \return the CID in metres if it is below \a limit, else some value that is at least
 *  \a limit and at most the CID. Never negative; the same bits for (p, q) and (q, p)
 *  unless given up. */
PCL_CID_EXPORT float
pointCID(const DistanceField& field,
         const Eigen::Vector3f& p,
         const Eigen::Vector3f& q,
         int samples,
         float limit = std::numeric_limits<float>::infinity());

/** \brief CID_p(p, q | S) by Eq. 1 itself: the largest d(x; S) over the whole segment,
 *  found by bisection where the 1-Lipschitz bound leaves room for a larger value
 *  (*ours*).
 *  \param[in] field the surface S
 *  \param[in] p,q ends of the segment, metres, in the frame of the surface
 *  \param[in] tolerance in metres, above 0; the coordinates are float, so a tolerance
 *  below their resolution ends where they do
 *  \return a value v with v <= CID_p <= v + tolerance
 *  \throws CIDException when the tolerance is not above 0
 *  \note Cost: at most about |pq| / tolerance queries; far fewer where d varies. */
PCL_CID_EXPORT float
continuousPointCID(const DistanceField& field,
                   const Eigen::Vector3f& p,
                   const Eigen::Vector3f& q,
                   float tolerance);

/** \brief CID_g(G_i, G_j | S) by Eq. 3: the mean of CID_p over all pairs of the two
 *  groups, added up in double, in the order of the groups. Symmetric up to that order.
 *  \param[in] field the surface S
 *  \param[in] first,second points of the two groups, or of samples of them; not empty
 *  \param[in] samples M of each pair, min_samples to max_samples; not checked
 *  \param[in] execution its progress; the work is done on the calling thread
 *  \throws CIDException when a group is empty, CIDCancelled */
PCL_CID_EXPORT double
groupCID(const DistanceField& field,
         const Points& first,
         const Points& second,
         int samples,
         const ExecutionOptions& execution = {});

} // namespace pcl_cid
