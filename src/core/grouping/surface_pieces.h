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

#include <atomic>
#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief The *pieces* of groups: points of one group that edges join. The piece with
 *  the seed of its group is the *mainland*; every other one is an *island* and goes by
 *  its lowest vertex.
 *
 *  From one update to the next, only groups that gained or lost points are looked at.
 *  Of these, most runs are all of one group, *whole*, and in one piece by
 *  themselves: only the edges of the others are looked at one by one.
 *  \note Memory: about 8 bytes a point. */
class SurfacePieces {
public:
  using Vertex = SurfaceGraph::Vertex;

  /** The piece of all vertices that hang together with their seeds. */
  static constexpr Vertex mainland = UINT32_MAX;

  /** What an update changed. */
  struct Change {
    /** By the number that a seed had: the one it has, -1 where it is gone. Ascending
     *  without these: a seed that changed places with others counts as another one. */
    std::vector<pcl::index_t> number;
    /** Ascending: those that went to another group or piece. */
    std::vector<Vertex> vertices;
  };

  /** Before any update, all are in the group of no seed.
   *  \param[in] graph must outlive this */
  explicit SurfacePieces(const SurfaceGraph& graph);

  /** \brief Find the pieces of other groups. Where this throws, there are none.
   *  \param[in] seeds by number, indices among the points
   *  \param[in] groups the number of the seed of each point; that of a seed is its own
   */
  Change
  update(const pcl::Indices& seeds,
         const std::vector<pcl::index_t>& groups,
         int threads,
         Progress& progress);

  Vertex
  of(Vertex vertex) const
  {
    return lower_[vertex];
  }

  pcl::index_t
  groupOf(Vertex vertex) const
  {
    return groups_[vertex];
  }

private:
  /** By group: whether it gained or lost points. */
  using Touched = std::vector<std::atomic<bool>>;

  std::vector<pcl::index_t>
  renumber(const pcl::Indices& seeds);

  void
  takeOver(const std::vector<pcl::index_t>& groups,
           const std::vector<pcl::index_t>& number,
           Touched& touched,
           int threads,
           Progress& progress);

  void
  joinRuns(const Touched& touched, int threads, Progress& progress);

  void
  separate(std::size_t number, const Touched& touched);

  template <typename Visit>
  void
  forEachPair(std::size_t number, const Touched& touched, const Visit& visit) const;

  bool
  isTouched(Vertex vertex, const Touched& touched) const
  {
    return touched[static_cast<std::size_t>(groups_[vertex])];
  }

  Vertex
  lowest(Vertex vertex);

  void
  join(Vertex a, Vertex b);

  const SurfaceGraph& graph_;
  pcl::Indices seeds_;
  std::vector<pcl::index_t> groups_;   ///< by vertex
  std::vector<std::uint8_t> is_whole_; ///< by run
  /** By vertex: itself or a lower one of its piece; in the end the lowest, or that it
   *  is on the mainland. */
  std::vector<Vertex> lower_;
};

} // namespace pcl_cid
