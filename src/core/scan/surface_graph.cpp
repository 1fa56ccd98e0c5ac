/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points are next to each other on the surface.
 */

#include "surface_graph.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace pcl_cid {
namespace {

/** Times the distance of the last near neighbor, which is about 1.6 spacings of an even
 *  surface: edges of three spacings. */
constexpr float longest_edge = 2.0f;

/** Points of a run at most: more are seldom of one group, fewer spare less. */
constexpr std::uint32_t most_of_run = 32;

} // namespace

SurfaceGraph::SurfaceGraph(const Points& points, const NearestNeighbors& neighbors)
{
  order(neighbors);
  const Listed listed = listEdges(points, neighbors);
  makeMutual(listed, cutIntoRuns(listed));
  linkRuns();
}

/** Points that are near each other in a row, those at one place together. */
void
SurfaceGraph::order(const NearestNeighbors& neighbors)
{
  const std::size_t all = neighbors.size();
  std::vector<std::size_t> turn(all, 0); // of the place that a point is the first of
  for (std::size_t k = 0; k < neighbors.places().size(); ++k)
    turn[static_cast<std::size_t>(neighbors.places()[k])] = k;
  const auto turnOf = [&](std::size_t point) {
    return turn[static_cast<std::size_t>(neighbors.firstAt(point))];
  };
  std::vector<std::size_t> next(all + 1, 0); // vertex of each turn
  for (std::size_t i = 0; i < all; ++i)
    ++next[turnOf(i) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  points_.resize(all);
  vertices_.resize(all);
  for (std::size_t i = 0; i < all; ++i) {
    vertices_[i] = static_cast<Vertex>(next[turnOf(i)]++);
    points_[vertices_[i]] = static_cast<pcl::index_t>(i);
  }
}

SurfaceGraph::Listed
SurfaceGraph::listEdges(const Points& points, const NearestNeighbors& neighbors) const
{
  const std::size_t edges = std::min(most_edges, neighbors.count());
  Listed listed;
  listed.begin.reserve(size() + 1);
  listed.ends.reserve(size() * edges);
  const auto add = [&](pcl::index_t q) {
    listed.ends.push_back(vertexOf(static_cast<std::size_t>(q)));
  };
  for (Vertex v = 0; v < size(); ++v) {
    listed.begin.push_back(listed.ends.size());
    const std::size_t i = pointOf(v);
    if (neighbors.firstAt(i) != static_cast<pcl::index_t>(i))
      add(neighbors.firstAt(i));
    const float longest = longest_edge * neighbors.reach(i);
    for (std::size_t k = 0; k < edges; ++k) {
      const pcl::index_t q = neighbors.neighbor(i, k);
      if ((points[i] - points[static_cast<std::size_t>(q)]).norm() > longest)
        break; // they are in the order of their distances
      add(q);
    }
  }
  listed.begin.push_back(listed.ends.size());
  return listed;
}

/** A run is what hangs together of a few vertices in a row; they change places so
 *  that it is a run.
 *  \return the new place of each vertex */
std::vector<SurfaceGraph::Vertex>
SurfaceGraph::cutIntoRuns(const Listed& listed)
{
  std::vector<Vertex> place(size());
  for (Vertex begin = 0; begin < size(); begin += most_of_run) {
    const Vertex count = std::min(most_of_run, static_cast<Vertex>(size()) - begin);
    std::array<Vertex, most_of_run> lowest; // of the run of each of the vertices
    std::iota(lowest.begin(), lowest.end(), Vertex{0});
    for (Vertex k = 0; k < count; ++k)
      listed.forEach(begin + k, [&](Vertex q) {
        if (q < begin || q >= begin + count)
          return;
        const Vertex low = std::min(lowest[k], lowest[q - begin]);
        const Vertex high = std::max(lowest[k], lowest[q - begin]);
        if (low != high)
          std::replace(lowest.begin(), lowest.begin() + count, high, low);
      });
    Vertex next = begin;
    for (Vertex first = 0; first < count; ++first) {
      if (lowest[first] != first)
        continue;
      run_begin_.push_back(next);
      for (Vertex k = first; k < count; ++k)
        if (lowest[k] == first)
          place[begin + k] = next++;
    }
  }
  run_begin_.push_back(static_cast<Vertex>(size()));
  return place;
}

/** Vertices take their new places, and each edge is listed by both of its ends, once.
 */
void
SurfaceGraph::makeMutual(const Listed& listed, const std::vector<Vertex>& place)
{
  for (Vertex& vertex : vertices_)
    vertex = place[vertex];
  for (std::size_t i = 0; i < size(); ++i)
    points_[vertexOf(i)] = static_cast<pcl::index_t>(i);
  const auto forEachEnd = [&](const auto& visit) {
    for (Vertex v = 0; v < size(); ++v)
      listed.forEach(v, [&](Vertex q) {
        visit(place[v], place[q]);
        if (!listed.has(q, v))
          visit(place[q], place[v]);
      });
  };
  begin_.assign(size() + 1, 0);
  forEachEnd([&](Vertex v, Vertex) { ++begin_[v + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  ends_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  forEachEnd([&](Vertex v, Vertex end) { ends_[next[v]++] = end; });
}

void
SurfaceGraph::linkRuns()
{
  std::vector<std::uint32_t> run_of(size());
  for (std::size_t number = 0; number < runs(); ++number)
    std::fill(run_of.begin() + run(number).begin,
              run_of.begin() + run(number).end,
              static_cast<std::uint32_t>(number));
  links_begin_.push_back(0);
  for (std::size_t number = 0; number < runs(); ++number) {
    const auto first = static_cast<std::ptrdiff_t>(links_.size());
    for (Vertex v = run(number).begin; v < run(number).end; ++v)
      forEachEdge(v, [&](Vertex q) {
        if (run_of[q] > number)
          links_.push_back(run_of[q]);
      });
    std::sort(links_.begin() + first, links_.end());
    links_.erase(std::unique(links_.begin() + first, links_.end()), links_.end());
    links_begin_.push_back(links_.size());
  }
  links_.shrink_to_fit();
}

} // namespace pcl_cid
