/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Groups in one piece.
 */

#include "connected_groups.h"

#include "base/infinity.h"
#include "base/parallel_for.h"
#include "surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <tuple>
#include <utility>

namespace pcl_cid {
namespace {

using Vertex = SurfaceGraph::Vertex;

/** Islands that a thread takes at a time. */
constexpr std::size_t few_islands = 16;

/** Where an island meets another piece. */
struct Border {
  Vertex other;  ///< the piece
  Vertex vertex; ///< of the island

  bool
  operator<(const Border& right) const
  {
    return std::tie(other, vertex) < std::tie(right.other, right.vertex);
  }

  bool
  operator==(const Border& right) const
  {
    return other == right.other && vertex == right.vertex;
  }
};

/** A group that an island may go to. */
struct Offer {
  float cost = infinity;
  pcl::index_t group = -1;

  bool
  operator<(const Offer& right) const
  {
    return std::tie(cost, group) < std::tie(right.cost, right.group);
  }
};

/** A piece without a seed, its borders, and the best offer so far. */
struct Island {
  std::vector<Vertex> vertices;
  std::vector<Border> borders; ///< ascending
  Offer best{};
  bool joined = false;

  /** The borders with one piece. */
  template <typename Visit>
  void
  forEachBorderWith(Vertex other, const Visit& visit) const
  {
    for (auto border =
             std::lower_bound(borders.begin(), borders.end(), Border{other, 0});
         border != borders.end() && border->other == other;
         ++border)
      visit(*border);
  }
};

class Connection {
public:
  Connection(const SurfaceGraph& graph,
             KnownCosts& costs,
             const pcl::Indices& seeds,
             std::vector<pcl::index_t>& groups,
             int threads,
             Progress& progress)
  : graph_(graph)
  , costs_(costs)
  , seeds_(seeds)
  , groups_(groups)
  , pieces_(graph, groups, threads, progress)
  , island_of_(graph.size(), unknown)
  {
    for (const pcl::index_t seed : seeds)
      island_of_[pieces_.ofPoint(static_cast<std::size_t>(seed))] = mainland;
    findIslands();
  }

  void
  run(int threads, Progress& progress)
  {
    const auto offer_mainland = [&](std::size_t begin, std::size_t end) {
      SegmentSearch search = costs_.search();
      for (std::size_t i = begin; i < end; ++i) {
        findBorders(islands_[i]);
        for (const Border& border : islands_[i].borders)
          if (island_of_[border.other] == mainland)
            offer(islands_[i], border, groupOf(border.other), search);
      }
    };
    parallelFor(
        islands_.size(), few_islands, threads, progress, {1.0, 1.0}, offer_mainland);
    joinCheapestFirst();
  }

private:
  static constexpr std::uint32_t unknown = UINT32_MAX;
  static constexpr std::uint32_t mainland = UINT32_MAX - 1;

  pcl::index_t
  groupOf(Vertex vertex) const
  {
    return groups_[graph_.pointOf(vertex)];
  }

  void
  findIslands()
  {
    pieces_.forEachRun([&](SurfaceGraph::Patch run) {
      std::uint32_t& island = island_of_[pieces_.of(run.begin)];
      if (island == mainland)
        return;
      if (island == unknown) {
        island = static_cast<std::uint32_t>(islands_.size());
        islands_.emplace_back();
      }
      for (Vertex v = run.begin; v < run.end; ++v)
        islands_[island].vertices.push_back(v);
    });
  }

  void
  findBorders(Island& island) const
  {
    const Vertex piece = pieces_.of(island.vertices.front());
    std::vector<Border>& borders = island.borders;
    for (const Vertex v : island.vertices)
      graph_.forEachEdge(v, [&](Vertex q) {
        if (pieces_.of(q) != piece)
          borders.push_back({pieces_.of(q), v});
      });
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  }

  /** The cost of a point at a border and the seed of a group, if it is the best so far.
   *  \return whether it is */
  bool
  offer(Island& island,
        const Border& border,
        pcl::index_t group,
        SegmentSearch& search) const
  {
    const auto seed = static_cast<std::size_t>(seeds_[static_cast<std::size_t>(group)]);
    // The next float up, as an equal cost may win, too.
    const float limit = std::nextafter(island.best.cost, infinity);
    const std::size_t point = graph_.pointOf(border.vertex);
    const Offer offered{costs_.cost(seed, point, limit, search), group};
    if (!(offered < island.best))
      return false;
    island.best = offered;
    return true;
  }

  void
  joinCheapestFirst()
  {
    using Entry = std::pair<Offer, std::uint32_t>; // of an island, its number
    const auto later = [](const Entry& a, const Entry& b) { return b < a; };
    std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
    for (std::size_t i = 0; i < islands_.size(); ++i)
      if (islands_[i].best.group >= 0)
        queue.push({islands_[i].best, static_cast<std::uint32_t>(i)});
    SegmentSearch search = costs_.search();
    while (!queue.empty()) {
      Island& island = islands_[queue.top().second];
      queue.pop();
      if (std::exchange(island.joined, true))
        continue;
      for (const Vertex v : island.vertices)
        groups_[graph_.pointOf(v)] = island.best.group;
      for (std::size_t k = 0; k < island.borders.size(); ++k) {
        const Vertex other = island.borders[k].other;
        const std::uint32_t number = island_of_[other];
        if (number == mainland || (k > 0 && other == island.borders[k - 1].other))
          continue;
        Island& next = islands_[number];
        if (!next.joined && offerAll(next, island, search))
          queue.push({next.best, number});
      }
    }
  }

  /** Offer the group of another island at each border with that. */
  bool
  offerAll(Island& island, const Island& joined, SegmentSearch& search) const
  {
    bool is_better = false;
    const Vertex piece = pieces_.of(joined.vertices.front());
    island.forEachBorderWith(piece, [&](const Border& border) {
      is_better = offer(island, border, joined.best.group, search) || is_better;
    });
    return is_better;
  }

  const SurfaceGraph& graph_;
  KnownCosts& costs_;
  const pcl::Indices& seeds_;
  std::vector<pcl::index_t>& groups_;
  const SurfacePieces pieces_;
  std::vector<std::uint32_t> island_of_; ///< by piece: its number
  std::vector<Island> islands_;
};

} // namespace

std::vector<pcl::index_t>
connectGroups(const SurfaceGraph& graph,
              KnownCosts& costs,
              const pcl::Indices& seeds,
              std::vector<pcl::index_t> groups,
              int threads,
              Progress& progress)
{
  Connection(graph, costs, seeds, groups, threads, progress).run(threads, progress);
  return groups;
}

} // namespace pcl_cid
