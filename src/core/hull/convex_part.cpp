/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A part and its hull: points, thickened, hulled, padded, reduced.
 */

#include "base/parallel_for.h"
#include "base/requirements.h"
#include "base/sentence.h"
#include "box_mesh.h"
#include "clean_hull.h"
#include "hull_mesh.h"
#include "hull_reduction.h"
#include "hull_width.h"
#include "principal_box.h"
#include "stray_points.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl_cid {
namespace {

using LocalPoints = std::vector<Eigen::Vector3d>;

bool
lexicographicallyLess(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

LocalPoints
distinctPoints(const Points& points, const pcl::Indices& members)
{
  LocalPoints distinct;
  distinct.reserve(members.size());
  for (const pcl::index_t member : members)
    distinct.push_back(points[static_cast<std::size_t>(member)].cast<double>());
  std::sort(distinct.begin(), distinct.end(), lexicographicallyLess);
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  return distinct;
}

pcl::Indices
sourcesOf(const PointSet& points, const pcl::Indices& members)
{
  pcl::Indices sources;
  sources.reserve(members.size());
  for (const pcl::index_t member : members)
    sources.push_back(points.source[static_cast<std::size_t>(member)]);
  std::sort(sources.begin(), sources.end());
  return sources;
}

/** What \a min_thickness is raised to: a hull thinner than its tolerance may as well be
 *  flat, and one hardly thicker than the rounding of its coordinates would lose its
 *  shape. */
double
feasibleThickness(const PrincipalBox& box,
                  const Eigen::Vector3d& origin,
                  double min_thickness)
{
  constexpr double resolution = 1e-10; // of double, with six digits to spare
  const double farthest = (origin + box.center).cwiseAbs().maxCoeff();
  return std::max(
      {min_thickness, hull_tolerance * box.extents.norm(), resolution * farthest});
}

/** Move each point along an axis of the box to either side of a slab about its
 *  middle. */
LocalPoints
onSlab(const LocalPoints& points, const PrincipalBox& box, int axis, double thickness)
{
  LocalPoints moved;
  moved.reserve(2 * points.size());
  for (const Eigen::Vector3d& p : points) {
    Eigen::Vector3d local = box.toLocal(p);
    for (const double side : {-0.5 * thickness, 0.5 * thickness}) {
      local[axis] = side;
      moved.push_back(box.fromLocal(local));
    }
  }
  return moved;
}

/** Thicken along the principal axes: a flat part becomes a slab, a line a bar, a point
 *  a cube. What comes out fills space. */
LocalPoints
thickPoints(LocalPoints points, const PrincipalBox& box, double thickness)
{
  for (int axis = 0; axis < 3; ++axis)
    if (box.extents[axis] < thickness)
      points = onSlab(points, box, axis, thickness);
  return points;
}

/** The points, moved by half of a shift to either side: the hull is that of the points,
 *  wider by the length of the shift, and symmetric about it. */
LocalPoints
widened(const LocalPoints& points, const Eigen::Vector3d& shift)
{
  LocalPoints moved;
  moved.reserve(2 * points.size());
  for (const Eigen::Vector3d& p : points) {
    moved.push_back(p - 0.5 * shift);
    moved.push_back(p + 0.5 * shift);
  }
  return moved;
}

/** The hull of points that fill space, thickened until it is thick enough in every
 *  direction; no triangles when there is none. Each round makes one more direction
 *  thick and none thinner; a few are enough. */
TriangleMesh
thickHull(const LocalPoints& points, double thickness, bool& thickened)
{
  constexpr int most_rounds = 20;
  TriangleMesh hull = convexHull(points);
  for (int round = 0; round < most_rounds && !hull.triangles.empty(); ++round) {
    const Width least = leastWidth(hull);
    if (least.width >= thickness * (1.0 - hull_tolerance))
      return hull;
    thickened = true;
    const double missing = thickness * (1.0 + 0.1 * hull_tolerance) - least.width;
    hull = convexHull(widened(hull.vertices, missing * least.direction));
  }
  return {};
}

/** The Minkowski sum with a cube along the principal axes, in which the ball of radius
 *  \a padding just fits. */
TriangleMesh
padded(const TriangleMesh& hull, double padding)
{
  if (padding == 0.0 || hull.triangles.empty())
    return hull;
  const Eigen::Matrix3d axes = principalBox(hull.vertices).axes;
  LocalPoints points = hull.vertices;
  for (int axis = 0; axis < 3; ++axis)
    points = widened(points, 2.0 * padding * axes.col(axis));
  return convexHull(points);
}

/** The box of the points, as thick as the hull would be and padded. */
TriangleMesh
paddedBox(PrincipalBox box, double thickness, const ConvexPartOptions& options)
{
  box.extents = box.extents.cwiseMax(thickness).array() + 2.0 * options.padding;
  return boxMesh(box, options.max_vertices);
}

/** The hull of the part's points in all its steps; the points' box, should qhull
 *  fail. */
void
makeHull(const LocalPoints& points,
         const Eigen::Vector3d& origin,
         const ConvexPartOptions& options,
         ConvexPart& part)
{
  const PrincipalBox box = principalBox(points);
  const double thickness = feasibleThickness(box, origin, options.min_thickness);
  part.thickened = box.extents.minCoeff() < thickness;
  part.hull = thickHull(thickPoints(points, box, thickness), thickness, part.thickened);
  part.hull = padded(part.hull, options.padding);
  part.hull = reduceOutward(part.hull, options.max_vertices);
  part.boxed = part.hull.triangles.empty();
  if (part.boxed)
    part.hull = paddedBox(box, thickness, options);
}

} // namespace

void
requireValid(const ConvexPartOptions& options)
{
  require(setting::min_thickness, options.min_thickness);
  require(setting::padding, options.padding);
  require(setting::trim_distance, options.trim_distance);
  requireCount(setting::max_vertices, options.max_vertices);
}

ConvexPart
makeConvexPart(const PointSet& points,
               const pcl::Indices& members,
               const ConvexPartOptions& options)
{
  if (members.empty())
    throw CIDException("a convex part has no point; at least 1 is needed");
  requireValid(options);
  const TrimmedPart members_left =
      trimStrayPoints(points.points, members, options.trim_distance);
  ConvexPart part;
  part.indices = sourcesOf(points, members_left.kept);
  part.trimmed = sourcesOf(points, members_left.trimmed);
  makeHull(distinctPoints(points.points, members_left.kept),
           points.frame.origin,
           options,
           part);
  part.volume = volumeOf(part.hull);
  part.area = areaOf(part.hull);
  part.thickness = leastWidth(part.hull).width;
  for (Eigen::Vector3d& v : part.hull.vertices)
    v = points.frame.toFile(v);
  return part;
}

std::vector<ConvexPart>
makeConvexParts(const PointSet& points,
                const std::vector<int>& part,
                const ConvexPartOptions& options,
                const ExecutionOptions& execution)
{
  requireValid(options);
  std::vector<pcl::Indices> members;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] < 0)
      continue;
    const auto number = static_cast<std::size_t>(part[i]);
    members.resize(std::max(members.size(), number + 1));
    members[number].push_back(static_cast<pcl::index_t>(i));
  }
  std::vector<ConvexPart> parts(members.size());
  Progress progress(execution.progress);
  parallelForEach(
      parts.size(),
      threadCount(execution.threads),
      progress,
      {0.0, 1.0},
      [&](std::size_t k) { parts[k] = makeConvexPart(points, members[k], options); });
  return parts;
}

} // namespace pcl_cid
