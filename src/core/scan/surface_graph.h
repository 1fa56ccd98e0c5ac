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
 *  each other in memory. *Runs* are successive vertices that hang together by edges
 *  among themselves: what holds for all points of a run, and of the next, need not be
 *  asked edge by edge. */
class SurfaceGraph {
public:
  using Vertex = std::uint32_t;

  static constexpr std::size_t most_edges = 12;

  /** From one vertex to before another. */
  struct Run {
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
  runs() const
  {
    return run_begin_.size() - 1;
  }

  /** \brief The runs follow one another: 0 begins with vertex 0. */
  Run
  run(std::size_t number) const
  {
    return {run_begin_[number], run_begin_[number + 1]};
  }

  /** \brief Call \a visit with each later run that an edge joins a run with. */
  template <typename Visit>
  void
  forEachLaterRun(std::size_t run, const Visit& visit) const
  {
    for (std::size_t k = links_begin_[run]; k < links_begin_[run + 1]; ++k)
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
  cutIntoRuns(const Listed& listed);

  void
  makeMutual(const Listed& listed, const std::vector<Vertex>& place);

  void
  linkRuns();

  pcl::Indices points_;            ///< by vertex
  std::vector<Vertex> vertices_;   ///< by point
  std::vector<std::size_t> begin_; ///< in ends_, of each vertex; one more at the end
  std::vector<Vertex> ends_;
  std::vector<Vertex> run_begin_;        ///< one more at the end
  std::vector<std::size_t> links_begin_; ///< in links_, of each run; one more
  std::vector<std::uint32_t> links_;     ///< runs
};

} // namespace pcl_cid
