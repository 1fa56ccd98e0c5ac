/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The stages of the WCSeg-like peer, on shapes whose answer is known.
 */

#include "line_of_sight.h"
#include "normals.h"
#include "shape_diameter.h"
#include "surface_graph.h"
#include "weak_convexity.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::benchmarks {
namespace {

constexpr float step = 0.05f;

/** A rectangle from a corner along two sides, in a grid; the normal is u x v. */
void
addRectangle(const Eigen::Vector3f& corner,
             const Eigen::Vector3f& u,
             const Eigen::Vector3f& v,
             OrientedPoints& surface)
{
  const auto columns = static_cast<int>(u.norm() / step);
  const auto rows = static_cast<int>(v.norm() / step);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      surface.points.emplace_back(
          corner + u * (static_cast<float>(i) + 0.5f) / static_cast<float>(columns) +
          v * (static_cast<float>(j) + 0.5f) / static_cast<float>(rows));
      surface.normals.emplace_back(u.cross(v).normalized());
    }
}

/** All six sides of a box, looking outwards. */
void
addBox(const Eigen::Vector3f& low, const Eigen::Vector3f& size, OrientedPoints& surface)
{
  const Eigen::Vector3f x(size.x(), 0, 0);
  const Eigen::Vector3f y(0, size.y(), 0);
  const Eigen::Vector3f z(0, 0, size.z());
  addRectangle(low, y, x, surface);
  addRectangle(low, z, y, surface);
  addRectangle(low, x, z, surface);
  addRectangle(low + z, x, y, surface);
  addRectangle(low + x, y, z, surface);
  addRectangle(low + y, z, x, surface);
}

std::vector<int>
segment(const OrientedPoints& surface)
{
  WeakConvexityOptions options;
  options.patches = 20;
  options.reach = 2 * step;
  const DistanceField field(surface.points);
  return findWeaklyConvexSegments(
      surface, field, nearestNeighbors(surface.points, 8), options);
}

std::set<int>
segmentsOf(const std::vector<int>& segment, std::size_t begin, std::size_t end)
{
  return {segment.begin() + static_cast<std::ptrdiff_t>(begin),
          segment.begin() + static_cast<std::ptrdiff_t>(end)};
}

Graph
pathOfCliques(int cliques, int size, double bridge)
{
  Graph graph(static_cast<std::size_t>(cliques * size));
  const auto join = [&](int a, int b, double weight) {
    graph[static_cast<std::size_t>(a)].push_back({b, weight});
    graph[static_cast<std::size_t>(b)].push_back({a, weight});
  };
  for (int c = 0; c < cliques; ++c) {
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < i; ++j)
        join(c * size + i, c * size + j, 1.0);
    if (c > 0)
      join(c * size - 1, c * size, bridge);
  }
  return graph;
}

TEST(SurfaceGraph, BendIsThatOfTheDihedralAngle)
{
  const Eigen::Vector3f up(0, 0, 1);
  const Eigen::Vector3f right(1, 0, 0);
  // The floor ends where a wall, seen from the left, begins: an inner edge.
  const OrientedPoints inner{{{0, 0, 0}, {1, 0, 1}}, {up, -right}};
  EXPECT_EQ(bendBetween(inner, 0, 1), Bend::concave);
  // The top and the right side of a box.
  const OrientedPoints outer{{{0, 0, 1}, {1, 0, 0}}, {up, right}};
  EXPECT_EQ(bendBetween(outer, 0, 1), Bend::convex);
  const OrientedPoints plane{{{0, 0, 0}, {1, 0, 0}}, {up, up}};
  EXPECT_EQ(bendBetween(plane, 0, 1), Bend::convex);
  const OrientedPoints stair{{{0, 0, 0}, {1, 0, 1}}, {up, up}};
  EXPECT_EQ(bendBetween(stair, 0, 1), Bend::unclear);
}

TEST(SurfaceGraph, NeighborsAreMutual)
{
  OrientedPoints surface;
  addBox({0, 0, 0}, {0.4f, 0.3f, 0.2f}, surface);
  const auto near = nearestNeighbors(surface.points, 8);
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_GE(near[i].size(), 8u);
    for (const int j : near[i]) {
      const auto& back = near[static_cast<std::size_t>(j)];
      EXPECT_TRUE(std::binary_search(back.begin(), back.end(), static_cast<int>(i)));
    }
  }
}

TEST(NormalizedCuts, CutsWhereTheGraphIsWeakest)
{
  const std::vector<int> patch = cutIntoPatches(pathOfCliques(4, 7, 0.01), 4);
  EXPECT_EQ(std::set<int>(patch.begin(), patch.end()), (std::set<int>{0, 1, 2, 3}));
  for (std::size_t i = 0; i < patch.size(); ++i)
    EXPECT_EQ(patch[i], patch[i - i % 7]) << "node " << i;
}

TEST(NormalizedCuts, PatchesAreConnectedAndAsManyAsAskedFor)
{
  OrientedPoints surface;
  addRectangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0}, surface);
  const Graph graph = weighByBend(surface, nearestNeighbors(surface.points, 8));
  const std::vector<int> patch = cutIntoPatches(graph, 16);
  const int patches = *std::max_element(patch.begin(), patch.end()) + 1;
  EXPECT_GE(patches, 16);
  EXPECT_LT(patches, 32);
  for (int p = 0; p < patches; ++p) {
    std::vector<int> reached;
    std::set<int> members;
    for (std::size_t i = 0; i < patch.size(); ++i)
      if (patch[i] == p)
        members.insert(static_cast<int>(i));
    ASSERT_FALSE(members.empty());
    const std::size_t size = members.size();
    reached.push_back(*members.begin());
    members.erase(members.begin());
    for (std::size_t head = 0; head < reached.size(); ++head)
      for (const Edge& edge : graph[static_cast<std::size_t>(reached[head])])
        if (members.erase(edge.to) != 0)
          reached.push_back(edge.to);
    EXPECT_EQ(reached.size(), size) << "patch " << p << " is in pieces";
  }
}

TEST(NormalizedCuts, SingleNodesAndPiecesArePatches)
{
  Graph graph = pathOfCliques(2, 3, 1.0);
  graph.emplace_back(); // alone
  const std::vector<int> patch = cutIntoPatches(graph, 1);
  EXPECT_EQ(std::set<int>(patch.begin(), patch.end()).size(), 2u);
  EXPECT_NE(patch.front(), patch.back());
  // No more patches than nodes.
  const std::vector<int> all = cutIntoPatches(graph, 100);
  EXPECT_EQ(std::set<int>(all.begin(), all.end()).size(), graph.size());
}

TEST(LineOfSight, PointsOfABoxSeeEachOtherAndNoOtherBox)
{
  OrientedPoints surface;
  addBox({0, 0, 0}, {0.5f, 0.5f, 0.5f}, surface);
  const std::size_t first = surface.size();
  addBox({1, 0, 0}, {0.5f, 0.5f, 0.5f}, surface);
  const DistanceField field(surface.points);
  const LineOfSight sight(surface, field, 0.01f, 2 * step);
  for (std::size_t i = 0; i < surface.size(); i += 7)
    for (std::size_t j = 0; j < i; j += 11)
      // Sides that look up, say, are in one plane with those of the other box.
      if (const bool same_box = (i < first) == (j < first);
          same_box || std::abs(surface.normals[i].x()) > 0.5f) {
        EXPECT_EQ(sight.isFree(i, j), same_box) << i << " and " << j;
      }
}

TEST(LineOfSight, AWallBetweenBlocks)
{
  OrientedPoints surface;
  addRectangle({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, surface); // looks to -x
  const std::size_t left = surface.size();
  addRectangle({2, 0, 0}, {0, 1, 0}, {0, 0, 1}, surface); // looks to +x
  const std::size_t right = surface.size();
  const auto count = [&](const OrientedPoints& all) {
    const DistanceField field(all.points);
    const LineOfSight sight(all, field, 0.01f, 2 * step);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < left; i += 13)
      for (std::size_t j = left; j < right; j += 17)
        seen += sight.isFree(i, j) ? 1 : 0;
    return seen;
  };
  EXPECT_GT(count(surface), 0u);
  addRectangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, surface);
  EXPECT_EQ(count(surface), 0u);
}

TEST(LineOfSight, VisibilityOfPatchesIsTheShareOfTheirPairs)
{
  constexpr std::size_t size = 40;
  OrientedPoints surface;
  addBox({0, 0, 0}, {0.2f, 0.3f, 0.3f}, surface);
  addBox({0.6f, 0.2f, 0.2f}, {0.2f, 0.3f, 0.3f}, surface);
  std::vector<int> patch;
  for (std::size_t i = 0; i < surface.size(); ++i)
    patch.push_back(static_cast<int>(i / size));
  const DistanceField field(surface.points);
  const LineOfSight sight(surface, field, 0.01f, 2 * step);
  const std::vector<int> one_piece(surface.size(), 0);
  const Eigen::MatrixXf visible = mutualVisibility(sight, patch, one_piece, size);
  Eigen::MatrixXf seen = Eigen::MatrixXf::Zero(visible.rows(), visible.cols());
  Eigen::MatrixXf pairs = seen;
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (std::size_t j = 0; j < surface.size(); ++j)
      if (patch[i] != patch[j]) {
        pairs(patch[i], patch[j]) += 1.0f;
        seen(patch[i], patch[j]) += sight.isFree(i, j) ? 1.0f : 0.0f;
      }
  pairs.diagonal().setOnes();
  seen.diagonal().setOnes(); // by definition
  EXPECT_TRUE(visible.isApprox(seen.cwiseQuotient(pairs)));
  // Each patch a piece of its own.
  EXPECT_TRUE(mutualVisibility(sight, patch, patch, size).isIdentity());
}

TEST(ShapeDiameter, IsTheThicknessOfASlab)
{
  OrientedPoints slab;
  addRectangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, slab);
  addRectangle({0, 0, 0.2f}, {1, 0, 0}, {0, 1, 0}, slab);
  std::vector<std::size_t> all(slab.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<double> thickness = shapeDiameters(slab, all);
  EXPECT_FALSE(thickness.empty());
  for (const double t : thickness)
    EXPECT_NEAR(t, 0.2, 1e-6);
  all.resize(slab.size() / 2); // one side alone
  EXPECT_TRUE(shapeDiameters(slab, all).empty());
}

TEST(ShapeDiameter, DistancesOfHistograms)
{
  // All the earth of the first goes the whole way to the second, half of it to the
  // third.
  const Eigen::MatrixXd distance =
      histogramDistances({{0.0, 0.0}, {1.0}, {0.0, 1.0, 0.0, 1.0}, {}});
  EXPECT_DOUBLE_EQ(distance(0, 1), 1.0);
  EXPECT_DOUBLE_EQ(distance(0, 2), 0.5);
  EXPECT_DOUBLE_EQ(distance(1, 2), 0.5);
  EXPECT_EQ(distance(0, 0), 0.0);
  EXPECT_EQ(distance(3, 1), 0.0);
  EXPECT_EQ(distance, distance.transpose());
}

TEST(WeakConvexity, ABoxIsOneSegmentAndTwoBoxesAreTwo)
{
  OrientedPoints surface;
  addBox({0, 0, 0}, {0.5f, 0.6f, 0.7f}, surface);
  const std::size_t first = surface.size();
  EXPECT_EQ(segmentsOf(segment(surface), 0, first).size(), 1u);
  addBox({0.8f, 0, 0}, {0.5f, 0.6f, 0.7f}, surface);
  const std::vector<int> both = segment(surface);
  EXPECT_EQ(segmentsOf(both, 0, first), (std::set<int>{both.front()}));
  EXPECT_EQ(segmentsOf(both, first, surface.size()), (std::set<int>{both.back()}));
  EXPECT_NE(both.front(), both.back());
}

TEST(WeakConvexity, TheWallsOfARoomAreApart)
{
  OrientedPoints surface; // a floor and two walls, seen from inside
  addRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, surface);
  const std::size_t wall = surface.size();
  addRectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, surface);
  const std::size_t other = surface.size();
  addRectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, surface);
  const std::vector<int> found = segment(surface);
  EXPECT_EQ(segmentsOf(found, 0, wall), (std::set<int>{found[0]}));
  EXPECT_EQ(segmentsOf(found, wall, other), (std::set<int>{found[wall]}));
  EXPECT_EQ(segmentsOf(found, other, surface.size()), (std::set<int>{found[other]}));
  EXPECT_EQ(segmentsOf(found, 0, surface.size()).size(), 3u);
}

TEST(Normals, AreTurnedToTheOutside)
{
  OrientedPoints box;
  addBox({0, 0, 0}, {1, 1, 1}, box);
  const auto near = nearestNeighbors(box.points, 8);
  std::vector<Eigen::Vector3f> mixed = box.normals;
  for (std::size_t i = 0; i < mixed.size(); i += 3)
    mixed[i] = -mixed[i];

  std::vector<Eigen::Vector3f> inwards = mixed;
  orientNormals(box.points, near, {}, Orientation::center, inwards);
  for (std::size_t i = 0; i < box.size(); ++i)
    EXPECT_EQ(inwards[i], -box.normals[i]);

  // A sensor before each side.
  std::vector<Eigen::Vector3f> sensors;
  for (const Eigen::Vector3f& side : {Eigen::Vector3f(1.5f, 0, 0),
                                      Eigen::Vector3f(0, 1.5f, 0),
                                      Eigen::Vector3f(0, 0, 1.5f)})
    for (const float sign : {-1.0f, 1.0f})
      sensors.emplace_back(Eigen::Vector3f::Constant(0.5f) + sign * side);
  std::vector<Eigen::Vector3f> seen = mixed;
  orientNormals(box.points, near, sensors, Orientation::viewpoint, seen);
  for (std::size_t i = 0; i < box.size(); ++i)
    EXPECT_EQ(seen[i], box.normals[i]);

  // Within a side the tree never turns; the highest one looks up.
  std::vector<Eigen::Vector3f> followed = mixed;
  orientNormals(box.points, near, {}, Orientation::tree, followed);
  for (std::size_t i = 0; i < box.size(); ++i)
    if (box.normals[i].z() > 0.5f) {
      EXPECT_EQ(followed[i], box.normals[i]);
    }
}

TEST(Normals, AreEstimatedFromNeighbors)
{
  OrientedPoints plane;
  addRectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, plane);
  auto cloud = pcl::make_shared<Cloud>();
  for (const Eigen::Vector3f& p : plane.points)
    cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  const pcl::PointCloud<pcl::Normal>::Ptr normals = estimateNormals(cloud, 10);
  ASSERT_EQ(normals->size(), cloud->size());
  for (const pcl::Normal& normal : *normals)
    EXPECT_NEAR(std::abs(normal.normal_z), 1.0f, 1e-4f);
}

} // namespace
} // namespace pcl_cid::benchmarks
