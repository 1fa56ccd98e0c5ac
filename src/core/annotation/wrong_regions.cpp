/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where labels are wrong.
 */

#include "wrong_regions.h"

#include "base/joined_sets.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl_cid {
namespace {

bool
isWrong(std::uint32_t truth, std::uint32_t label)
{
  return truth != 0 && truth != label;
}

/** The connected region of each point that is wrong, by its lowest point. */
std::vector<std::uint32_t>
connectedRegions(const RadiusGraph& graph, const Labels& truth, const Labels& labels)
{
  return joinedSets(truth.size(), [&](const auto& join) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (!isWrong(truth[i], labels[i]))
        continue;
      for (const pcl::index_t neighbor : graph.earlierNeighbors(i)) {
        const auto j = static_cast<std::size_t>(neighbor);
        if (truth[j] == truth[i] && labels[j] == labels[i])
          join(i, j);
      }
    }
  });
}

} // namespace

std::vector<pcl::Indices>
wrongRegions(const Labels& truth, const Labels& labels)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, pcl::Indices> by_pair;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (isWrong(truth[i], labels[i]))
      by_pair[{truth[i], labels[i]}].push_back(static_cast<pcl::index_t>(i));
  std::vector<pcl::Indices> regions;
  for (auto& [pair, region] : by_pair)
    regions.push_back(std::move(region));
  return regions;
}

pcl::Indices
largestConnectedWrongRegion(const RadiusGraph& graph,
                            const Labels& truth,
                            const Labels& labels)
{
  const std::vector<std::uint32_t> regions = connectedRegions(graph, truth, labels);
  std::vector<std::size_t> size(truth.size(), 0);
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (isWrong(truth[i], labels[i]))
      ++size[regions[i]];
  pcl::Indices region;
  const auto largest = std::max_element(size.begin(), size.end());
  if (largest == size.end() || *largest == 0)
    return region;
  const auto first = static_cast<std::size_t>(largest - size.begin());
  for (std::size_t i = first; i < truth.size(); ++i)
    if (regions[i] == first)
      region.push_back(static_cast<pcl::index_t>(i));
  return region;
}

pcl::Indices
largestInstance(const Labels& truth)
{
  std::map<std::uint32_t, pcl::Indices> by_label;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (truth[i] != 0)
      by_label[truth[i]].push_back(static_cast<pcl::index_t>(i));
  pcl::Indices largest;
  for (auto& [label, points] : by_label)
    if (points.size() > largest.size())
      largest = std::move(points);
  return largest;
}

} // namespace pcl_cid
