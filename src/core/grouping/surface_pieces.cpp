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
#include <utility>

namespace pcl_cid {
namespace {

/** Patches that a thread takes at a time: few edges lead out of so many. */
constexpr std::size_t many_patches = 2048;

} // namespace

SurfacePieces::SurfacePieces(const SurfaceGraph& graph,
                             const std::vector<pcl::index_t>& groups,
                             int threads,
                             Progress& progress)
: graph_(graph), groups_(graph.size()), is_whole_(graph.patches()), lower_(graph.size())
{
  findWholePatches(groups, threads, progress);
  joinPatches(threads, progress);
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

/** Ranges of patches side by side, then the edges that lead from one to another. */
void
SurfacePieces::joinPatches(int threads, Progress& progress)
{
  using Pairs = std::vector<std::pair<Vertex, Vertex>>;
  std::vector<Pairs> across((graph_.patches() + many_patches - 1) / many_patches);
  const auto join_range = [&](std::size_t begin, std::size_t end) {
    const Vertex first = graph_.patch(begin).begin;
    const Vertex last = graph_.patch(end - 1).end;
    Pairs& leading_out = across[begin / many_patches];
    for (std::size_t number = begin; number < end; ++number)
      forEachPair(number, [&](Vertex v, Vertex q) {
        if (groups_[v] != groups_[q])
          return;
        if (q >= first && q < last)
          join(v, q);
        else
          leading_out.emplace_back(v, q);
      });
  };
  parallelFor(
      graph_.patches(), many_patches, threads, progress, {1.0, 1.0}, join_range);
  for (const Pairs& pairs : across)
    for (const auto& [v, q] : pairs)
      join(v, q);
}

/** A whole patch joins the whole ones next to it; the others join point by point, with
 *  whole ones, too. */
template <typename Visit>
void
SurfacePieces::forEachPair(std::size_t number, const Visit& visit) const
{
  const auto [first, last] = graph_.patch(number);
  if (is_whole_[number])
    graph_.forEachLaterPatch(number, [&, first = first](std::size_t later) {
      if (is_whole_[later])
        visit(first, graph_.patch(later).begin);
    });
  else
    for (Vertex v = first; v < last; ++v)
      graph_.forEachEdge(v, [&](Vertex q) { visit(v, q); });
}

SurfacePieces::Vertex
SurfacePieces::lowest(Vertex vertex)
{
  while (lower_[vertex] != vertex)
    vertex = lower_[vertex] = lower_[lower_[vertex]]; // halves the way of the next one
  return vertex;
}

/** Two vertices of one group that hang together. */
void
SurfacePieces::join(Vertex a, Vertex b)
{
  const Vertex low_a = lowest(a);
  const Vertex low_b = lowest(b);
  lower_[std::max(low_a, low_b)] = std::min(low_a, low_b);
}

} // namespace pcl_cid
