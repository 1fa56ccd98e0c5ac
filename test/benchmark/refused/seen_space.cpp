/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which space the sensors of a scan have seen to be free: rays through voxels.
 */

#include "seen_space.h"

#include "base/parallel_for.h"
#include "base/sentence.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_cid::benchmarks {
namespace {

Eigen::AlignedBox3d
boxOf(const Points& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : points)
    box.extend(p.cast<double>().eval());
  return box;
}

std::size_t
checkedSize(const VoxelGrid& grid)
{
  constexpr double most = 0x1p31;
  if (!(grid.size() <= most))
    throw CIDException(sentence("the voxel is ",
                                grid.voxel(),
                                ", so the box of the scan has ",
                                grid.size(),
                                " voxels; it must be so large that there are at most ",
                                most));
  return static_cast<std::size_t>(grid.size());
}

/** The cell of directions, 1 degree wide, that a way leads to. */
std::size_t
directionCell(const Eigen::Vector3d& way, double range)
{
  constexpr double degrees = 180.0 / M_PI;
  constexpr std::size_t elevations = 181;
  const double azimuth = std::atan2(way.y(), way.x()) * degrees + 180.0;
  const double elevation =
      std::asin(std::clamp(way.z() / range, -1.0, 1.0)) * degrees + 90.0;
  return static_cast<std::size_t>(azimuth) * elevations +
         static_cast<std::size_t>(elevation);
}

/** The smallest range in each cell of directions. */
std::vector<double>
nearestRanges(const Eigen::Vector3d& viewpoint, const Points& scan)
{
  std::vector<double> nearest(361 * 181, std::numeric_limits<double>::infinity());
  for (const Eigen::Vector3f& p : scan) {
    const Eigen::Vector3d way = p.cast<double>() - viewpoint;
    if (const double range = way.norm(); range > 0.0) {
      double& smallest = nearest[directionCell(way, range)];
      smallest = std::min(smallest, range);
    }
  }
  return nearest;
}

} // namespace

std::vector<char>
seenFrom(const Eigen::Vector3d& viewpoint,
         const Points& scan,
         bool is_only,
         const SightOptions& options)
{
  constexpr double widening = 1.05;
  constexpr double margin = 0.05; // metres
  std::vector<double> nearest;
  if (!is_only)
    nearest = nearestRanges(viewpoint, scan);
  std::vector<char> is_seen(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector3d way = scan[i].cast<double>() - viewpoint;
    const double range = way.norm();
    if (range == 0.0 ||
        std::abs(way.z()) > options.max_elevation_sine.value_or(1.0) * range)
      continue;
    is_seen[i] =
        is_only || range <= widening * nearest[directionCell(way, range)] + margin;
  }
  return is_seen;
}

SeenSpace::SeenSpace(const Points& scan,
                     const std::vector<Eigen::Vector3d>& viewpoints,
                     const SightOptions& options)
: box_(boxOf(scan)), grid_(box_, options.voxel), is_free_(checkedSize(grid_))
{
  if (viewpoints.empty())
    for (std::atomic<bool>& voxel : is_free_)
      voxel.store(true, std::memory_order_relaxed);
  for (const Eigen::Vector3d& viewpoint : viewpoints)
    look(viewpoint, scan, viewpoints.size() == 1, options);
  for (const Eigen::Vector3f& p : scan)
    is_free_[grid_.indexOf(p.cast<double>())].store(false, std::memory_order_relaxed);
}

void
SeenSpace::look(const Eigen::Vector3d& viewpoint,
                const Points& scan,
                bool is_only,
                const SightOptions& options)
{
  const std::vector<char> is_seen = seenFrom(viewpoint, scan, is_only, options);
  const auto followRay = [&](const Eigen::Vector3d& way) {
    const double length = way.norm() - options.voxel;
    if (length > 0.0)
      grid_.forEachOn(
          viewpoint, viewpoint + length * way.normalized(), [&](std::size_t voxel) {
            is_free_[voxel].store(true, std::memory_order_relaxed);
          });
  };
  Progress progress({});
  parallelFor(scan.size(),
              1024,
              threadCount(options.threads),
              progress,
              {0.0, 1.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                  if (is_seen[i])
                    followRay(scan[i].cast<double>() - viewpoint);
              });
}

double
SeenSpace::freeVolume() const
{
  std::size_t free = 0;
  for (std::size_t voxel = 0; voxel < size(); ++voxel)
    free += isFree(voxel) ? 1 : 0;
  return static_cast<double>(free) * std::pow(grid_.voxel(), 3);
}

} // namespace pcl_cid::benchmarks
