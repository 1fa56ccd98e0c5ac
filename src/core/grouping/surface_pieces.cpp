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
#include <unordered_map>
#include <utility>

namespace pcl_cid {
namespace {

/** Runs that a thread takes at a time: few edges lead out of so many. */
constexpr std::size_t many_runs = 2048;

/** The piece of a vertex that went to another group, until it is found. */
constexpr SurfacePieces::Vertex not_found = SurfacePieces::mainland - 1;

/** No point is this seed. */
constexpr pcl::index_t no_seed = -1;

} // namespace

SurfacePieces::SurfacePieces(const SurfaceGraph& graph)
: graph_(graph)
, seeds_{no_seed}
, groups_(graph.size(), 0)
, is_whole_(graph.runs())
, lower_(graph.size(), not_found)
{
}

SurfacePieces::Change
SurfacePieces::update(const pcl::Indices& seeds,
                      const std::vector<pcl::index_t>& groups,
                      int threads,
                      Progress& progress)
{
  Change change{renumber(seeds), {}};
  Touched touched(seeds.size());
  takeOver(groups, change.number, touched, threads, progress);
  const std::vector<Vertex> before = lower_;
  joinRuns(touched, threads, progress);
  for (std::size_t number = 0; number < seeds.size(); ++number)
    if (touched[number])
      lower_[lowest(graph_.vertexOf(static_cast<std::size_t>(seeds[number])))] =
          mainland;
  for (Vertex v = 0; v < lower_.size(); ++v) {
    if (!isTouched(v, touched))
      continue;
    if (lower_[v] != mainland)
      lower_[v] = lower_[lower_[v]]; // those below are done
    if (lower_[v] != before[v])
      change.vertices.push_back(v);
  }
  return change;
}

/** \return Change::number */
std::vector<pcl::index_t>
SurfacePieces::renumber(const pcl::Indices& seeds)
{
  std::unordered_map<pcl::index_t, pcl::index_t> number_of;
  for (std::size_t k = 0; k < seeds.size(); ++k)
    number_of[seeds[k]] = static_cast<pcl::index_t>(k);
  std::vector<pcl::index_t> numbers;
  pcl::index_t last = -1;
  for (const pcl::index_t seed : std::exchange(seeds_, seeds)) {
    const auto found = number_of.find(seed);
    const bool stays = found != number_of.end() && found->second > last;
    numbers.push_back(stays ? found->second : -1);
    if (stays)
      last = found->second;
  }
  return numbers;
}

/** The groups, which runs are whole, and what changed. */
void
SurfacePieces::takeOver(const std::vector<pcl::index_t>& groups,
                        const std::vector<pcl::index_t>& number,
                        Touched& touched,
                        int threads,
                        Progress& progress)
{
  const auto touch = [&](pcl::index_t group) {
    if (group >= 0 && !touched[static_cast<std::size_t>(group)])
      touched[static_cast<std::size_t>(group)] = true;
  };
  const auto take_range = [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) {
      const auto [first, last] = graph_.run(run);
      bool is_whole = true;
      for (Vertex v = first; v < last; ++v) {
        const pcl::index_t before = number[static_cast<std::size_t>(groups_[v])];
        groups_[v] = groups[graph_.pointOf(v)];
        is_whole = is_whole && groups_[v] == groups_[first];
        if (groups_[v] == before)
          continue;
        touch(before);
        touch(groups_[v]);
        lower_[v] = not_found;
      }
      is_whole_[run] = is_whole;
    }
  };
  parallelFor(graph_.runs(), many_runs, threads, progress, {1.0, 1.0}, take_range);
}

/** Ranges of runs side by side, then the edges that lead from one to another. */
void
SurfacePieces::joinRuns(const Touched& touched, int threads, Progress& progress)
{
  using Pairs = std::vector<std::pair<Vertex, Vertex>>;
  std::vector<Pairs> across((graph_.runs() + many_runs - 1) / many_runs);
  const auto join_range = [&](std::size_t begin, std::size_t end) {
    const Vertex first = graph_.run(begin).begin;
    const Vertex last = graph_.run(end - 1).end;
    Pairs& leading_out = across[begin / many_runs];
    for (std::size_t number = begin; number < end; ++number)
      separate(number, touched);
    for (std::size_t number = begin; number < end; ++number)
      forEachPair(number, touched, [&](Vertex v, Vertex q) {
        if (groups_[v] != groups_[q])
          return;
        if (q >= first && q < last)
          join(v, q);
        else
          leading_out.emplace_back(v, q);
      });
  };
  parallelFor(graph_.runs(), many_runs, threads, progress, {1.0, 1.0}, join_range);
  for (const Pairs& pairs : across)
    for (const auto& [v, q] : pairs)
      join(v, q);
}

/** The touched vertices of a run are in pieces of their own, or, if it is whole, in
 *  one. */
void
SurfacePieces::separate(std::size_t number, const Touched& touched)
{
  const auto [first, last] = graph_.run(number);
  for (Vertex v = first; v < last; ++v)
    if (isTouched(v, touched))
      lower_[v] = is_whole_[number] ? first : v;
}

/** A whole run joins the whole ones next to it; the others join point by point, with
 *  whole ones, too. */
template <typename Visit>
void
SurfacePieces::forEachPair(std::size_t number,
                           const Touched& touched,
                           const Visit& visit) const
{
  const auto [first, last] = graph_.run(number);
  if (is_whole_[number]) {
    if (isTouched(first, touched))
      graph_.forEachLaterRun(number, [&, first = first](std::size_t later) {
        if (is_whole_[later])
          visit(first, graph_.run(later).begin);
      });
    return;
  }
  for (Vertex v = first; v < last; ++v)
    if (isTouched(v, touched))
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
  if (lower_[a] == lower_[b])
    return; // most often they are joined already
  const Vertex low_a = lowest(a);
  const Vertex low_b = lowest(b);
  lower_[std::max(low_a, low_b)] = std::min(low_a, low_b);
}

} // namespace pcl_cid
