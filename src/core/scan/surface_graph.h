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
#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Edges from every point to its nearest neighbors (*ours*): at most twelve,
 *  none much longer than the spacing there, so that none crosses a gap, and to the
 *  first of the points at the same place. An edge joins both of its points, and both
 *  list it.
 *
 *  The graph goes by *vertices*: the points in an order in which neighbors are close to
 *  each other in memory. *Patches* are runs of vertices that hang together by edges
 *  among themselves: what holds for all points of a patch, and of the next, need not be
 *  asked edge by edge. */
class SurfaceGraph {
public:
  using Vertex = std::uint32_t;

  static constexpr std::size_t most_edges = 12;

  /** A run of vertices. */
  struct Patch {
    Vertex begin;
    Vertex end;
  };

  /** \param[in] points of the neighbors
   *  \param[in] neighbors at least most_edges of each point, where there are so many */
  SurfaceGraph(const Points& points, const NearestNeighbors& neighbors);

  /** \brief Number of points, and of vertices. */
  std::size_t
  size() const
  {
    return points_.size();
  }

  /** \brief The point of a vertex. */
  std::size_t
  pointOf(Vertex vertex) const
  {
    return static_cast<std::size_t>(points_[vertex]);
  }

  /** \brief The vertex of a point. */
  Vertex
  vertexOf(std::size_t point) const
  {
    return vertices_[point];
  }

  /** \brief Call \a visit with each vertex that an edge joins a vertex with. */
  template <typename Visit>
  void
  forEachEdge(Vertex vertex, const Visit& visit) const
  {
    for (std::size_t k = begin_[vertex]; k < begin_[vertex + 1]; ++k)
      visit(ends_[k]);
  }

  std::size_t
  patches() const
  {
    return patch_begin_.size() - 1;
  }

  /** \brief The patches follow one another: 0 begins with vertex 0. */
  Patch
  patch(std::size_t number) const
  {
    return {patch_begin_[number], patch_begin_[number + 1]};
  }

  /** \brief Call \a visit with each later patch that an edge joins a patch with. */
  template <typename Visit>
  void
  forEachLaterPatch(std::size_t patch, const Visit& visit) const
  {
    for (std::size_t k = links_begin_[patch]; k < links_begin_[patch + 1]; ++k)
      visit(static_cast<std::size_t>(links_[k]));
  }

private:
  /** Edges as points list them, not yet mutual, by vertex. */
  struct Listed {
    std::vector<std::size_t> begin; ///< in ends, of each vertex; one more at the end
    std::vector<Vertex> ends;

    template <typename Visit>
    void
    forEach(Vertex vertex, const Visit& visit) const
    {
      for (std::size_t k = begin[vertex]; k < begin[vertex + 1]; ++k)
        visit(ends[k]);
    }

    bool
    has(Vertex vertex, Vertex end) const
    {
      bool found = false;
      forEach(vertex, [&](Vertex q) { found = found || q == end; });
      return found;
    }
  };

  void
  order(const NearestNeighbors& neighbors);

  Listed
  listEdges(const Points& points, const NearestNeighbors& neighbors) const;

  std::vector<Vertex>
  cutIntoPatches(const Listed& listed);

  void
  makeMutual(const Listed& listed, const std::vector<Vertex>& place);

  void
  linkPatches();

  pcl::Indices points_;            ///< by vertex
  std::vector<Vertex> vertices_;   ///< by point
  std::vector<std::size_t> begin_; ///< in ends_, of each vertex; one more at the end
  std::vector<Vertex> ends_;
  std::vector<Vertex> patch_begin_;      ///< one more at the end
  std::vector<std::size_t> links_begin_; ///< in links_, of each patch; one more
  std::vector<std::uint32_t> links_;     ///< patches
};

} // namespace pcl_cid
