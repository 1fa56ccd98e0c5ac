/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points of a test room that are spaced like the vertices of a simplified mesh.
 */

#include "mesh_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include <pcl_cid/exceptions.h>

#include "even_sampler.h"
#include "scan_selection.h"

namespace pcl_cid::test {
namespace {

/// Points of the dense sampling for each that is kept.
constexpr std::size_t oversampling = 10;
/// A box thinner than this is a sheet.
constexpr double sheet_thickness = 0.01;
/// So many widths of the least cells away from an edge, cells are twice as wide, and
/// four times from there on.
constexpr std::array<double, 2> widen_at{2.0, 6.0};
/// How far to look for edges, in metres.
constexpr double farthest = 0.6;
/// How far inside of an edge a round surface counts as: it is curved everywhere.
constexpr double roundness = 0.3;
/// The width of the cells is good enough when it keeps this share too many at most.
constexpr std::size_t surplus_share = 100;
constexpr int bisections = 24;

/// The place of a point in the grid, and the instance: cells do not join two.
using Cell = std::tuple<unsigned, std::int64_t, std::int64_t, std::int64_t, unsigned>;

/// The axis along which a box is thinnest.
int
thinAxis(const Primitive& box)
{
  int axis = 0;
  box.half.minCoeff(&axis);
  return axis;
}

bool
isSheet(const Primitive& primitive)
{
  return primitive.shape == Shape::box &&
         2 * primitive.half[thinAxis(primitive)] < sheet_thickness;
}

Eigen::Vector3d
normalOfSheet(const Primitive& sheet)
{
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(thinAxis(sheet));
  return toWorld(sheet, axis) - sheet.center;
}

/// Whether two sheets lie on each other, or side by side in one plane.
bool
shareAPlane(const Primitive& a, const Primitive& b)
{
  if (!isSheet(a) || !isSheet(b))
    return false;
  const Eigen::Vector3d normal = normalOfSheet(a);
  return std::abs(dot(normal, normalOfSheet(b))) > 0.999 &&
         std::abs(dot(normal, b.center - a.center)) < sheet_thickness;
}

/// From a point of a solid to where the solid has an edge, or is round.
double
distanceToOwnEdge(const Primitive& primitive, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d local = toLocal(primitive, point);
  if (primitive.shape == Shape::box) {
    if (isSheet(primitive))
      return std::numeric_limits<double>::infinity();
    Eigen::Vector3d inside = primitive.half - local.cwiseAbs();
    std::sort(inside.data(), inside.data() + 3);
    return inside[1]; // the least is 0: the point lies on a face
  }
  const double radius = primitive.half.x();
  if (primitive.shape == Shape::capsule)
    return roundness * radius;
  const double out = std::sqrt(local.x() * local.x() + local.y() * local.y());
  const double below_end = primitive.half.z() - std::abs(local.z());
  return std::max(std::min(roundness * radius, below_end), radius - out);
}

/// From a point of primitive \a self to the next edge, crease or contact.
double
distanceToFeature(const std::vector<Primitive>& primitives,
                  std::size_t self,
                  const Eigen::Vector3d& point)
{
  double nearest = std::min(farthest, distanceToOwnEdge(primitives[self], point));
  for (std::size_t other = 0; other < primitives.size(); ++other) {
    const Primitive& primitive = primitives[other];
    const Eigen::Vector3d away =
        (toLocal(primitive, point).cwiseAbs() - primitive.half).cwiseMax(0.0);
    if (other == self || dot(away, away) >= nearest * nearest ||
        shareAPlane(primitives[self], primitive))
      continue;
    nearest = std::min(nearest, distanceTo(primitive, point));
  }
  return nearest;
}

std::vector<double>
distancesToFeatures(const RoomScene& scene, const LabelledScan& dense)
{
  std::vector<double> distances;
  distances.reserve(dense.points.size());
  for (std::size_t i = 0; i < dense.points.size(); ++i)
    distances.push_back(distanceToFeature(
        scene.primitives, dense.primitive[i], dense.points[i].cast<double>()));
  return distances;
}

/// 0, 1 or 2: how often the cell of a point is doubled.
unsigned
levelAt(double distance_in_widths)
{
  return static_cast<unsigned>(
      std::upper_bound(widen_at.begin(), widen_at.end(), distance_in_widths) -
      widen_at.begin());
}

/// The first point of each cell, when the least cells are \a width wide.
std::vector<std::size_t>
firstOfCells(const LabelledScan& dense,
             const std::vector<double>& distances,
             double width)
{
  std::vector<std::pair<Cell, std::size_t>> cells;
  cells.reserve(dense.points.size());
  for (std::size_t i = 0; i < dense.points.size(); ++i) {
    const unsigned level = levelAt(distances[i] / width);
    const double side = width * (1u << level);
    const auto place = [&](int axis) {
      return static_cast<std::int64_t>(
          std::floor(static_cast<double>(dense.points[i][axis]) / side));
    };
    cells.emplace_back(Cell{level, place(0), place(1), place(2), dense.instance[i]}, i);
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (i == 0 || cells[i].first != cells[i - 1].first)
      first.push_back(cells[i].second);
  std::sort(first.begin(), first.end());
  return first;
}

} // namespace

LabelledScan
sampleMeshVertices(const RoomScene& scene, std::size_t count, std::uint64_t seed)
{
  const LabelledScan dense = sampleRoomEvenly(scene, oversampling * count, seed);
  const std::vector<double> distances = distancesToFeatures(scene, dense);
  double fine = 0.0005;
  double coarse = 1.0;
  std::vector<std::size_t> kept = firstOfCells(dense, distances, fine);
  const std::size_t enough = count + count / surplus_share;
  for (int step = 0; step < bisections && kept.size() > enough; ++step) {
    const double width = (fine + coarse) / 2;
    std::vector<std::size_t> first = firstOfCells(dense, distances, width);
    if (first.size() < count) {
      coarse = width;
      continue;
    }
    fine = width;
    kept = std::move(first);
  }
  if (kept.size() < count)
    throw CIDException(std::to_string(count) +
                       " mesh vertices are more than the room has places for; allowed "
                       "are fewer");
  RandomGenerator generator(seed);
  thin(kept, count, generator);
  return selected(dense, kept);
}

} // namespace pcl_cid::test
