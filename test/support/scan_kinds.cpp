/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The kinds of scans of a test room.
 */

#include "scan_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <pcl_cid/exceptions.h>

#include "depth_sensor.h"
#include "even_sampler.h"
#include "mesh_vertices.h"
#include "scan_selection.h"

namespace pcl_cid::test {
namespace {

/// Tangents of half the angles of a depth camera's image.
constexpr double half_image_width = 0.6;
constexpr double half_image_height = 0.45;
/// It looks down by this tangent.
constexpr double camera_tilt = 0.25;
/// Scans with ever more points are searched for enough that a camera sees.
constexpr int enlargements = 12;
/// What a scan of a merged one has of the densest one's points, at least.
constexpr double least_share = 0.2;

SensorOptions
perfectSensor(std::size_t points, std::uint64_t seed, unsigned positions)
{
  SensorOptions options;
  options.seed = seed;
  options.points = points;
  options.positions = positions;
  options.noise = 0.0;
  return options;
}

LabelledScan
scanByLidar(const RoomScene& scene, std::size_t points, std::uint64_t seed)
{
  SensorOptions options = perfectSensor(points, seed, 1);
  options.min_elevation_sine = -0.79;
  options.max_elevation_sine = 2.0;
  options.range = {0.3, 100.0};
  options.min_incidence_cosine = 0.03;
  return scanRoom(scene, options);
}

/// Whether a camera at \a eye that looks along \a heading (in plan) sees \a point.
bool
isInImage(const Eigen::Vector3d& eye,
          const Eigen::Vector2d& heading,
          const Eigen::Vector3d& point)
{
  const Eigen::Vector3d ray = point - eye;
  const double ahead = heading.x() * ray.x() + heading.y() * ray.y();
  const double aside = heading.x() * ray.y() - heading.y() * ray.x();
  const double forward = ahead - camera_tilt * ray.z();
  const double up = ray.z() + camera_tilt * ahead;
  return forward > 0.0 && std::abs(aside) <= half_image_width * forward &&
         std::abs(up) <= half_image_height * forward;
}

/// Towards the middle of the room.
Eigen::Vector2d
headingOf(const Eigen::Vector3d& eye, const RoomScene& scene)
{
  const Eigen::Vector2d way(scene.size.x() / 2 - eye.x(), scene.size.y() / 2 - eye.y());
  const double length = std::sqrt(way.x() * way.x() + way.y() * way.y());
  return length > 0.1 ? Eigen::Vector2d(way / length) : Eigen::Vector2d(1.0, 0.0);
}

std::vector<std::size_t>
pointsInImage(const RoomScene& scene, const LabelledScan& around)
{
  const Eigen::Vector3d& eye = around.sensor_positions.front();
  const Eigen::Vector2d heading = headingOf(eye, scene);
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < around.points.size(); ++i)
    if (isInImage(eye, heading, around.points[i].cast<double>()))
      seen.push_back(i);
  return seen;
}

LabelledScan
scanInOneView(const RoomScene& scene, std::size_t points, std::uint64_t seed)
{
  std::size_t all = 8 * points;
  for (int attempt = 0; attempt < enlargements; ++attempt, all *= 2) {
    const LabelledScan around = scanRoom(scene, perfectSensor(all, seed, 1));
    std::vector<std::size_t> seen = pointsInImage(scene, around);
    if (seen.size() < points)
      continue;
    RandomGenerator generator(seed);
    thin(seen, points, generator);
    return selected(around, seen);
  }
  throw CIDException("a camera sees less than " + std::to_string(points) +
                     " points of the room; allowed are fewer points, or a room with "
                     "walls around it");
}

/// Of \a total points, as many for each position as its drawn share.
std::vector<std::size_t>
drawQuotas(std::size_t positions, std::size_t total, RandomGenerator& generator)
{
  std::vector<double> shares;
  for (std::size_t i = 0; i < positions; ++i)
    shares.push_back(drawWithin(generator, {least_share, 1.0}));
  double left = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::vector<std::size_t> quotas;
  for (const double share : shares) {
    quotas.push_back(
        static_cast<std::size_t>(static_cast<double>(total) * share / left));
    total -= quotas.back();
    left -= share;
  }
  quotas.back() += total;
  return quotas;
}

/// Each position sees more than enough, and keeps its quota.
LabelledScan
scanAndMerge(const RoomScene& scene, std::size_t points, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  const unsigned positions = drawCount(generator, 3, 5);
  const std::vector<std::size_t> quotas = drawQuotas(positions, points, generator);
  const LabelledScan all = scanRoom(scene, perfectSensor(8 * points, seed, positions));
  std::vector<std::size_t> kept;
  for (std::size_t position = 0; position < positions; ++position) {
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < all.points.size(); ++i)
      if (all.sensor[i] == position)
        own.push_back(i);
    thin(own, std::min(quotas[position], own.size()), generator);
    kept.insert(kept.end(), own.begin(), own.end());
  }
  if (kept.size() < points)
    throw CIDException("the scans to merge give " + std::to_string(kept.size()) +
                       " points of the " + std::to_string(points) +
                       " asked for; allowed are rooms with several free "
                       "places for the sensor");
  return selected(all, kept);
}

/// Where a scan of one position is put, and how its camera was set.
struct ScanSetting {
  Pose turn;
  Eigen::Vector3d shift{0.0, 0.0, 0.0};
  std::array<double, 3> gain{1.0, 1.0, 1.0};
};

Eigen::Vector3d
drawShift(RandomGenerator& generator, double deviation)
{
  Eigen::Vector3d shift;
  for (int axis = 0; axis < 3; ++axis)
    shift[axis] = deviation * drawNormal(generator);
  return shift;
}

ScanSetting
drawSetting(const ScanErrors& errors, RandomGenerator& generator)
{
  ScanSetting setting;
  setting.turn.axis = drawTurn(generator, errors.misalignment / 4);
  setting.shift = drawShift(generator, errors.misalignment);
  const double brightness =
      1.0 + drawWithin(generator, {-errors.exposure, errors.exposure});
  for (double& gain : setting.gain)
    gain = brightness *
           (1.0 + drawWithin(generator, {-errors.exposure / 2, errors.exposure / 2}));
  return setting;
}

/// Turned about the scanner, then shifted.
Eigen::Vector3d
placed(const Eigen::Vector3d& point,
       const ScanSetting& setting,
       const Eigen::Vector3d& scanner)
{
  const Eigen::Vector3d ray = point - scanner;
  const Eigen::Vector2d plan = rotated({ray.x(), ray.y()}, setting.turn.axis);
  return scanner + Eigen::Vector3d(plan.x(), plan.y(), ray.z()) + setting.shift;
}

Eigen::Vector3d
withNoise(const Eigen::Vector3d& point,
          const Eigen::Vector3d& scanner,
          const ScanErrors& errors,
          RandomGenerator& generator)
{
  const Eigen::Vector3d ray = point - scanner;
  const double squared = dot(ray, ray);
  const double sigma = errors.noise + errors.per_square * squared;
  return point + sigma * drawNormal(generator) * ray / std::sqrt(squared);
}

std::uint8_t
clampedLevel(double value)
{
  return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 255.0) + 0.5));
}

ColorRGB
seenColor(const ColorRGB& color,
          const ScanSetting& setting,
          double noise,
          RandomGenerator& generator)
{
  std::array<double, 3> levels{static_cast<double>(color.r),
                               static_cast<double>(color.g),
                               static_cast<double>(color.b)};
  for (std::size_t channel = 0; channel < levels.size(); ++channel)
    levels[channel] =
        levels[channel] * setting.gain[channel] + noise * drawNormal(generator);
  return {clampedLevel(levels[0]), clampedLevel(levels[1]), clampedLevel(levels[2])};
}

} // namespace

LabelledScan
choosePoints(const RoomScene& scene,
             ScanKind kind,
             std::size_t points,
             std::uint64_t seed)
{
  if (points < 1)
    throw CIDException("the number of scan points is 0; allowed is 1 or more");
  RandomGenerator generator(seed);
  switch (kind) {
  case ScanKind::even:
    return sampleRoomEvenly(scene, points, seed);
  case ScanKind::sensor:
    return scanRoom(scene, perfectSensor(points, seed, drawCount(generator, 3, 6)));
  case ScanKind::merged:
    return scanAndMerge(scene, points, seed);
  case ScanKind::mesh_vertices:
    return sampleMeshVertices(scene, points, seed);
  case ScanKind::single_view:
    return scanInOneView(scene, points, seed);
  default:
    return scanByLidar(scene, points, seed);
  }
}

ScanErrors
usualErrors(ScanKind kind)
{
  switch (kind) {
  case ScanKind::even:
    return {0.0, 0.0, 0.0, 4.0, 0.0};
  case ScanKind::merged:
    return {0.002, 0.0005, 0.005, 5.0, 0.12};
  case ScanKind::mesh_vertices:
    return {0.001, 0.0, 0.0, 3.0, 0.0};
  case ScanKind::lidar:
    return {0.002, 0.0, 0.0, 6.0, 0.0};
  default:
    return {0.0, 0.0015, 0.0, 6.0, 0.0};
  }
}

void
disturb(LabelledScan& scan, const ScanErrors& errors, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  const bool has_sensors = !scan.sensor.empty();
  std::vector<ScanSetting> settings(1);
  if (has_sensors)
    settings.clear();
  for (std::size_t i = 0; i < scan.sensor_positions.size(); ++i)
    settings.push_back(drawSetting(errors, generator));
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d point = scan.points[i].cast<double>();
    const std::size_t sensor = has_sensors ? scan.sensor[i] : 0;
    const Eigen::Vector3d moved_point =
        has_sensors
            ? placed(withNoise(point, scan.sensor_positions[sensor], errors, generator),
                     settings[sensor],
                     scan.sensor_positions[sensor])
            : Eigen::Vector3d(point + drawShift(generator, errors.noise));
    scan.points[i] = moved_point.cast<float>();
    if (!scan.colors.empty())
      scan.colors[i] =
          seenColor(scan.colors[i], settings[sensor], errors.color_noise, generator);
  }
  for (std::size_t i = 0; i < scan.sensor_positions.size(); ++i)
    scan.sensor_positions[i] += settings[i].shift;
}

} // namespace pcl_cid::test
