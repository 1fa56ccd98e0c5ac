/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls and the points as they stand in the file: work is done in float, a file may
 * hold double.
 */

#include "file_points.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

namespace pcl_cid::tools {
namespace {

/** Positions in a set of the points with these indices, which are ascending. */
pcl::Indices
positionsOf(const pcl::Indices& indices, const PointSet& points)
{
  pcl::Indices positions;
  auto source = points.source.begin();
  for (const pcl::index_t index : indices) {
    source = std::lower_bound(source, points.source.end(), index);
    positions.push_back(
        static_cast<pcl::index_t>(std::distance(points.source.begin(), source)));
  }
  return positions;
}

/** How far a point is outside of a hull, at most. */
double
excessOf(const TriangleMesh& hull, const std::vector<Eigen::Vector3d>& points)
{
  double most = 0.0;
  for (const auto& [a, b, c] : hull.triangles) {
    const Eigen::Vector3d& corner = hull.vertices[a];
    const Eigen::Vector3d normal =
        (hull.vertices[b] - corner).cross(hull.vertices[c] - corner).normalized();
    for (const Eigen::Vector3d& p : points)
      most = std::max(most, normal.dot(p - corner));
  }
  return most;
}

double
diagonalOf(const TriangleMesh& hull)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : hull.vertices)
    box.extend(vertex);
  return box.diagonal().norm();
}

/** A hull again that contains its points as the file has them. */
void
cover(const std::vector<Eigen::Vector3d>& in_file,
      const PointSet& points,
      ConvexPartOptions options,
      ConvexPart& part)
{
  constexpr int attempts = 10;
  const pcl::Indices members = positionsOf(part.indices, points);
  const pcl::Indices trimmed = std::move(part.trimmed);
  options.trim_distance = 0.0; // what was astray is no longer among the points
  double missing = excessOf(part.hull, in_file);
  // A hull may miss its points by hull_tolerance of its size, which padding must
  // exceed.
  double more = std::max(2.0 * missing, 0.01 * hull_tolerance * diagonalOf(part.hull));
  for (int i = 0; i < attempts && missing > unnoticed_rounding; ++i, more *= 2.0) {
    options.padding += more;
    part = makeConvexPart(points, members, options);
    missing = excessOf(part.hull, in_file);
  }
  part.trimmed = trimmed;
}

} // namespace

double
roundingOf(const pcl::Indices& indices,
           const CloudPoints& points,
           const FileCoordinates& coordinates)
{
  double most = 0.0;
  for (const pcl::index_t index : indices) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3d local = (*points.points)[i].getVector3fMap().cast<double>();
    most = std::max(most, (coordinates[i] - points.frame.toFile(local)).norm());
  }
  return most;
}

void
coverFilePoints(const LoadedScan& scan, AbstractedScan& abstracted)
{
  constexpr double large = 1000.0; // metres: hull_tolerance is a centimetre then
  const FileCoordinates coordinates(scan.cloud);
  PointSet points;
  for (std::size_t k = 0; k < abstracted.parts.size(); ++k) {
    ConvexPart& part = abstracted.parts[k];
    if (roundingOf(part.indices, scan.points, coordinates) <= unnoticed_rounding &&
        diagonalOf(part.hull) <= large)
      continue;
    if (points.points.empty())
      points = finitePoints(*scan.points.points);
    std::vector<Eigen::Vector3d> in_file;
    for (const pcl::index_t index : part.indices)
      in_file.push_back(
          scan.points.frame.toLocal(coordinates[static_cast<std::size_t>(index)]));
    cover(in_file, points, abstracted.optionsOf(k), part);
  }
}

} // namespace pcl_cid::tools
