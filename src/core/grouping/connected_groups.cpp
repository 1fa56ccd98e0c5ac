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
#include "base/joined_sets.h"
#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <tuple>
#include <utility>

namespace pcl_cid {
namespace {

/** The piece of each point, points of one group that edges join, by its lowest point.
 */
std::vector<std::uint32_t>
piecesOf(const SurfaceGraph& graph, const std::vector<pcl::index_t>& groups)
{
  return joinedSets(graph.size(), [&](const auto& join) {
    for (std::size_t p = 0; p < graph.size(); ++p)
      graph.forEachEdge(p, [&](std::size_t q) {
        if (groups[p] == groups[q])
          join(p, q);
      });
  });
}

/** Where an island meets another piece. */
struct Border {
  std::uint32_t island;
  std::uint32_t other;
  std::uint32_t point; ///< of the island

  bool
  operator<(const Border& right) const
  {
    return std::tie(island, other, point) <
           std::tie(right.island, right.other, right.point);
  }

  bool
  operator==(const Border& right) const
  {
    return std::tie(island, other, point) ==
           std::tie(right.island, right.other, right.point);
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

/** An island, its borders, and the best offer so far. */
struct Island {
  std::size_t begin; ///< of its borders
  std::size_t end;
  Offer best;
  bool joined = false;
};

class Connection {
public:
  Connection(const SurfaceGraph& graph,
             KnownCosts& costs,
             const pcl::Indices& seeds,
             std::vector<pcl::index_t>& groups)
  : costs_(costs)
  , seeds_(seeds)
  , groups_(groups)
  , pieces_(piecesOf(graph, groups))
  , is_mainland_(graph.size(), false)
  {
    for (const pcl::index_t seed : seeds)
      is_mainland_[pieces_[static_cast<std::size_t>(seed)]] = true;
    findBorders(graph);
    findIslands();
  }

  void
  run(int threads, Progress& progress)
  {
    parallelForEach(islands_.size(), threads, progress, {1.0, 1.0}, [&](std::size_t i) {
      SegmentSearch search = costs_.search();
      for (std::size_t k = islands_[i].begin; k < islands_[i].end; ++k)
        if (is_mainland_[borders_[k].other])
          offer(islands_[i], k, groups_[borders_[k].other], search);
    });
    joinCheapestFirst();
    for (std::size_t p = 0; p < groups_.size(); ++p)
      groups_[p] = groups_[pieces_[p]];
  }

private:
  void
  findBorders(const SurfaceGraph& graph)
  {
    const auto add = [&](std::size_t p, std::size_t q) {
      if (!is_mainland_[pieces_[p]])
        borders_.push_back({pieces_[p], pieces_[q], static_cast<std::uint32_t>(p)});
    };
    for (std::size_t p = 0; p < graph.size(); ++p)
      graph.forEachEdge(p, [&](std::size_t q) {
        if (pieces_[p] == pieces_[q])
          return;
        add(p, q);
        add(q, p);
      });
    std::sort(borders_.begin(), borders_.end());
    borders_.erase(std::unique(borders_.begin(), borders_.end()), borders_.end());
  }

  void
  findIslands()
  {
    for (std::size_t k = 0; k < borders_.size(); ++k)
      if (k > 0 && borders_[k].island == borders_[k - 1].island)
        islands_.back().end = k + 1;
      else
        islands_.push_back({k, k + 1, {}});
  }

  Island&
  islandOf(std::uint32_t piece)
  {
    return *std::lower_bound(islands_.begin(),
                             islands_.end(),
                             piece,
                             [&](const Island& island, std::uint32_t value) {
                               return borders_[island.begin].island < value;
                             });
  }

  /** The cost of a point at a border and the seed of a group, if it is the best so far.
   *  \return whether it is */
  bool
  offer(Island& island,
        std::size_t border,
        pcl::index_t group,
        SegmentSearch& search) const
  {
    const auto point = static_cast<std::size_t>(borders_[border].point);
    const auto seed = static_cast<std::size_t>(seeds_[static_cast<std::size_t>(group)]);
    // The next float up, as an equal cost may win, too.
    const float limit = std::nextafter(island.best.cost, infinity);
    const Offer offered{costs_.cost(seed, point, limit, search), group};
    if (!(offered < island.best))
      return false;
    island.best = offered;
    return true;
  }

  void
  joinCheapestFirst()
  {
    using Entry = std::pair<Offer, std::uint32_t>; // of an island, a number
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
      const std::uint32_t piece = borders_[island.begin].island;
      groups_[piece] = island.best.group;
      for (std::size_t k = island.begin; k < island.end; ++k) {
        const std::uint32_t other = borders_[k].other;
        if (is_mainland_[other] || (k > island.begin && other == borders_[k - 1].other))
          continue;
        Island& next = islandOf(other);
        if (!next.joined && offerAll(next, piece, island.best.group, search))
          queue.push({next.best, static_cast<std::uint32_t>(&next - islands_.data())});
      }
    }
  }

  /** Offer a group at each border with one of its pieces. */
  bool
  offerAll(Island& island,
           std::uint32_t piece,
           pcl::index_t group,
           SegmentSearch& search) const
  {
    bool is_better = false;
    for (std::size_t k = island.begin; k < island.end; ++k)
      if (borders_[k].other == piece)
        is_better = offer(island, k, group, search) || is_better;
    return is_better;
  }

  KnownCosts& costs_;
  const pcl::Indices& seeds_;
  std::vector<pcl::index_t>& groups_;
  const std::vector<std::uint32_t> pieces_;
  std::vector<bool> is_mainland_; ///< by piece: it has the seed
  std::vector<Border> borders_;   ///< of all islands, in their order
  std::vector<Island> islands_;   ///< in the order of their pieces
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
  Connection(graph, costs, seeds, groups).run(threads, progress);
  return groups;
}

} // namespace pcl_cid
