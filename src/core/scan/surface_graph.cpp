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

/** Points of a patch at most: more are seldom of one group, fewer spare less. */
constexpr std::size_t most_of_patch = 32;

} // namespace

SurfaceGraph::SurfaceGraph(const Points& points, const NearestNeighbors& neighbors)
{
  const Listed listed = listEdges(points, neighbors);
  order(neighbors);
  cutIntoPatches(listed);
  setVertices();
  makeMutual(listed);
  linkPatches();
}

SurfaceGraph::Listed
SurfaceGraph::listEdges(const Points& points, const NearestNeighbors& neighbors)
{
  const std::size_t edges = std::min(most_edges, neighbors.count());
  Listed listed;
  listed.begin.reserve(points.size() + 1);
  listed.ends.reserve(points.size() * edges);
  for (std::size_t i = 0; i < points.size(); ++i) {
    listed.begin.push_back(listed.ends.size());
    if (neighbors.firstAt(i) != static_cast<pcl::index_t>(i))
      listed.ends.push_back(neighbors.firstAt(i));
    const float longest = longest_edge * neighbors.reach(i);
    for (std::size_t k = 0; k < edges; ++k) {
      const pcl::index_t q = neighbors.neighbor(i, k);
      if ((points[i] - points[static_cast<std::size_t>(q)]).norm() > longest)
        break; // they are in the order of their distances
      listed.ends.push_back(q);
    }
  }
  listed.begin.push_back(listed.ends.size());
  return listed;
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
  for (std::size_t i = 0; i < all; ++i)
    points_[next[turnOf(i)]++] = static_cast<pcl::index_t>(i);
  setVertices();
}

void
SurfaceGraph::setVertices()
{
  vertices_.resize(size());
  for (Vertex v = 0; v < size(); ++v)
    vertices_[pointOf(v)] = v;
}

/** A patch is what hangs together of a few vertices in a row; they change places so
 *  that it is a run. */
void
SurfaceGraph::cutIntoPatches(const Listed& listed)
{
  std::array<Vertex, most_of_patch> lowest; // of the patch of each of the vertices
  for (std::size_t begin = 0; begin < size(); begin += most_of_patch) {
    const std::size_t count = std::min(most_of_patch, size() - begin);
    std::iota(lowest.begin(), lowest.begin() + count, Vertex{0});
    const auto join = [&](Vertex a, Vertex b) {
      const Vertex low = std::min(lowest[a], lowest[b]);
      const Vertex high = std::max(lowest[a], lowest[b]);
      std::replace(lowest.begin(), lowest.begin() + count, high, low);
    };
    for (std::size_t k = 0; k < count; ++k)
      listed.forEach(points_[begin + k], [&](pcl::index_t q) {
        const std::size_t other = vertexOf(static_cast<std::size_t>(q)) - begin;
        if (other < count && lowest[other] != lowest[k]) // wraps around below `begin`
          join(static_cast<Vertex>(k), static_cast<Vertex>(other));
      });
    std::array<std::pair<Vertex, pcl::index_t>, most_of_patch> sorted;
    for (std::size_t k = 0; k < count; ++k)
      sorted[k] = {lowest[k], points_[begin + k]};
    std::stable_sort(sorted.begin(), sorted.begin() + count, [](auto& a, auto& b) {
      return a.first < b.first;
    });
    for (std::size_t k = 0; k < count; ++k) {
      points_[begin + k] = sorted[k].second;
      if (k == 0 || sorted[k].first != sorted[k - 1].first)
        patch_begin_.push_back(static_cast<Vertex>(begin + k));
    }
  }
  patch_begin_.push_back(static_cast<Vertex>(size()));
}

/** Each edge is listed by both of its vertices, once. */
void
SurfaceGraph::makeMutual(const Listed& listed)
{
  const auto forEachEnd = [&](const auto& visit) {
    for (std::size_t v = 0; v < size(); ++v)
      listed.forEach(points_[v], [&](pcl::index_t q) {
        visit(v, vertexOf(static_cast<std::size_t>(q)));
        if (!listed.has(q, points_[v]))
          visit(vertexOf(static_cast<std::size_t>(q)), static_cast<Vertex>(v));
      });
  };
  begin_.assign(size() + 1, 0);
  forEachEnd([&](std::size_t v, Vertex) { ++begin_[v + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  ends_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  forEachEnd([&](std::size_t v, Vertex end) { ends_[next[v]++] = end; });
}

void
SurfaceGraph::linkPatches()
{
  std::vector<std::uint32_t> patch_of(size());
  for (std::size_t number = 0; number < patches(); ++number)
    std::fill(patch_of.begin() + patch(number).begin,
              patch_of.begin() + patch(number).end,
              static_cast<std::uint32_t>(number));
  links_begin_.push_back(0);
  for (std::size_t number = 0; number < patches(); ++number) {
    const auto first = static_cast<std::ptrdiff_t>(links_.size());
    for (Vertex v = patch(number).begin; v < patch(number).end; ++v)
      forEachEdge(v, [&](Vertex q) {
        if (patch_of[q] > number)
          links_.push_back(patch_of[q]);
      });
    std::sort(links_.begin() + first, links_.end());
    links_.erase(std::unique(links_.begin() + first, links_.end()), links_.end());
    links_begin_.push_back(links_.size());
  }
  links_.shrink_to_fit();
}

} // namespace pcl_cid
