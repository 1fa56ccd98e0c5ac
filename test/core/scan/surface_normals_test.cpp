/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Normals against a literal search, and on surfaces that are known.
 */

#include "clouds.h"
#include "prepared_points.h"
#include "scan/surface_normals.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <Eigen/SVD>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr std::size_t neighbors = 17;

std::vector<Eigen::Vector3f>
normalsOf(const Points& points)
{
  return surfaceNormals(points, neighbors, onThreads(1));
}

/** The nearest points about their mean, by a search of all. */
Eigen::MatrixX3d
nearestAboutMean(const Points& points, std::size_t i)
{
  std::vector<std::pair<float, std::size_t>> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3f d = points[i] - points[k];
    order.emplace_back((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z(), k);
  }
  std::sort(order.begin(), order.end());
  order.resize(std::min(order.size(), neighbors));
  Eigen::MatrixX3d rows(order.size(), 3);
  for (std::size_t k = 0; k < order.size(); ++k)
    rows.row(static_cast<Eigen::Index>(k)) =
        points[order[k].second].cast<double>().transpose();
  const Eigen::RowVector3d mean = rows.colwise().mean();
  return rows.rowwise() - mean;
}

class NormalsOfPoints : public testing::TestWithParam<NamedPoints> {};

/** No direction has a smaller spread, up to what float leaves of the normal. */
TEST_P(NormalsOfPoints, PointWhereTheNearestPointsSpreadLeast)
{
  const Points& points = GetParam().points;
  const std::vector<Eigen::Vector3f> normals = normalsOf(points);
  ASSERT_EQ(normals.size(), points.size());
  const std::size_t stride = std::max<std::size_t>(1, points.size() / 200);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Eigen::Vector3d normal = normals[i].cast<double>();
    if (normal.isZero(0.0))
      continue;
    EXPECT_NEAR(normal.norm(), 1.0, 1e-6) << i;
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    EXPECT_GT(normal[largest], 0.0) << i;
    const Eigen::MatrixX3d rows = nearestAboutMean(points, i);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd{Eigen::MatrixXd(rows)};
    const double least = rows.rows() < 3 ? 0.0 : svd.singularValues()[2];
    EXPECT_NEAR((rows * normal).norm(), least, 1e-5 * svd.singularValues()[0]) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(AllClouds,
                         NormalsOfPoints,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(SurfaceNormals, OfAPlaneAreItsOwn)
{
  Points points;
  for (int x = 0; x < 9; ++x)
    for (int y = 0; y < 9; ++y)
      points.emplace_back(
          0.1f * static_cast<float>(x), 3.0f, -0.1f * static_cast<float>(y));
  for (const Eigen::Vector3f& normal : normalsOf(points))
    EXPECT_TRUE(normal.isApprox(Eigen::Vector3f::UnitY(), 1e-6f)) << normal;
}

TEST(SurfaceNormals, AreNoneWithoutAPlane)
{
  Points line;
  for (int k = 0; k < 30; ++k)
    line.push_back(0.1f * static_cast<float>(k) * Eigen::Vector3f(1.0f, 2.0f, 3.0f));
  const Points same(20, Eigen::Vector3f(1.0f, 2.0f, 3.0f));
  const Points two = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
  for (const Points& points : {line, same, two, Points(1, same[0]), Points()})
    for (const Eigen::Vector3f& normal : normalsOf(points))
      EXPECT_TRUE(normal.isZero(0.0f)) << normal;
}

TEST(SurfaceNormals, AreTheSameOnAllThreads)
{
  const Points points = twoBoxes(5000, 3);
  const std::vector<Eigen::Vector3f> normals = normalsOf(points);
  for (const unsigned int threads : {2u, 3u, 8u})
    EXPECT_EQ(surfaceNormals(points, neighbors, onThreads(threads)), normals);
}

} // namespace
} // namespace pcl_cid::test
