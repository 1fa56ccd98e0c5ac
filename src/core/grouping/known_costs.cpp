/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Costs of pairs that are asked for again and again.
 */

#include "known_costs.h"

#include "cid/cost_search.h"

namespace pcl_cid {

KnownCosts::KnownCosts(const WorkingPoints& points, int samples)
: points_(points), order_(samples)
{
}

float
KnownCosts::cost(std::size_t p, std::size_t q, float limit, SegmentSearch& search)
{
  const std::uint64_t pair = (std::uint64_t{p} << 32) | q;
  Known found = known(pair);
  if (!found.tells(limit)) {
    const Segment segment{
        points_.points()[p], points_.points()[q], points_.areOnSurface()};
    std::size_t& hint = search.follow(p);
    found.low = searchCost(search, segment, points_.costs().between(p, q), limit, hint);
    found.is_exact = found.low < limit;
    keep(pair, found);
  }
  return found.low;
}

KnownCosts::Known
KnownCosts::known(std::uint64_t pair)
{
  Share& share = shareOf(pair);
  const std::lock_guard<std::mutex> lock(share.mutex);
  const auto found = share.costs.find(pair);
  return found == share.costs.end() ? Known() : found->second;
}

void
KnownCosts::keep(std::uint64_t pair, const Known& known)
{
  Share& share = shareOf(pair);
  const std::lock_guard<std::mutex> lock(share.mutex);
  if (share.costs.size() > points_.size() / shares_.size())
    share.costs.clear();
  share.costs[pair] = known;
}

} // namespace pcl_cid
