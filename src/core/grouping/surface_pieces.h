/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points of a group hang together.
 */

#pragma once

#include "base/parallel_for.h"
#include "scan/surface_graph.h"

#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief The *pieces* of groups: points of one group that edges join. A piece goes by
 *  its lowest vertex.
 *
 *  Most patches are all of one group, *whole*, and in one piece by themselves: only the
 *  edges of the others are looked at one by one. */
class SurfacePieces {
public:
  using Vertex = SurfaceGraph::Vertex;

  /** \param[in] graph must outlive this
   *  \param[in] groups of each point */
  SurfacePieces(const SurfaceGraph& graph,
                const std::vector<pcl::index_t>& groups,
                int threads,
                Progress& progress);

  Vertex
  of(Vertex vertex) const
  {
    return lower_[vertex];
  }

  Vertex
  ofPoint(std::size_t point) const
  {
    return of(graph_.vertexOf(point));
  }

  /** \brief Call \a visit with runs of vertices, each of one piece, that make up all
   *  vertices in their order. */
  template <typename Visit>
  void
  forEachRun(const Visit& visit) const
  {
    for (std::size_t number = 0; number < graph_.patches(); ++number) {
      const SurfaceGraph::Patch patch = graph_.patch(number);
      if (is_whole_[number])
        visit(patch);
      else
        for (Vertex v = patch.begin; v < patch.end; ++v)
          visit(SurfaceGraph::Patch{v, v + 1});
    }
  }

private:
  void
  findWholePatches(const std::vector<pcl::index_t>& groups,
                   int threads,
                   Progress& progress);

  void
  joinPatches(int threads, Progress& progress);

  template <typename Visit>
  void
  forEachPair(std::size_t number, const Visit& visit) const;

  Vertex
  lowest(Vertex vertex);

  void
  join(Vertex a, Vertex b);

  const SurfaceGraph& graph_;
  std::vector<pcl::index_t> groups_;   ///< by vertex
  std::vector<std::uint8_t> is_whole_; ///< by patch
  /** By vertex: itself or a lower one of its piece; in the end the lowest. */
  std::vector<Vertex> lower_;
};

} // namespace pcl_cid
