/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points of a surface see each other through the inside of the shape.
 */

#include "line_of_sight.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_cid::benchmarks {

bool
LineOfSight::isFree(std::size_t first, std::size_t second) const
{
  const auto [low, high] = std::pair(std::minmax(first, second)); // the same both ways
  const Eigen::Vector3f& from = surface_.points[low];
  const Eigen::Vector3f& to = surface_.points[high];
  const Eigen::Vector3f way = (to - from).normalized();
  const float rise_from = surface_.normals[low].dot(way);
  const float rise_to = surface_.normals[high].dot(-way);
  if (std::abs(rise_from) < coplanar_ && std::abs(rise_to) < coplanar_)
    return true;
  return rise_from <= 0.0f && rise_to <= 0.0f && !crossesSurface(from, to);
}

bool
LineOfSight::separates(std::size_t disc,
                       const Eigen::Vector3f& here,
                       const Eigen::Vector3f& from,
                       const Eigen::Vector3f& to) const
{
  const Eigen::Vector3f& normal = surface_.normals[disc];
  const Eigen::Vector3f& center = surface_.points[disc];
  const float side_from = normal.dot(from - center);
  const float side_to = normal.dot(to - center);
  return (here - center).norm() < reach_ && (side_from > 0.0f) != (side_to > 0.0f) &&
         std::min(std::abs(side_from), std::abs(side_to)) > reach_;
}

bool
LineOfSight::crossesSurface(const Eigen::Vector3f& from,
                            const Eigen::Vector3f& to) const
{
  const float length = (to - from).norm();
  const Eigen::Vector3f way = (to - from) / length;
  for (float walked = reach_; walked < length - reach_;) {
    const Eigen::Vector3f here = from + walked * way;
    const float away = field_.bounds(here).low;
    if (away < reach_ &&
        separates(static_cast<std::size_t>(field_.nearest(here)), here, from, to))
      return true;
    walked += std::max(away - reach_, reach_);
  }
  return false;
}

Eigen::MatrixXf
mutualVisibility(const LineOfSight& sight,
                 const std::vector<int>& patch,
                 const std::vector<int>& piece,
                 std::size_t samples)
{
  const auto patches =
      static_cast<std::size_t>(*std::max_element(patch.begin(), patch.end()) + 1);
  std::vector<std::vector<std::size_t>> members(patches);
  for (std::size_t i = 0; i < patch.size(); ++i)
    members[static_cast<std::size_t>(patch[i])].push_back(i);
  for (std::vector<std::size_t>& list : members) {
    const std::size_t count = std::min(samples, list.size());
    std::vector<std::size_t> taken;
    for (std::size_t k = 0; k < count; ++k)
      taken.push_back(list[k * list.size() / count]);
    list = std::move(taken);
  }
  const auto size = static_cast<Eigen::Index>(patches);
  Eigen::MatrixXf visible = Eigen::MatrixXf::Identity(size, size);
  for (std::size_t a = 0; a < patches; ++a)
    for (std::size_t b = a + 1; b < patches; ++b) {
      if (piece[members[a].front()] != piece[members[b].front()])
        continue;
      std::size_t seen = 0;
      for (const std::size_t i : members[a])
        for (const std::size_t j : members[b])
          seen += sight.isFree(i, j) ? 1 : 0;
      const float share = static_cast<float>(seen) /
                          static_cast<float>(members[a].size() * members[b].size());
      visible(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = share;
      visible(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(a)) = share;
    }
  return visible;
}

} // namespace pcl_cid::benchmarks
