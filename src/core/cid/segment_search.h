/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The CID of one segment: whether it reaches a limit, bounds of it, its value.
 */

#pragma once

#include "sample_trail.h"
#include "segment_samples.h"

#include <pcl_cid/core/distance_field.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_cid {

/** \brief A segment whose CID is asked for. */
struct Segment {
  const Eigen::Vector3f& p;
  const Eigen::Vector3f& q;
  bool between_surface_points; ///< d is known to be 0 at both ends
};

/** \brief How tight an upper bound has to be. */
enum class UpperBound {
  quick, ///< exact distances only where they decide whether it is below a limit
  exact, ///< the CID itself
};

/** \brief Searches for the CID of segments, one after another, and keeps its memory
 *  from one to the next: there are millions of them. It serves one thread.
 *
 *  A *hint* is the sample to try first, since a single one that is far from the surface
 *  decides. A search sets it to the one that did, a good first guess for the next
 *  segment nearby. It never changes a result. */
class SegmentSearch {
public:
  /** \param[in] field the surface S; must outlive this
   *  \param[in] order of the M samples; must outlive this */
  SegmentSearch(const DistanceField& field, const SampleOrder& order)
  : field_(field), order_(order)
  {
  }

  /** \brief Until the next call, segments are from one point to points next to each
   *  other: what a search finds shortens the next one. It never changes a result.
   *  \param[in] origin names that point
   *  \return the hint that is left from the last time */
  std::size_t&
  follow(std::size_t origin);

  /** \brief Whether the CID reaches a limit, which is cheaper than computing the CID.
   *  \return bounds of the CID: the lower one is at least \a limit, or the upper one at
   *  most that and the CID less */
  DistanceBounds
  bounds(const Segment& segment, float limit, std::size_t& hint);

  /** \brief An upper bound of the CID; \a limit when the CID is not below that. */
  float
  upperBound(const Segment& segment, float limit, UpperBound how, std::size_t& hint);

  /** \brief The CID by Eq. 2 if it is below \a limit, else at least \a limit and at
   *  most the CID. */
  float
  pointCID(const Segment& segment, float limit, std::size_t& hint);

private:
  friend class SearchOfSegment;

  /** The surface point that a look at a sample brought. */
  struct Look {
    std::size_t sample;
    Eigen::Vector3f point;
    float distance; ///< of the two
  };

  const DistanceField& field_;
  const SampleOrder& order_;
  std::array<SampleTrail, 4> trails_; ///< of the last origins
  std::size_t last_ = 0;              ///< of them
  SampleTrail* trail_ = nullptr;      ///< that is followed
  Eigen::ArrayXf caps_;
  std::vector<Look> looks_; ///< as many as the largest level so far; never cleared
};

} // namespace pcl_cid
