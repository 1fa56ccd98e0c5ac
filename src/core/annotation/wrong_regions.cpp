/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where labels are wrong.
 */

#include "wrong_regions.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

bool
isWrong(std::uint32_t truth, std::uint32_t label)
{
  return truth != 0 && truth != label;
}

/** Sets of points that grow together; each is known by its lowest index. */
class JoinedPoints {
public:
  explicit JoinedPoints(std::size_t size) : parent_(size)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t
  first(std::size_t point)
  {
    while (parent_[point] != point) {
      parent_[point] = parent_[parent_[point]];
      point = parent_[point];
    }
    return point;
  }

  void
  join(std::size_t a, std::size_t b)
  {
    const auto [low, high] = std::minmax({first(a), first(b)});
    parent_[high] = low;
  }

private:
  std::vector<std::size_t> parent_;
};

JoinedPoints
joinWrong(const RadiusGraph& graph, const Labels& truth, const Labels& labels)
{
  JoinedPoints joined(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!isWrong(truth[i], labels[i]))
      continue;
    for (const pcl::index_t neighbor : graph.earlierNeighbors(i)) {
      const auto j = static_cast<std::size_t>(neighbor);
      if (truth[j] == truth[i] && labels[j] == labels[i])
        joined.join(i, j);
    }
  }
  return joined;
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
  JoinedPoints joined = joinWrong(graph, truth, labels);
  std::vector<std::size_t> size(truth.size(), 0);
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (isWrong(truth[i], labels[i]))
      ++size[joined.first(i)];
  pcl::Indices region;
  const auto largest = std::max_element(size.begin(), size.end());
  if (largest == size.end() || *largest == 0)
    return region;
  const auto first = static_cast<std::size_t>(largest - size.begin());
  for (std::size_t i = first; i < truth.size(); ++i)
    if (joined.first(i) == first)
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
