/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A simulated depth sensor: rays through a panorama, occlusion, noise, thinning.
 */

#include "depth_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <pcl_cid/exceptions.h>

#include "primitive_tree.h"

namespace pcl_cid::test {
namespace {

/// A sensor does not stand closer than this to anything.
constexpr double clearance = 0.5;
/// It stays out of this share of the room along each wall.
constexpr double wall_share = 0.2;
constexpr int position_candidates = 2000;
/// Side of the images that estimate how many rays see something.
constexpr std::size_t pilot_side = 48;
constexpr std::size_t faces = 6;

/// Where a sensor stands and how it is turned: the columns are its axes.
struct Sensor {
  Eigen::Vector3d position;
  std::array<Eigen::Vector3d, 3> axes;
};

/// One ray that saw something.
struct Sighting {
  Eigen::Vector3d direction;
  double range;
  std::uint32_t primitive;
  std::uint8_t sensor;
};

void
checkOptions(const SensorOptions& options)
{
  if (options.points < 1)
    throw CIDException("the number of scan points is 0; allowed is 1 or more");
  if (options.positions < 1 || options.positions > 255)
    throw CIDException("the number of sensor positions is " +
                       std::to_string(options.positions) + "; allowed is 1 to 255");
  if (!(options.noise >= 0.0))
    throw CIDException("the sensor noise is " + std::to_string(options.noise) +
                       "; allowed is 0 or more");
}

/// A unit quaternion from four uniform draws in the unit ball, as three axes.
std::array<Eigen::Vector3d, 3>
drawAxes(RandomGenerator& generator)
{
  std::array<double, 4> q{};
  double norm = 0.0;
  while (norm < 0.01 || norm > 1.0) {
    norm = 0.0;
    for (double& part : q) {
      part = drawWithin(generator, {-1.0, 1.0});
      norm += part * part;
    }
  }
  const auto [w, x, y, z] = q;
  const double s = 2.0 / norm;
  return {Eigen::Vector3d(
              1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)),
          Eigen::Vector3d(
              s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)),
          Eigen::Vector3d(
              s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y))};
}

bool
hasClearance(const RoomScene& scene, const Eigen::Vector3d& position)
{
  return std::all_of(scene.primitives.begin(),
                     scene.primitives.end(),
                     [&](const Primitive& primitive) {
                       return distanceTo(primitive, position) >= clearance;
                     });
}

double
distanceToNearest(const std::vector<Sensor>& sensors, const Eigen::Vector3d& position)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Sensor& sensor : sensors) {
    const Eigen::Vector3d offset = sensor.position - position;
    nearest = std::min(nearest, dot(offset, offset));
  }
  return nearest;
}

/// Free places far from each other, so that what one position cannot see another can.
std::vector<Sensor>
placeSensors(const RoomScene& scene,
             const SensorOptions& options,
             RandomGenerator& generator)
{
  const Range inner_share{wall_share, 1.0 - wall_share};
  std::vector<Eigen::Vector3d> candidates;
  for (int i = 0; i < position_candidates; ++i) {
    const Eigen::Vector3d candidate{scene.size.x() * drawWithin(generator, inner_share),
                                    scene.size.y() * drawWithin(generator, inner_share),
                                    drawWithin(generator, options.height)};
    if (hasClearance(scene, candidate))
      candidates.push_back(candidate);
  }
  if (candidates.empty())
    throw CIDException("the room has no free place for the sensor; allowed are rooms "
                       "with 0.5 m of air around some point at its height");
  std::vector<Sensor> sensors;
  while (sensors.size() < options.positions) {
    const auto farther = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return distanceToNearest(sensors, a) < distanceToNearest(sensors, b);
    };
    const auto best = std::max_element(candidates.begin(), candidates.end(), farther);
    sensors.push_back({*best, drawAxes(generator)});
  }
  return sensors;
}

/** Spreads the rays of an image evenly over angles: tan(a 45 degrees), a from -1 to 1,
 *  to about 1 % and without the tangent. */
double
imageCoordinate(std::size_t pixel, std::size_t side)
{
  const double a =
      (2.0 * static_cast<double>(pixel) + 1.0) / static_cast<double>(side) - 1.0;
  return a * (0.7854 + 0.2146 * a * a);
}

Eigen::Vector3d
rayThrough(const Sensor& sensor, std::size_t face, double u, double v)
{
  const std::size_t axis = face / 2;
  const double sign = face % 2 == 0 ? 1.0 : -1.0;
  const Eigen::Vector3d ray = sign * sensor.axes[axis] +
                              u * sensor.axes[(axis + 1) % 3] +
                              v * sensor.axes[(axis + 2) % 3];
  return ray / std::sqrt(dot(ray, ray));
}

/// Calls \a see(ray, hit) for each ray of a panorama that sees a surface.
template <typename See>
void
lookAround(const Sensor& sensor,
           const PrimitiveTree& tree,
           const SensorOptions& options,
           std::size_t side,
           const See& see)
{
  for (std::size_t face = 0; face < faces; ++face)
    for (std::size_t row = 0; row < side; ++row)
      for (std::size_t column = 0; column < side; ++column) {
        const Eigen::Vector3d ray = rayThrough(
            sensor, face, imageCoordinate(column, side), imageCoordinate(row, side));
        RayHit hit;
        if (ray.z() >= options.min_elevation_sine &&
            ray.z() <= options.max_elevation_sine &&
            tree.firstHit(sensor.position, ray, hit) &&
            hit.surface.range >= options.range.low &&
            hit.surface.range <= options.range.high &&
            hit.surface.incidence_cosine >= options.min_incidence_cosine)
          see(ray, hit);
      }
}

/// The side of the images that see a little more than the points wanted.
std::size_t
chooseSide(const std::vector<Sensor>& sensors,
           const PrimitiveTree& tree,
           const SensorOptions& options)
{
  std::size_t seen = 0;
  for (const Sensor& sensor : sensors)
    lookAround(
        sensor, tree, options, pilot_side, [&](const auto&, const auto&) { ++seen; });
  if (seen == 0)
    throw CIDException("the sensor sees nothing; allowed are ranges that reach the "
                       "walls of the room");
  const double pilot_sides =
      std::sqrt(static_cast<double>(options.points) / static_cast<double>(seen));
  return static_cast<std::size_t>(pilot_sides * pilot_side * 1.01) + 4;
}

std::vector<Sighting>
lookFromAll(const std::vector<Sensor>& sensors,
            const PrimitiveTree& tree,
            const SensorOptions& options,
            std::size_t side)
{
  std::vector<Sighting> sightings;
  sightings.reserve(options.points + options.points / 16);
  for (std::size_t s = 0; s < sensors.size(); ++s)
    lookAround(sensors[s],
               tree,
               options,
               side,
               [&](const Eigen::Vector3d& ray, const RayHit& hit) {
                 sightings.push_back({ray,
                                      hit.surface.range,
                                      static_cast<std::uint32_t>(hit.primitive),
                                      static_cast<std::uint8_t>(s)});
               });
  return sightings;
}

std::vector<Sighting>
lookForPoints(const std::vector<Sensor>& sensors,
              const PrimitiveTree& tree,
              const SensorOptions& options,
              RandomGenerator& generator)
{
  std::size_t side = chooseSide(sensors, tree, options);
  std::vector<Sighting> sightings = lookFromAll(sensors, tree, options, side);
  while (sightings.size() < options.points) {
    side += 1 + side / 50;
    sightings = lookFromAll(sensors, tree, options, side);
  }
  thin(sightings, options.points, generator);
  return sightings;
}

} // namespace

LabelledScan
scanRoom(const RoomScene& scene, const SensorOptions& options)
{
  checkOptions(options);
  RandomGenerator generator(options.seed);
  const std::vector<Sensor> sensors = placeSensors(scene, options, generator);
  const PrimitiveTree tree(scene.primitives);
  const std::vector<Sighting> sightings =
      lookForPoints(sensors, tree, options, generator);

  LabelledScan scan;
  scan.class_names = roomClassNames();
  for (const Sensor& sensor : sensors)
    scan.sensor_positions.push_back(sensor.position);
  for (const Sighting& sighting : sightings) {
    const double sigma = options.noise * sighting.range * sighting.range;
    const double range = sighting.range + sigma * drawNormal(generator);
    const Eigen::Vector3d point =
        sensors[sighting.sensor].position + range * sighting.direction;
    const std::uint32_t instance = scene.primitives[sighting.primitive].instance;
    scan.points.push_back(point.cast<float>());
    scan.instance.push_back(instance);
    scan.primitive.push_back(sighting.primitive);
    scan.semantic.push_back(
        static_cast<std::uint8_t>(scene.class_of_instance[instance]));
    scan.sensor.push_back(sighting.sensor);
  }
  return scan;
}

} // namespace pcl_cid::test
