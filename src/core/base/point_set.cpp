/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The finite points of a cloud about a local origin.
 */

#include <pcl_cid/core/point_set.h>

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

void
dropNotFinite(Points& points, pcl::Indices& source)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      continue;
    points[kept] = points[i];
    source[kept] = source[i];
    ++kept;
  }
  points.resize(kept);
  source.resize(kept);
}

/** The center of the bounding box, rounded to multiples of the smallest power of two
 *  that is no smaller than the box, or 0 when the center is within two of them: farther
 *  out, every coordinate is larger than its difference to the origin, so that float
 *  holds the difference exactly. */
Eigen::Vector3d
localOrigin(const Points& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : points)
    box.extend(p.cast<double>().eval());
  if (box.isEmpty())
    return Eigen::Vector3d::Zero();
  const double size = box.sizes().maxCoeff();
  if (size == 0.0)
    return box.min();
  const double unit = std::exp2(std::ceil(std::log2(size)));
  return box.center().unaryExpr([unit](double center) {
    return std::abs(center) < 2.0 * unit ? 0.0 : std::round(center / unit) * unit;
  });
}

void
moveTo(const Frame& frame, Points& points)
{
  if (frame.origin.isZero(0.0))
    return;
  for (Eigen::Vector3f& p : points)
    p = frame.toLocal(p.cast<double>()).cast<float>();
}

} // namespace

PointSet::PointSet(Points coordinates, pcl::Indices source_indices)
: points(std::move(coordinates)), source(std::move(source_indices))
{
  dropNotFinite(points, source);
  frame.origin = localOrigin(points);
  moveTo(frame, points);
}

PointSet::PointSet(Points coordinates,
                   pcl::Indices source_indices,
                   const Frame& given_frame)
: frame(given_frame), points(std::move(coordinates)), source(std::move(source_indices))
{
  dropNotFinite(points, source);
  moveTo(frame, points);
}

} // namespace pcl_cid
