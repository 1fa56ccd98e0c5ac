/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest neighbors of every point of a set.
 */

#include "base/parallel_for.h"
#include "base/rounding.h"
#include "field/block_tree.h"

#include "nearest_neighbors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <tuple>

namespace pcl_cid {
namespace {

/** Blocks that a thread takes at a time. */
constexpr std::size_t grain = 8;

/** \brief The places that have a point, and the points that are there. */
struct Places {
  Points positions;
  pcl::Indices first; ///< of the points there
  pcl::Indices place; ///< of each point
};

/** Places in the order of their first points. */
Places
findPlaces(const Points& points)
{
  struct Entry {
    Eigen::Vector3f position;
    pcl::index_t index;
  };
  std::vector<Entry> sorted;
  sorted.reserve(points.size());
  for (const Eigen::Vector3f& p : points)
    sorted.push_back({p, static_cast<pcl::index_t>(sorted.size())});
  std::sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.position.x(), a.position.y(), a.position.z(), a.index) <
           std::tie(b.position.x(), b.position.y(), b.position.z(), b.index);
  });
  pcl::Indices first_at(points.size()); // the first point where this point is
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const bool repeats = k > 0 && sorted[k].position == sorted[k - 1].position;
    first_at[static_cast<std::size_t>(sorted[k].index)] =
        repeats ? first_at[static_cast<std::size_t>(sorted[k - 1].index)]
                : sorted[k].index;
  }
  Places places;
  places.place.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto first = static_cast<std::size_t>(first_at[i]);
    if (first == i) {
      places.place[i] = static_cast<pcl::index_t>(places.first.size());
      places.first.push_back(first_at[i]);
      places.positions.push_back(points[i]);
    }
    else
      places.place[i] = places.place[first];
  }
  return places;
}

/** \brief The places nearest to a point so far, nearest first, equal distances by
 *  index.
 *
 *  A squared distance and an index are one whole number: the bits of floats that are
 *  not negative are in the order of their values. */
class NearestSoFar {
public:
  explicit NearestSoFar(std::size_t count) : count_(count) { keys_.fill(UINT64_MAX); }

  /** \brief The squared distance beyond which nothing counts. */
  float
  worst() const
  {
    const std::uint64_t last = keys_[count_ - 1];
    return last == UINT64_MAX ? std::numeric_limits<float>::infinity()
                              : squaredDistance(last);
  }

  void
  offer(float squared_distance, std::int32_t index)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &squared_distance, sizeof bits);
    const std::uint64_t key =
        (std::uint64_t{bits} << 32) | static_cast<std::uint32_t>(index);
    if (key >= keys_[count_ - 1])
      return;
    std::size_t k = count_ - 1;
    for (; k > 0 && keys_[k - 1] > key; --k)
      keys_[k] = keys_[k - 1];
    keys_[k] = key;
  }

  std::int32_t
  index(std::size_t k) const
  {
    return static_cast<std::int32_t>(keys_[k] & UINT32_MAX);
  }

private:
  static float
  squaredDistance(std::uint64_t key)
  {
    const auto bits = static_cast<std::uint32_t>(key >> 32);
    float squared_distance;
    std::memcpy(&squared_distance, &bits, sizeof bits);
    return squared_distance;
  }

  std::size_t count_;
  std::array<std::uint64_t, NearestNeighbors::most> keys_;
};

void
scan(const PointBlock& block,
     const Eigen::Vector3f& p,
     std::int32_t self,
     NearestSoFar& nearest)
{
  const auto squared = block.squaredDistances(p);
  for (int row = 0; row < block.count; ++row)
    if (squared[row] <= nearest.worst() && block.index[row] != self)
      nearest.offer(squared[row], block.index[row]);
}

/** Search the blocks below a node, except for one.
 *  \param[in] p padded */
void
descend(const BlockTree& tree,
        std::size_t node,
        std::size_t known_block,
        const Eigen::Array4f& p,
        std::int32_t self,
        NearestSoFar& nearest)
{
  if (tree.isBlock(node)) {
    if (node - tree.size() != known_block)
      scan(tree.block(node - tree.size()), p.matrix().head<3>(), self, nearest);
    return;
  }
  const float left = tree.box(2 * node).squaredDistance(p);
  const float right = tree.box(2 * node + 1).squaredDistance(p);
  const std::size_t near = right < left ? 2 * node + 1 : 2 * node;
  if (std::min(left, right) <= nearest.worst() * rounding::widening)
    descend(tree, near, known_block, p, self, nearest);
  if (std::max(left, right) <= nearest.worst() * rounding::widening)
    descend(tree, near ^ 1, known_block, p, self, nearest);
}

} // namespace

NearestNeighbors::NearestNeighbors(const Points& points,
                                   const ExecutionOptions& execution,
                                   std::size_t wanted)
{
  distances_.assign(points.size(), 0.0f);
  const Places places = findPlaces(points);
  for (const pcl::index_t place : places.place)
    first_.push_back(places.first[static_cast<std::size_t>(place)]);
  if (places.first.size() < 2)
    return;
  count_ = std::min(wanted, places.first.size() - 1);
  const int threads = threadCount(execution.threads);
  Progress progress(execution.progress);
  const BlockTree tree(places.positions, threads, progress);

  pcl::Indices of_place(places.first.size() * count_);
  const auto search = [&](std::size_t begin, std::size_t end) {
    for (std::size_t number = begin; number < end; ++number) {
      const PointBlock& block = tree.block(number);
      for (int row = 0; row < block.count; ++row) {
        const Eigen::Vector3f p = block.point(row);
        NearestSoFar nearest(count_);
        scan(block, p, block.index[row], nearest);
        descend(tree, 1, number, padded(p), block.index[row], nearest);
        const auto place = static_cast<std::size_t>(block.index[row]);
        for (std::size_t k = 0; k < count_; ++k)
          of_place[place * count_ + k] = nearest.index(k);
      }
    }
  };
  parallelFor(tree.size(), grain, threads, progress, {0.0, 1.0}, search);

  for (std::size_t number = 0; number < tree.size(); ++number)
    for (int row = 0; row < tree.block(number).count; ++row)
      places_.push_back(
          places.first[static_cast<std::size_t>(tree.block(number).index[row])]);
  neighbors_.resize(points.size() * count_);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto place = static_cast<std::size_t>(places.place[i]);
    for (std::size_t k = 0; k < count_; ++k)
      neighbors_[i * count_ + k] =
          places.first[static_cast<std::size_t>(of_place[place * count_ + k])];
    const auto last = static_cast<std::size_t>(neighbor(i, nearCount() - 1));
    distances_[i] = (points[i] - points[last]).norm();
  }
}

} // namespace pcl_cid
