/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The point of a region that is farthest from what is outside.
 */

#include "base/parallel_for.h"

#include "inmost_point.h"

#include <algorithm>
#include <limits>

namespace pcl_cid {

InmostPoints::InmostPoints(const Points& points, const BlockTree& tree)
: points_(points)
, tree_(tree)
, region_(points.size())
, region_of_node_(2 * tree.size(), several)
{
}

std::vector<InmostPoint>
InmostPoints::of(const std::vector<pcl::Indices>& regions, unsigned int threads)
{
  mark(regions);
  std::vector<InmostPoint> inmost(regions.size());
  Progress silent{{}};
  parallelForEach(
      regions.size(), threadCount(threads), silent, {0.0, 1.0}, [&](std::size_t i) {
        inmost[i] = inmostOf(regions[i]);
      });
  return inmost;
}

void
InmostPoints::mark(const std::vector<pcl::Indices>& regions)
{
  std::fill(region_.begin(), region_.end(), 0);
  for (std::size_t i = 0; i < regions.size(); ++i)
    for (const pcl::index_t point : regions[i])
      region_[static_cast<std::size_t>(point)] = static_cast<std::int32_t>(i + 1);
  for (std::size_t number = 0; number < tree_.size(); ++number)
    region_of_node_[tree_.nodeOfBlock(number)] = regionOfBlock(number);
  for (std::size_t node = tree_.size() - 1; node >= 1; --node) {
    const std::int32_t left = region_of_node_[2 * node];
    region_of_node_[node] = left == region_of_node_[2 * node + 1] ? left : several;
  }
}

std::int32_t
InmostPoints::regionOfBlock(std::size_t number) const
{
  const PointBlock& block = tree_.block(number);
  const std::int32_t first = region_[static_cast<std::size_t>(block.index[0])];
  for (int row = 1; row < block.count; ++row)
    if (region_[static_cast<std::size_t>(block.index[row])] != first)
      return several;
  return first;
}

/** One point after the other: a search ends as soon as its point is no farther than the
 *  best, which most find out at once. */
InmostPoint
InmostPoints::inmostOf(const pcl::Indices& region) const
{
  const std::int32_t own = region_[static_cast<std::size_t>(region.front())];
  InmostPoint best;
  for (const pcl::index_t point : region) {
    const Eigen::Array4f p = padded(points_[static_cast<std::size_t>(point)]);
    float nearest = std::numeric_limits<float>::infinity();
    descend(1, p, own, best.squared_distance, nearest);
    if (nearest > best.squared_distance)
      best = {point, nearest};
  }
  return best;
}

/** \param[in] enough the search may end at this squared distance
 *  \param[in,out] nearest squared distance to the nearest point outside so far */
void
InmostPoints::descend(std::size_t node,
                      const Eigen::Array4f& p,
                      std::int32_t own,
                      float enough,
                      float& nearest) const
{
  if (region_of_node_[node] == own || nearest <= enough)
    return;
  if (tree_.isBlock(node)) {
    scan(node - tree_.size(), p, own, nearest);
    return;
  }
  const float left = tree_.box(2 * node).squaredDistance(p);
  const float right = tree_.box(2 * node + 1).squaredDistance(p);
  const std::size_t near = right < left ? 2 * node + 1 : 2 * node;
  if (std::min(left, right) <= nearest * rounding::widening)
    descend(near, p, own, enough, nearest);
  if (std::max(left, right) <= nearest * rounding::widening)
    descend(near ^ 1, p, own, enough, nearest);
}

void
InmostPoints::scan(std::size_t number,
                   const Eigen::Array4f& p,
                   std::int32_t own,
                   float& nearest) const
{
  const PointBlock& block = tree_.block(number);
  const auto squared = block.squaredDistances(p.matrix().head<3>());
  for (int row = 0; row < block.count; ++row)
    if (squared[row] < nearest &&
        region_[static_cast<std::size_t>(block.index[row])] != own)
      nearest = squared[row];
}

} // namespace pcl_cid
