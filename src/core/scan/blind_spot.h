/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The floor under a scanner, which the scanner itself hides.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>
#include <pcl_cid/core/prepared_scan.h>

#include <optional>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief A disc of floor that was not seen. */
struct BlindSpot {
  /** On the floor, under the sensor. */
  Eigen::Vector3f center;
  /** Metres. */
  float radius;
  /** Points of the disc, on a square lattice with the spacing of the floor around it,
   *  but at most 100 along the radius. */
  Points filling;
};

/** \brief Look for the blind spot of a scanner that stands on the floor or drives over
 *  it (*ours*).
 *
 *  The scanner's mount and the end of its field of view hide a disc of floor under it.
 *  A segment across that disc is far from all points, though nothing says that the
 *  space is free: CID takes a floor around a scanner for a concave ring. With the
 *  filling as a part of the surface, it is a flat floor again.
 *
 *  There is a blind spot where
 *  - a plane, level to within 10 degrees, is the lowest that is seen around the sensor;
 *  - it is seen from about the same distance on, to within a quarter, in at least two
 *    thirds of all directions, 6 to 80 degrees from straight down;
 *  - nearer to the foot of the sensor nothing was seen past half of the way down: no
 *    floor, no platform, no pit (less than a tenth of the density of the floor around
 *    counts as nothing).
 *
 *  An even scan has none, wherever its origin is, as there is no round hole in its
 *  floor; nor has a single depth view, which does not see floor all around.
 *  \param[in] points of the scan, at least 1
 *  \param[in] sensor in their frame
 *  \param[in] execution its progress is asked for cancellation; threads do not matter
 *  \note O(N); at most 20,000 points, drawn the same way each time, take part in the
 *  search for the plane. */
std::optional<BlindSpot>
findBlindSpot(const Points& points,
              const SensorPose& sensor,
              const ExecutionOptions& execution);

} // namespace pcl_cid
