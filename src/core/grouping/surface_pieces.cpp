/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points of a group hang together.
 */

#include "surface_pieces.h"

#include <algorithm>

namespace pcl_cid {
namespace {

/** Patches that a thread looks at at a time. */
constexpr std::size_t many_patches = 1024;

} // namespace

SurfacePieces::SurfacePieces(const SurfaceGraph& graph,
                             const std::vector<pcl::index_t>& groups,
                             int threads,
                             Progress& progress)
: graph_(graph), groups_(graph.size()), is_whole_(graph.patches()), lower_(graph.size())
{
  findWholePatches(groups, threads, progress);
  for (std::size_t number = 0; number < graph_.patches(); ++number)
    joinPatch(number);
  for (Vertex& lower : lower_) // those below are done
    lower = lower_[lower];
}

void
SurfacePieces::findWholePatches(const std::vector<pcl::index_t>& groups,
                                int threads,
                                Progress& progress)
{
  const auto find_range = [&](std::size_t begin, std::size_t end) {
    for (std::size_t number = begin; number < end; ++number) {
      const auto [first, last] = graph_.patch(number);
      bool is_whole = true;
      for (Vertex v = first; v < last; ++v) {
        groups_[v] = groups[graph_.pointOf(v)];
        is_whole = is_whole && groups_[v] == groups_[first];
      }
      is_whole_[number] = is_whole;
      for (Vertex v = first; v < last; ++v)
        lower_[v] = is_whole ? first : v;
    }
  };
  parallelFor(
      graph_.patches(), many_patches, threads, progress, {1.0, 1.0}, find_range);
}

/** A whole patch joins the whole ones next to it; the others join point by point, with
 *  whole ones, too. */
void
SurfacePieces::joinPatch(std::size_t number)
{
  const auto [first, last] = graph_.patch(number);
  if (is_whole_[number]) {
    graph_.forEachLaterPatch(number, [&](std::size_t later) {
      if (is_whole_[later])
        join(first, graph_.patch(later).begin);
    });
    return;
  }
  for (Vertex v = first; v < last; ++v)
    graph_.forEachEdge(v, [&](Vertex q) { join(v, q); });
}

SurfacePieces::Vertex
SurfacePieces::lowest(Vertex vertex)
{
  while (lower_[vertex] != vertex)
    vertex = lower_[vertex] = lower_[lower_[vertex]]; // halves the way of the next one
  return vertex;
}

/** Two vertices that an edge joins, if they are of one group. */
void
SurfacePieces::join(Vertex a, Vertex b)
{
  if (groups_[a] != groups_[b])
    return;
  const Vertex low_a = lowest(a);
  const Vertex low_b = lowest(b);
  lower_[std::max(low_a, low_b)] = std::min(low_a, low_b);
}

} // namespace pcl_cid
