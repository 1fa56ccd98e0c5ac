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
#include "island.h"
#include "surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <queue>
#include <unordered_map>
#include <utility>

namespace pcl_cid {
namespace {

using Vertex = SurfaceGraph::Vertex;

/** Islands that a thread takes at a time. */
constexpr std::size_t few_islands = 16;

/** Changed vertices that a thread takes at a time. */
constexpr std::size_t many_vertices = 4096;

/** Of islands that are kept, for each of the points, beside what the heap adds. */
constexpr std::size_t most_bytes = 30;

} // namespace

/** The islands of groups, and what became of them; kept for the next groups. */
class ConnectedGroups::Connection {
public:
  Connection(const SurfaceGraph& graph, KnownCosts& costs)
  : graph_(graph), costs_(costs), pieces_(graph)
  {
  }

  void
  connect(const pcl::Indices& seeds,
          std::vector<pcl::index_t>& groups,
          int threads,
          Progress& progress)
  {
    const SurfacePieces::Change change =
        pieces_.update(seeds, groups, threads, progress);
    forgetIslands();
    renumberOffers(change.number);
    const std::vector<Vertex> touched =
        touchedIslands(change.vertices, threads, progress);
    explore(touched, seeds, threads, progress);
    joinCheapestFirst(openAround(touched), seeds);
    for (const auto& [name, island] : islands_)
      if (island.best.group >= 0)
        for (const Vertex v : island.vertices)
          groups[graph_.pointOf(v)] = island.best.group;
  }

  /** Whether there are few enough islands to keep them. */
  bool
  isSmall() const
  {
    std::size_t bytes = 0;
    for (const auto& [name, island] : islands_)
      bytes += sizeof(name) + island.bytes();
    return bytes <= most_bytes * graph_.size();
  }

private:
  /** Those that are no pieces any more. */
  void
  forgetIslands()
  {
    for (auto island = islands_.begin(); island != islands_.end();)
      island = pieces_.of(island->first) == island->first ? std::next(island)
                                                          : islands_.erase(island);
  }

  void
  renumberOffers(const std::vector<pcl::index_t>& number)
  {
    for (auto& [name, island] : islands_) {
      island.of_mainland.renumber(number);
      island.best.renumber(number);
    }
  }

  /** The islands that vertices are on or next to, ascending: of all others, neither the
   *  vertices nor what they meet has changed. */
  std::vector<Vertex>
  touchedIslands(const std::vector<Vertex>& vertices,
                 int threads,
                 Progress& progress) const
  {
    std::vector<std::vector<Vertex>> by_range(vertices.size() / many_vertices + 1);
    const auto find_range = [&](std::size_t begin, std::size_t end) {
      std::vector<Vertex>& touched = by_range[begin / many_vertices];
      const auto touch = [&](Vertex v) {
        if (pieces_.of(v) != SurfacePieces::mainland)
          touched.push_back(pieces_.of(v));
      };
      for (std::size_t k = begin; k < end; ++k) {
        touch(vertices[k]);
        graph_.forEachEdge(vertices[k], touch);
      }
      sortOut(touched);
    };
    parallelFor(
        vertices.size(), many_vertices, threads, progress, {1.0, 1.0}, find_range);
    std::vector<Vertex> all;
    for (const std::vector<Vertex>& touched : by_range)
      all.insert(all.end(), touched.begin(), touched.end());
    sortOut(all);
    return all;
  }

  template <typename Value>
  static void
  sortOut(std::vector<Value>& values)
  {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  /** Find islands again. */
  void
  explore(const std::vector<Vertex>& names,
          const pcl::Indices& seeds,
          int threads,
          Progress& progress)
  {
    std::vector<Island*> islands;
    for (const Vertex name : names)
      islands.push_back(&islands_[name]);
    std::vector<std::uint8_t> reached(graph_.size(), 0); // bytes, for threads
    const auto explore_range = [&](std::size_t begin, std::size_t end) {
      SegmentSearch search = costs_.search();
      for (std::size_t k = begin; k < end; ++k)
        *islands[k] = islandAround(names[k], seeds, reached, search);
    };
    parallelFor(
        islands.size(), few_islands, threads, progress, {1.0, 1.0}, explore_range);
  }

  /** What an island is made of, meets, and is offered by the mainland around it.
   *  \param[in,out] reached by vertex: whether it is known to be of an island */
  Island
  islandAround(Vertex name,
               const pcl::Indices& seeds,
               std::vector<std::uint8_t>& reached,
               SegmentSearch& search) const
  {
    Island island;
    island.vertices.push_back(name);
    reached[name] = 1;
    std::vector<pcl::index_t> groups; // next to a vertex
    std::vector<std::pair<Vertex, Vertex>> sides;
    for (std::size_t k = 0; k < island.vertices.size(); ++k) {
      const Vertex v = island.vertices[k];
      groups.clear();
      graph_.forEachEdge(v, [&](Vertex q) {
        const Vertex piece = pieces_.of(q);
        if (piece == SurfacePieces::mainland)
          groups.push_back(pieces_.groupOf(q));
        else if (piece != name)
          sides.emplace_back(piece, v);
        else if (!std::exchange(reached[q], std::uint8_t{1}))
          island.vertices.push_back(q);
      });
      sortOut(groups);
      for (const pcl::index_t group : groups)
        offer(island.of_mainland, v, group, seeds, search);
    }
    sortOut(sides);
    island.meet(sides);
    island.vertices.shrink_to_fit();
    island.meetings.shrink_to_fit();
    island.borders.shrink_to_fit();
    return island;
  }

  /** The cost of a vertex of an island and the seed of a group, if it is the best so
   *  far. */
  void
  offer(Offer& best,
        Vertex vertex,
        pcl::index_t group,
        const pcl::Indices& seeds,
        SegmentSearch& search) const
  {
    const auto seed = static_cast<std::size_t>(seeds[static_cast<std::size_t>(group)]);
    const std::size_t point = graph_.pointOf(vertex);
    best = std::min(best, {costs_.cost(seed, point, limitOf(best), search), group});
  }

  /** What costs no less is no better: the next float up, as an equal cost may be. */
  static float
  limitOf(const Offer& best)
  {
    return std::nextafter(best.cost, infinity);
  }

  /** Islands and all that hang together with them: what they join may change. They are
   *  open again, with the offers of the mainland. */
  std::vector<Vertex>
  openAround(std::vector<Vertex> names)
  {
    const auto open = [](Island& island) {
      island.best = island.of_mainland;
      return !std::exchange(island.is_open, true);
    };
    for (const Vertex name : names)
      open(islands_.at(name));
    for (std::size_t k = 0; k < names.size(); ++k)
      for (const Meeting& meeting : islands_.at(names[k]).meetings)
        if (open(islands_.at(meeting.other)))
          names.push_back(meeting.other);
    return names;
  }

  void
  joinCheapestFirst(const std::vector<Vertex>& names, const pcl::Indices& seeds)
  {
    using Entry = std::pair<Offer, Vertex>; // of an island, its name
    const auto later = [](const Entry& a, const Entry& b) { return b < a; };
    std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
    for (const Vertex name : names)
      if (const Offer& best = islands_.at(name).best; best.group >= 0)
        queue.push({best, name});
    SegmentSearch search = costs_.search();
    while (!queue.empty()) {
      Island& island = islands_.at(queue.top().second);
      queue.pop();
      if (!std::exchange(island.is_open, false))
        continue;
      for (const Meeting& meeting : island.meetings) {
        Island& next = islands_.at(meeting.other);
        if (next.is_open && offerGroup(next, island, seeds, search))
          queue.push({next.best, meeting.other});
      }
    }
    for (const Vertex name : names) // those that nothing came next to
      islands_.at(name).is_open = false;
  }

  /** Offer the group that another island has joined.
   *  \return whether it is the best so far */
  bool
  offerGroup(Island& island,
             const Island& joined,
             const pcl::Indices& seeds,
             SegmentSearch& search) const
  {
    const pcl::index_t group = joined.best.group;
    const pcl::index_t seed = seeds[static_cast<std::size_t>(group)];
    const float limit = limitOf(island.best);
    Meeting& meeting = island.meetingWith(joined.vertices.front());
    if (!meeting.tells(seed, limit))
      compare(meeting, island, seed, limit, search);
    const Offer offered{meeting.low, group};
    if (!(offered < island.best))
      return false;
    island.best = offered;
    return true;
  }

  /** Find the least cost of a seed where islands meet, if it is below a limit. */
  void
  compare(Meeting& meeting,
          const Island& island,
          pcl::index_t seed,
          float limit,
          SegmentSearch& search) const
  {
    meeting.seed = seed;
    meeting.low = limit;
    for (std::size_t k = meeting.begin; k < island.endOf(meeting); ++k)
      meeting.low = std::min(meeting.low,
                             costs_.cost(static_cast<std::size_t>(seed),
                                         graph_.pointOf(island.borders[k]),
                                         meeting.low,
                                         search));
    meeting.is_exact = meeting.low < limit;
  }

  const SurfaceGraph& graph_;
  KnownCosts& costs_;
  SurfacePieces pieces_;
  std::unordered_map<Vertex, Island> islands_; ///< by name
};

ConnectedGroups::ConnectedGroups(const SurfaceGraph& graph,
                                 const WorkingPoints& points,
                                 int samples)
: graph_(graph), costs_(points, samples)
{
}

ConnectedGroups::~ConnectedGroups() = default;

/** What is kept, for something else to keep. */
std::unique_ptr<ConnectedGroups::Connection>
ConnectedGroups::exchange(std::unique_ptr<Connection> connection)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(last_, std::move(connection));
}

std::vector<pcl::index_t>
ConnectedGroups::connect(const pcl::Indices& seeds,
                         std::vector<pcl::index_t> groups,
                         int threads,
                         Progress& progress)
{
  if (seeds.empty())
    return groups; // there is nothing to be connected with
  // Nobody else has it now: what throws leaves nothing half done behind.
  std::unique_ptr<Connection> connection = exchange(nullptr);
  if (!connection)
    connection = std::make_unique<Connection>(graph_, costs_);
  connection->connect(seeds, groups, threads, progress);
  if (connection->isSmall())
    exchange(std::move(connection));
  return groups;
}

} // namespace pcl_cid
