/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The floor under a scanner, which the scanner itself hides.
 */

#include "base/infinity.h"
#include "base/progress.h"
#include "base/requirements.h"

#include "base/random.h"
#include "blind_spot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

namespace pcl_cid {
namespace {

constexpr float pi = 3.14159265f;

/** Points that take part in the search for the floor. */
constexpr std::size_t most_drawn = 20000;
/** How far from straight down floor is looked for, as a tangent: 80 degrees. */
constexpr float widest = 5.671f;
/** Anything narrower may be the gap between two rays. */
constexpr float narrowest = 0.1f;
/** Twice the least area of three points that count as not collinear; PCL's is smaller.
 */
constexpr float least_area = 1e-4f;
/** How far from level a floor may be: 10 degrees. */
constexpr double largest_tilt = 10.0 * 0.017453292519943295;
/** Half of the thickness of the floor, as a share of the height above it. */
constexpr float thickness = 0.03f;
/** Share of the points under the sensor that may be under the floor, too. */
constexpr double share_below = 0.02;
/** Directions around the foot of the sensor, and those that must see the rim. */
constexpr std::size_t sectors = 36;
constexpr std::size_t least_sectors = 24;
/** How far the rim may be from a circle, as a share of its radius. */
constexpr float roughness = 0.25f;
/** The disc that must be empty, and the end of the ring around it that must not be, in
 *  radii of the blind spot. */
constexpr float empty = 0.8f;
constexpr float ring_end = 1.4f;
/** The disc is empty when its density is below this share of the ring's. */
constexpr float sparse = 0.1f;
/** Most points of the filling along a radius. */
constexpr float finest = 100.0f;

/** Places around a sensor: how far down, and how far from the line straight down. */
struct Plumb {
  Eigen::Vector3f sensor;
  Eigen::Vector3f down;  ///< of length 1
  Eigen::Vector3f aside; ///< at right angles to it
  Eigen::Vector3f across;

  Plumb(const Eigen::Vector3f& position, const Eigen::Vector3f& direction)
  : sensor(position)
  , down(direction)
  , aside(direction.unitOrthogonal())
  , across(direction.cross(aside))
  {
  }

  float
  depth(const Eigen::Vector3f& p) const
  {
    return (p - sensor).dot(down);
  }

  float
  radius(const Eigen::Vector3f& p) const
  {
    return Eigen::Vector2f((p - sensor).dot(aside), (p - sensor).dot(across)).norm();
  }

  std::size_t
  sector(const Eigen::Vector3f& p) const
  {
    const float turn = std::atan2((p - sensor).dot(across), (p - sensor).dot(aside));
    const auto k = static_cast<std::size_t>((turn / (2.0f * pi) + 0.5f) *
                                            static_cast<float>(sectors));
    return std::min(k, sectors - 1);
  }

  bool
  isUnderneath(const Eigen::Vector3f& p) const
  {
    return depth(p) > 0.0f && radius(p) <= widest * depth(p);
  }
};

/** The floor; down is its normal. */
struct Floor {
  Plumb plumb;
  float height; ///< of the sensor above it

  bool
  holds(const Eigen::Vector3f& p) const
  {
    return std::abs(plumb.depth(p) - height) <= thickness * height &&
           plumb.isUnderneath(p);
  }
};

/** A draw of the points under the sensor; all of them where there are few points. */
Points
drawUnderneath(const Points& points, const Plumb& plumb)
{
  RandomGenerator generator(0);
  const bool all = points.size() <= most_drawn;
  Points drawn;
  for (std::size_t k = 0; k < std::min(points.size(), most_drawn); ++k) {
    const Eigen::Vector3f& p = points[all ? k : drawBelow(generator, points.size())];
    if (plumb.isUnderneath(p))
      drawn.push_back(p);
  }
  return drawn;
}

/** The depth that only a share of `share_below` of the points exceeds. */
float
lowestDepth(const Points& points, const Plumb& plumb)
{
  std::vector<float> depths;
  for (const Eigen::Vector3f& p : points)
    depths.push_back(plumb.depth(p));
  const auto lowest = depths.begin() +
                      static_cast<std::ptrdiff_t>(
                          (1.0 - share_below) * static_cast<double>(depths.size() - 1));
  std::nth_element(depths.begin(), lowest, depths.end());
  return *lowest;
}

/** The points in the lower half: the floor is among them, but no table and no part of
 *  the scanner. */
Points
lowerHalf(const Points& points, const Plumb& plumb, float lowest)
{
  Points lower;
  for (const Eigen::Vector3f& p : points)
    if (plumb.depth(p) >= 0.5f * lowest)
      lower.push_back(p);
  return lower;
}

std::size_t
sectorsWith(const Points& points, const Plumb& plumb)
{
  std::array<bool, sectors> seen{};
  for (const Eigen::Vector3f& p : points)
    seen[plumb.sector(p)] = true;
  return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
}

/** Draws three points again when they are collinear, without PCL's message. */
class LevelPlane : public pcl::SampleConsensusModelPerpendicularPlane<pcl::PointXYZ> {
public:
  LevelPlane(const PointCloudConstPtr& cloud, const Eigen::Vector3f& down)
  : SampleConsensusModelPerpendicularPlane(cloud)
  {
    setAxis(down);
    setEpsAngle(largest_tilt);
  }

protected:
  bool
  isSampleGood(const pcl::Indices& three) const override
  {
    const auto at = [&](int k) -> Eigen::Vector3f {
      return (*input_)[static_cast<std::size_t>(three[static_cast<std::size_t>(k)])]
          .getVector3fMap();
    };
    return (at(1) - at(0)).cross(at(2) - at(0)).norm() > least_area;
  }
};

/** The level plane that most of the points are on, by RANSAC.
 *  \param[in] lowest the depth that few of them exceed */
std::optional<Floor>
fitFloor(const Points& points, const Plumb& plumb, float lowest)
{
  // Relative to the sensor, in units of the depth: PCL's thresholds are absolute.
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3f v = (p - plumb.sensor) / lowest;
    cloud->emplace_back(v.x(), v.y(), v.z());
  }
  const auto model = pcl::make_shared<LevelPlane>(cloud, plumb.down);
  pcl::RandomSampleConsensus<pcl::PointXYZ> search(model, thickness);
  if (!search.computeModel())
    return std::nullopt;
  pcl::Indices on_plane;
  Eigen::VectorXf drawn, fitted; // normal and offset: n x + d = 0
  search.getInliers(on_plane);
  search.getModelCoefficients(drawn);
  model->optimizeModelCoefficients(on_plane, drawn, fitted);
  const float turn = fitted[3] < 0.0f ? 1.0f : -1.0f; // the floor is below the sensor
  return Floor{{plumb.sensor, turn * fitted.head<3>().normalized()},
               lowest * std::abs(fitted[3]) / fitted.head<3>().norm()};
}

/** Where the floor begins, if that is at about the same distance all around. */
std::optional<float>
rimOf(const Points& points, const Floor& floor)
{
  std::array<float, sectors> nearest;
  nearest.fill(infinity);
  for (const Eigen::Vector3f& p : points)
    if (floor.holds(p)) {
      float& rim = nearest[floor.plumb.sector(p)];
      rim = std::min(rim, floor.plumb.radius(p));
    }
  std::sort(nearest.begin(), nearest.end());
  const auto seen = std::lower_bound(nearest.begin(), nearest.end(), infinity);
  const float radius = nearest[static_cast<std::size_t>(seen - nearest.begin()) / 2];
  const auto isNear = [radius](float rim) {
    return std::abs(rim - radius) <= roughness * radius;
  };
  const auto near = std::count_if(nearest.begin(), seen, isNear);
  const bool all_around = static_cast<std::size_t>(near) >= least_sectors;
  if (!all_around || radius < narrowest * floor.height)
    return std::nullopt;
  return radius;
}

/** The spacing of the floor around a hole; nothing where the hole is not empty. */
std::optional<float>
spacingAround(const Points& points, const Floor& floor, float radius)
{
  const Plumb& plumb = floor.plumb;
  std::size_t in_ring = 0;
  std::size_t in_hole = 0;
  for (const Eigen::Vector3f& p : points) {
    const float depth = plumb.depth(p);
    if (depth < 0.5f * floor.height)
      continue;
    const float r = plumb.radius(p);
    in_hole += r <= empty * radius * depth / floor.height;
    in_ring += r > radius && r <= ring_end * radius && floor.holds(p);
  }
  const float ring_area = pi * (ring_end * ring_end - 1.0f) * radius * radius;
  const float hole_area = pi * empty * empty * radius * radius;
  if (static_cast<float>(in_hole) / hole_area >
      sparse * static_cast<float>(in_ring) / ring_area)
    return std::nullopt;
  return std::sqrt(ring_area / static_cast<float>(in_ring));
}

BlindSpot
fill(const Floor& floor, float radius, float spacing)
{
  const Plumb& plumb = floor.plumb;
  BlindSpot spot{plumb.sensor + floor.height * plumb.down, radius, {}};
  const float step = std::max(spacing, radius / finest);
  const auto count = static_cast<int>(radius / step);
  for (int i = -count; i <= count; ++i)
    for (int k = -count; k <= count; ++k) {
      const Eigen::Vector2f at =
          step * Eigen::Vector2f(static_cast<float>(i), static_cast<float>(k));
      if (at.norm() <= radius)
        spot.filling.push_back(spot.center + at.x() * plumb.aside +
                               at.y() * plumb.across);
    }
  return spot;
}

} // namespace

std::optional<BlindSpot>
findBlindSpot(const Points& points,
              const SensorPose& sensor,
              const ExecutionOptions& execution)
{
  requirePoints(points);
  Progress progress(execution.progress);
  const Plumb plumb(sensor.position, sensor.down);
  const Points underneath = drawUnderneath(points, plumb);
  if (underneath.empty())
    return std::nullopt;
  const float lowest = lowestDepth(underneath, plumb);
  const Points lower = lowerHalf(underneath, plumb, lowest);
  if (sectorsWith(lower, plumb) < least_sectors)
    return std::nullopt; // not all around; what passes is not collinear, either
  const std::optional<Floor> floor = fitFloor(lower, plumb, lowest);
  if (!floor)
    return std::nullopt;
  progress.poll();
  const std::optional<float> radius = rimOf(points, *floor);
  if (!radius)
    return std::nullopt;
  progress.poll();
  const std::optional<float> spacing = spacingAround(points, *floor, *radius);
  if (!spacing)
    return std::nullopt;
  return fill(*floor, *radius, *spacing);
}

} // namespace pcl_cid
