/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Sets of points that pairs of them join.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <boost/pending/disjoint_sets.hpp>

namespace pcl_cid {

/** \brief The lowest point of the set of each point, which names it: the same in
 *  whatever order pairs are joined.
 *  \param[in] count points, 0 to count - 1
 *  \param[in] visit_pairs called once with a function that joins two points */
template <typename VisitPairs>
std::vector<std::uint32_t>
joinedSets(std::size_t count, const VisitPairs& visit_pairs)
{
  boost::disjoint_sets_with_storage<> sets(count);
  visit_pairs([&](std::size_t p, std::size_t q) { sets.union_set(p, q); });
  constexpr std::uint32_t unknown = UINT32_MAX;
  std::vector<std::uint32_t> lowest_of_root(count, unknown);
  std::vector<std::uint32_t> lowest(count);
  for (std::size_t p = 0; p < count; ++p) {
    std::uint32_t& first = lowest_of_root[sets.find_set(p)];
    if (first == unknown)
      first = static_cast<std::uint32_t>(p);
    lowest[p] = first;
  }
  return lowest;
}

} // namespace pcl_cid
