/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points that the method works on, and how results carry over to all
 * others.
 */

#pragma once

#include "base/random.h"
#include <pcl_cid/core/distance_field.h>

#include <memory>
#include <vector>

namespace pcl_cid {

/** \brief Points of the surface S that are not grouped. */
struct SurfacePoints {
  /** S, about the origin of the points that are grouped; empty: these are S. */
  Points given;
  /** Further points of S in that case (the blind spot). */
  Points filling;
};

/** \brief The points that are grouped, or a random draw of them, with the surface that
 *  they are measured against.
 *
 *  Full resolution (the default) works on all the points. The paper's protocol (section
 *  V.A) is a draw of 20,000: those are the surface, the points that are grouped and the
 *  candidate seeds in one; every other point follows its Euclidean-nearest one. Below,
 *  a *position* counts the points of the set that was given, an *index* those of
 *  points(). */
class WorkingSet {
public:
  /** \brief Draw the set and build the field of its surface.
   *  \param[in] points the points to be grouped, `source` ascending; at least 1
   *  \param[in] surface S, unless it is the points drawn
   *  \param[in] options of the field; its threads and progress serve all of this
   *  \param[in] subsample points to draw; 0, or no fewer than there are, means all
   *  \param[in] always positions that must be drawn (a start, given seeds)
   *  \param[in,out] generator of the draw */
  WorkingSet(PointSet points,
             const SurfacePoints& surface,
             const DistanceField::Options& options,
             std::size_t subsample,
             const pcl::Indices& always,
             RandomGenerator& generator);

  const DistanceField&
  field() const
  {
    return *field_;
  }

  /** \brief The points to work on. */
  const Points&
  points() const
  {
    return position_.empty() ? all_.points : drawn_;
  }

  /** \brief Index in points() of the point at a position of the set given, -1 when it
   *  was not drawn. */
  pcl::index_t
  indexOf(pcl::index_t position) const;

  /** \brief Position, in the set given, of a point of points(). */
  pcl::index_t
  positionOf(pcl::index_t index) const
  {
    return position_.empty() ? index : position_[static_cast<std::size_t>(index)];
  }

  /** \brief The points that were given. */
  const PointSet&
  all() const
  {
    return all_;
  }

  /** \brief Values of points() become values of the whole input cloud: a point that was
   *  not drawn takes that of the one it follows.
   *  \param[in] values one for each of points()
   *  \param[in] cloud_size points of the input cloud
   *  \param[in] missing the value of a point that is invalid or not selected */
  template <typename Value>
  std::vector<Value>
  carryOn(const std::vector<Value>& values, std::size_t cloud_size, Value missing) const
  {
    std::vector<Value> carried(cloud_size, missing);
    for (std::size_t i = 0; i < all_.size(); ++i)
      carried[static_cast<std::size_t>(all_.source[i])] =
          values[position_.empty() ? i : static_cast<std::size_t>(follows_[i])];
    return carried;
  }

  /** \brief Index in the input cloud of a point of points(). */
  pcl::index_t
  cloudIndexOf(pcl::index_t index) const
  {
    return all_.source[static_cast<std::size_t>(positionOf(index))];
  }

private:
  void
  makeField(const SurfacePoints& surface, const DistanceField::Options& options);

  void
  findFollowed(bool surface_is_drawn, const ExecutionOptions& execution);

  PointSet all_;
  Points drawn_;          ///< empty when all points are worked on
  pcl::Indices position_; ///< of each point drawn, ascending
  pcl::Indices follows_;  ///< for each point given, index in drawn_
  std::unique_ptr<DistanceField> field_;
};

} // namespace pcl_cid
