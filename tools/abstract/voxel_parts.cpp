/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts of the points of voxels, and all points of the file, which follow these.
 */

#include "voxel_parts.h"

#include <pcl_cid/core/extreme_points.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace pcl_cid::tools {
namespace {

/** The coordinates of a block in a local frame; those that are not finite, too. */
ExtremePoints::Block
localPoints(const LabelledCloud& block, const Frame& frame)
{
  const FileCoordinates coordinates(block);
  ExtremePoints::Block points(block.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = frame.toLocal(coordinates[i]);
  return points;
}

/** The points of a block in each part. */
std::vector<PartPoints>
sortedByPart(const LabelledCloud& block,
             const std::vector<int>& part,
             std::size_t parts)
{
  const FileCoordinates coordinates(block);
  std::vector<PartPoints> sorted(parts);
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] < 0)
      continue;
    PartPoints& of_part = sorted[static_cast<std::size_t>(part[i])];
    of_part.part = static_cast<std::size_t>(part[i]);
    of_part.indices.push_back(static_cast<pcl::index_t>(block.first_point + i));
    of_part.points.push_back(coordinates[i]);
  }
  return sorted;
}

} // namespace

void
VoxelParts::findParts(const std::vector<ConvexPart>& parts)
{
  part_.assign(voxels_.scan().cloud.size(), -1);
  trimmed_of_ = part_;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (const pcl::index_t point : parts[k].indices)
      part_[static_cast<std::size_t>(point)] = static_cast<int>(k);
    for (const pcl::index_t point : parts[k].trimmed)
      trimmed_of_[static_cast<std::size_t>(point)] = static_cast<int>(k);
  }
}

void
VoxelParts::count(const pcl::Indices& follows, AbstractedScan& abstracted) const
{
  for (const pcl::index_t point : follows) {
    if (point < 0)
      continue;
    const auto i = static_cast<std::size_t>(point);
    if (part_[i] >= 0)
      ++abstracted.followed[static_cast<std::size_t>(part_[i])].points;
    else if (trimmed_of_[i] >= 0)
      ++abstracted.followed[static_cast<std::size_t>(trimmed_of_[i])].trimmed_points;
    else
      ++abstracted.dropped_points;
  }
}

std::vector<int>
VoxelParts::partsOf(const pcl::Indices& follows) const
{
  std::vector<int> parts;
  parts.reserve(follows.size());
  for (const pcl::index_t point : follows)
    parts.push_back(point < 0 ? -1 : part_[static_cast<std::size_t>(point)]);
  return parts;
}

/** Call take(block, follows) for all blocks of the file, and write them with labels
 * where that is asked for. */
template <typename Take>
void
VoxelParts::read(const Take& take)
{
  if (settings_.labels.empty())
    return voxels_.follow(settings_, take, run_);
  std::vector<std::uint32_t> labels;
  for (const int part : part_)
    labels.push_back(static_cast<std::uint32_t>(part + 1));
  voxels_.writeLabels(
      settings_,
      labels,
      [&](const LabelledCloud& block, const pcl::Indices& follows, const auto&) {
        take(block, follows);
      },
      run_);
}

void
VoxelParts::cover(const std::vector<pcl::index_t>& group, AbstractedScan& abstracted)
{
  run_.begin("Covering all points");
  const CloudPoints& points = voxels_.scan().points;
  findParts(abstracted.parts);
  abstracted.followed.resize(abstracted.parts.size());
  for (std::size_t k = 0; k < abstracted.parts.size(); ++k)
    for (const pcl::index_t point : abstracted.parts[k].trimmed)
      abstracted.followed[k].trimmed.push_back(points.indexInFile(point));
  abstracted.dropped_points = 0;
  std::optional<FollowedGroups> groups;
  if (group.empty())
    run_.report.points_grouped = voxels_.finite();
  else
    groups.emplace(group, run_.report);
  ExtremePoints extremes(abstracted.parts.size(), settings_.threads);
  read([&](const LabelledCloud& block, const pcl::Indices& follows) {
    extremes.add(localPoints(block, points.frame), partsOf(follows));
    count(follows, abstracted);
    if (groups)
      groups->take(follows);
  });
  coverExtremes(extremes, abstracted);
  run_.end(std::to_string(abstracted.parts.size()) + " hulls", "cover");
}

ShowParts
VoxelParts::show()
{
  return [this](const std::function<void(const PartPoints&)>& take) {
    const auto parts =
        static_cast<std::size_t>(*std::max_element(part_.begin(), part_.end()) + 1);
    voxels_.follow(
        settings_,
        [&](LabelledCloud& block, const pcl::Indices& follows) {
          for (const PartPoints& of_part : sortedByPart(block, partsOf(follows), parts))
            if (!of_part.points.empty())
              take(of_part);
        },
        run_);
  };
}

} // namespace pcl_cid::tools
