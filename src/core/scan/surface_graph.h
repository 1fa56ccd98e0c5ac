/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points are next to each other on the surface.
 */

#pragma once

#include "nearest_neighbors.h"

#include <cstddef>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Edges from every point to its nearest neighbors (*ours*): at most twelve,
 *  none much longer than the spacing there, so that none crosses a gap, and to the
 * first of the points at the same place. An edge joins both of its points, though only
 * one of them may list it. */
class SurfaceGraph {
public:
  static constexpr std::size_t most_edges = 12;

  /** \param[in] points of the neighbors
   *  \param[in] neighbors at least most_edges of each point, where there are so many */
  SurfaceGraph(const Points& points, const NearestNeighbors& neighbors);

  std::size_t
  size() const
  {
    return begin_.size() - 1;
  }

  /** \brief Call \a visit with each point that a point lists. */
  template <typename Visit>
  void
  forEachEdge(std::size_t point, const Visit& visit) const
  {
    for (std::size_t k = begin_[point]; k < begin_[point + 1]; ++k)
      visit(static_cast<std::size_t>(ends_[k]));
  }

private:
  std::vector<std::size_t> begin_; ///< in ends_, of each point; one more at the end
  pcl::Indices ends_;
};

} // namespace pcl_cid
