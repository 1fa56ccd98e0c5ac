/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Normals of the surface, without orientation.
 */

#include "clouds.h"
#include "prepared_points.h"

#include "scan/surface_normals.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>

namespace pcl_cid::test {
namespace {

std::vector<Eigen::Vector3f>
normalsOf(const Points& points, unsigned int threads = 1)
{
  const ExecutionOptions execution = onThreads(threads);
  return surfaceNormals(
      points, NearestNeighbors(points, execution, NearestNeighbors::most), execution);
}

/** A point and its neighbors about their mean. */
Eigen::MatrixXd
aboutMean(const Points& points, const NearestNeighbors& neighbors, std::size_t i)
{
  Eigen::MatrixXd rows(1 + neighbors.count(), 3);
  rows.row(0) = points[i].cast<double>();
  for (std::size_t k = 0; k < neighbors.count(); ++k)
    rows.row(static_cast<Eigen::Index>(k + 1)) =
        points[static_cast<std::size_t>(neighbors.neighbor(i, k))].cast<double>();
  return rows.rowwise() - rows.colwise().mean().eval();
}

/// No direction has a smaller spread.
TEST(SurfaceNormals, AreWhereThePointsSpreadLeast)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const Points& points = cloud.points;
    const NearestNeighbors neighbors(points, onThreads(1), NearestNeighbors::most);
    const auto normals = normalsOf(points);
    ASSERT_EQ(normals.size(), points.size());
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 200) {
      const Eigen::MatrixXd rows = aboutMean(points, neighbors, i);
      if (rows.rows() < 3) {
        EXPECT_EQ(normals[i], Eigen::Vector3f::Zero()) << i;
        continue;
      }
      const Eigen::VectorXd spread =
          Eigen::JacobiSVD<Eigen::MatrixXd>(rows).singularValues();
      if (normals[i] == Eigen::Vector3f::Zero()) {
        EXPECT_LE(spread[1], 2e-3 * spread[0]) << i;
        continue;
      }
      EXPECT_NEAR(normals[i].norm(), 1.0f, 1e-6f) << i;
      EXPECT_NEAR(
          (rows * normals[i].cast<double>()).norm(), spread[2], 1e-5 * spread[0])
          << i;
      Eigen::Index largest = 0;
      normals[i].cwiseAbs().maxCoeff(&largest);
      EXPECT_GT(normals[i][largest], 0.0f) << i;
    }
  }
}

/// The smallest share of the spread, and the same normals.
TEST(SurfaceNormals, CurvaturesAreSharesOfTheSpread)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const Points& points = cloud.points;
    const NearestNeighbors neighbors(points, onThreads(1), NearestNeighbors::most);
    const SurfaceShape shape = surfaceShape(points, neighbors, onThreads(1));
    EXPECT_EQ(shape.normals, normalsOf(points));
    ASSERT_EQ(shape.curvatures.size(), points.size());
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 200) {
      if (shape.normals[i] == Eigen::Vector3f::Zero()) {
        EXPECT_EQ(shape.curvatures[i], 1.0f) << i;
        continue;
      }
      const Eigen::VectorXd spread =
          Eigen::JacobiSVD<Eigen::MatrixXd>(aboutMean(points, neighbors, i))
              .singularValues()
              .cwiseAbs2();
      EXPECT_NEAR(shape.curvatures[i], spread[2] / spread.sum(), 1e-6) << i;
      EXPECT_GE(shape.curvatures[i], 0.0f) << i;
    }
  }
}

TEST(SurfaceNormals, OfSomePointsAreThoseOfAll)
{
  const Points points = twoBoxes(500, 9);
  const NearestNeighbors neighbors(points, onThreads(1), NearestNeighbors::most);
  std::vector<bool> wanted(points.size());
  for (std::size_t i = 0; i < points.size(); i += 3)
    wanted[i] = true;
  const auto all = normalsOf(points);
  const auto some = surfaceNormals(points, neighbors, onThreads(1), wanted);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(some[i], wanted[i] ? all[i] : Eigen::Vector3f::Zero());
}

TEST(SurfaceNormals, OfAPlaneAreItsOwn)
{
  Points plane;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      plane.emplace_back(
          0.1f * static_cast<float>(i), 2.0f, 0.1f * static_cast<float>(j));
  for (const Eigen::Vector3f& normal : normalsOf(plane))
    EXPECT_NEAR(normal.y(), 1.0f, 1e-6f);
}

TEST(SurfaceNormals, AreNoneWherePointsSpanNoPlane)
{
  Points line;
  for (int i = 0; i < 30; ++i)
    line.emplace_back(0.3f * static_cast<float>(i), 0.1f * static_cast<float>(i), 1.0f);
  for (const Points& points : {line,
                               Points{Eigen::Vector3f(1.0f, 2.0f, 3.0f)},
                               Points(20, Eigen::Vector3f(1.0f, 2.0f, 3.0f))})
    for (const Eigen::Vector3f& normal : normalsOf(points))
      EXPECT_EQ(normal, Eigen::Vector3f::Zero());
}

TEST(SurfaceNormals, AreTheSameForDuplicatesAndAnyNumberOfThreads)
{
  Points points = twoBoxes(700, 5);
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(Eigen::Vector3f(points[i]));
  const auto normals = normalsOf(points);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_EQ(normals[i], normals[i + count]);
  for (const unsigned int threads : {2u, 3u, 8u})
    EXPECT_EQ(normalsOf(points, threads), normals);
}

} // namespace
} // namespace pcl_cid::test
