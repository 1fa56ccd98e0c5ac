/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Normals of the surface, without orientation, and how curved it is.
 */

#include "surface_normals.h"

#include "base/parallel_for.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace pcl_cid {
namespace {

/** Second moments of a point and its neighbors about their mean. In coordinates about
 *  the point, so that none is large. */
Eigen::Matrix3d
spreadAround(const Points& points, const NearestNeighbors& neighbors, std::size_t point)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < neighbors.count(); ++k) {
    const auto q = static_cast<std::size_t>(neighbors.neighbor(point, k));
    const Eigen::Vector3d d = points[q].cast<double>() - points[point].cast<double>();
    sum += d;
    squares += d * d.transpose();
  }
  return squares - sum * sum.transpose() / static_cast<double>(1 + neighbors.count());
}

struct PointShape {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  float curvature = 1.0f;
};

PointShape
shapeOf(const Eigen::Matrix3d& spread)
{
  // Of lines, the second eigenvalue is noise.
  constexpr double flat = 1e-6;
  const double size = spread.trace();
  if (!(size > 0.0))
    return {};
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(spread / size);
  if (!(solver.eigenvalues()[1] > flat))
    return {};
  const Eigen::Vector3f normal =
      solver.eigenvectors().col(0).normalized().cast<float>();
  Eigen::Index largest = 0; // the first of equal ones
  normal.cwiseAbs().maxCoeff(&largest);
  return {normal[largest] < 0.0f ? Eigen::Vector3f(-normal) : normal,
          static_cast<float>(std::max(solver.eigenvalues()[0], 0.0))};
}

template <typename Visit>
void
forEachPoint(std::size_t points, const ExecutionOptions& execution, const Visit& visit)
{
  Progress progress(execution.progress);
  parallelFor(points,
              1024,
              threadCount(execution.threads),
              progress,
              {0.0, 0.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                  visit(i);
              });
}

} // namespace

std::vector<Eigen::Vector3f>
surfaceNormals(const Points& points,
               const NearestNeighbors& neighbors,
               const ExecutionOptions& execution,
               const std::vector<bool>& wanted)
{
  std::vector<Eigen::Vector3f> normals(points.size(), Eigen::Vector3f::Zero());
  forEachPoint(points.size(), execution, [&](std::size_t i) {
    if (wanted.empty() || wanted[i])
      normals[i] = shapeOf(spreadAround(points, neighbors, i)).normal;
  });
  return normals;
}

SurfaceShape
surfaceShape(const Points& points,
             const NearestNeighbors& neighbors,
             const ExecutionOptions& execution)
{
  SurfaceShape shape;
  shape.normals.resize(points.size());
  shape.curvatures.resize(points.size());
  forEachPoint(points.size(), execution, [&](std::size_t i) {
    const PointShape at = shapeOf(spreadAround(points, neighbors, i));
    shape.normals[i] = at.normal;
    shape.curvatures[i] = at.curvature;
  });
  return shape;
}

} // namespace pcl_cid
