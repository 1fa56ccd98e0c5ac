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
#include <numeric>
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

/** Whether a hull may miss more of its points, as the file has them, than may go
 *  unnoticed. */
bool
mayMiss(double rounding, const TriangleMesh& hull)
{
  constexpr double large = 1000.0; // metres: hull_tolerance is a centimetre then
  return rounding > unnoticed_rounding || diagonalOf(hull) > large;
}

/** A hull again; the part keeps its indices. */
void
remake(const PointSet& points,
       const pcl::Indices& members,
       const ConvexPartOptions& options,
       ConvexPart& part)
{
  ConvexPart made = makeConvexPart(points, members, options);
  made.indices = std::move(part.indices);
  made.trimmed = std::move(part.trimmed);
  part = std::move(made);
}

/** A hull again that contains its points as the file has them. */
void
cover(const std::vector<Eigen::Vector3d>& in_file,
      const PointSet& points,
      const pcl::Indices& members,
      ConvexPartOptions options,
      ConvexPart& part)
{
  constexpr int attempts = 10;
  options.trim_distance = 0.0; // what was astray is no longer among the points
  double missing = excessOf(part.hull, in_file);
  // A hull may miss its points by hull_tolerance of its size, which padding must
  // exceed.
  double more = std::max(2.0 * missing, 0.01 * hull_tolerance * diagonalOf(part.hull));
  for (int i = 0; i < attempts && missing > unnoticed_rounding; ++i, more *= 2.0) {
    options.padding += more;
    remake(points, members, options, part);
    missing = excessOf(part.hull, in_file);
  }
}

/** The points of a part of a scan, as they stand in the file. */
PartPoints
filePointsOf(std::size_t number,
             const ConvexPart& part,
             const FileCoordinates& coordinates)
{
  PartPoints of_part{number, part.indices, {}};
  for (const pcl::index_t index : part.indices)
    of_part.points.push_back(coordinates[static_cast<std::size_t>(index)]);
  return of_part;
}

/** All points of a set. */
pcl::Indices
allOf(const PointSet& points)
{
  pcl::Indices all(points.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

} // namespace

ShowParts
pointsOfParts(const LabelledCloud& cloud, const std::vector<ConvexPart>& parts)
{
  return [&cloud, &parts](const std::function<void(const PartPoints&)>& take) {
    const FileCoordinates coordinates(cloud);
    for (std::size_t k = 0; k < parts.size(); ++k)
      take(filePointsOf(k, parts[k], coordinates));
  };
}

double
roundingOf(const std::vector<Eigen::Vector3d>& points, const Frame& frame)
{
  double most = 0.0;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d local = frame.toLocal(p).cast<float>().cast<double>();
    most = std::max(most, (p - frame.toFile(local)).norm());
  }
  return most;
}

void
coverFilePoints(const LoadedScan& scan, AbstractedScan& abstracted)
{
  const Frame& frame = scan.points.frame;
  const FileCoordinates coordinates(scan.cloud);
  PointSet points;
  for (std::size_t k = 0; k < abstracted.parts.size(); ++k) {
    ConvexPart& part = abstracted.parts[k];
    const PartPoints of_part = filePointsOf(k, part, coordinates);
    if (!mayMiss(roundingOf(of_part.points, frame), part.hull))
      continue;
    if (points.points.empty())
      points = finitePoints(*scan.points.points);
    cover(frame.toLocal(of_part.points),
          points,
          positionsOf(part.indices, points),
          abstracted.optionsOf(k),
          part);
  }
}

void
coverExtremes(const ExtremePoints& extremes, AbstractedScan& abstracted)
{
  for (std::size_t k = 0; k < abstracted.parts.size(); ++k) {
    ConvexPart& part = abstracted.parts[k];
    const ExtremePoints::Block in_file = extremes.of(k);
    Points coordinates;
    for (const Eigen::Vector3d& p : in_file)
      coordinates.push_back(p.cast<float>());
    const PointSet points(std::move(coordinates), pcl::Indices(in_file.size()));
    ConvexPartOptions options = abstracted.optionsOf(k);
    options.trim_distance = 0.0; // what is astray is not among them
    remake(points, allOf(points), options, part);
    if (mayMiss(roundingOf(in_file, Frame()), part.hull))
      cover(in_file, points, allOf(points), options, part);
  }
}

} // namespace pcl_cid::tools
