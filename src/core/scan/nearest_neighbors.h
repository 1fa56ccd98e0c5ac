/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest neighbours of every point of a set.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <vector>

namespace pcl_cid {

/** \brief The nearest neighbours of every point: eight, or fewer where there are not
 *  nine places with a point.
 *
 *  Neighbours are other places: points with equal coordinates, as merged scans have
 *  them, are one place, that of the first of them, and have the same neighbours. So a
 *  distance to a neighbour is never 0, and what is said about a cloud does not change
 *  when its points are doubled. At equal distance the place of lower index comes first.
 *
 *  Local spacing, isolated points and smooth colours are all read off one of these. */
class NearestNeighbors {
public:
  /** The number of neighbours looked for. */
  static constexpr std::size_t most = 8;

  /** \brief Find the neighbours of every point.
   *  \param[in] points finite, metres
   *  \param[in] execution threads and progress; never change a result
   *  \throws CIDCancelled
   *  \note Cost: O(N log N), 36 bytes a point while this object lives, and about twice
   *  that while it is made. */
  NearestNeighbors(const Points& points, const ExecutionOptions& execution);

  /** \brief Number of points. */
  std::size_t
  size() const
  {
    return distances_.size();
  }

  /** \brief Neighbours of each point: `most`, or all other places. */
  std::size_t
  count() const
  {
    return count_;
  }

  /** \brief The k-th nearest neighbour of a point, k from 0 to count() - 1. */
  pcl::index_t
  neighbor(std::size_t point, std::size_t k) const
  {
    return neighbors_[point * count_ + k];
  }

  /** \brief Distance to the last neighbour, metres; 0 where there is none. */
  float
  reach(std::size_t point) const
  {
    return distances_[point];
  }

private:
  std::size_t count_ = 0;
  pcl::Indices neighbors_; ///< count_ for each point, nearest first
  std::vector<float> distances_;
};

} // namespace pcl_cid
