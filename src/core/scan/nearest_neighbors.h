/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest neighbors of every point of a set.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl_cid {

/** \brief The nearest neighbors of every point: eight, or as many as are wanted; fewer
 *  where there are not so many places with a point.
 *
 *  Neighbors are other places: points with equal coordinates, as merged scans have
 *  them, are one place, that of the first of them, and have the same neighbors. So a
 *  distance to a neighbor is never 0, and results do not change when the points of a
 *  cloud are doubled. At equal distance the place of lower index comes first.
 *
 *  Local spacing, isolated points and smooth colors all derive from the first eight,
 *  normals and the graph of the surface from the first sixteen and twelve. */
class NearestNeighbors {
public:
  /** The number of neighbors that are the near ones. */
  static constexpr std::size_t most_near = 8;
  /** The largest number that can be looked for. */
  static constexpr std::size_t most = 16;

  /** \brief Find the neighbors of every point.
   *  \param[in] points finite, metres
   *  \param[in] execution threads and progress; never change a result
   *  \param[in] wanted neighbors to look for, most_near to most
   *  \throws CIDCancelled
   *  \note Cost: O(N log N), 44 bytes a point while this object lives (76 with the most
   *  neighbors), and about twice that while it is made. */
  NearestNeighbors(const Points& points,
                   const ExecutionOptions& execution,
                   std::size_t wanted = most_near);

  /** \brief Number of points. */
  std::size_t
  size() const
  {
    return distances_.size();
  }

  /** \brief Neighbors of each point: as many as were wanted, or all other places. */
  std::size_t
  count() const
  {
    return count_;
  }

  /** \brief Those of them that are near: at most `most_near`. */
  std::size_t
  nearCount() const
  {
    return std::min(count_, most_near);
  }

  /** \brief The k-th nearest neighbor of a point, k from 0 to count() - 1. */
  pcl::index_t
  neighbor(std::size_t point, std::size_t k) const
  {
    return neighbors_[point * count_ + k];
  }

  /** \brief The first of the points that are where a point is: itself, unless it is
   *  repeated. */
  pcl::index_t
  firstAt(std::size_t point) const
  {
    return first_[point];
  }

  /** \brief A point of each place that has one, in the order of a kd-tree: those near
   *  each other in a row. Empty when there is only one place. */
  const pcl::Indices&
  places() const
  {
    return places_;
  }

  /** \brief Distance to the last near neighbor, metres; 0 where there is none. */
  float
  reach(std::size_t point) const
  {
    return distances_[point];
  }

private:
  std::size_t count_ = 0;
  pcl::Indices neighbors_; ///< count_ for each point, nearest first
  std::vector<float> distances_;
  pcl::Indices places_;
  pcl::Indices first_; ///< of the points at the same place
};

} // namespace pcl_cid
