/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Each guarantee broken on purpose, and found.
 */

#include "hulls.h"

#include <pcl_cid/core/hull_guarantees.h>
#include <pcl_cid/exceptions.h>

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** A cube of side 2 about the origin, made by hand. */
TriangleMesh
cube()
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(
        i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
  mesh.triangles = {{0, 2, 1},
                    {1, 2, 3},
                    {4, 5, 6},
                    {5, 7, 6},
                    {0, 1, 4},
                    {1, 5, 4},
                    {2, 6, 3},
                    {3, 6, 7},
                    {0, 4, 2},
                    {2, 4, 6},
                    {1, 3, 5},
                    {3, 7, 5}};
  return mesh;
}

const std::vector<Eigen::Vector3d> inside_cube = {
    {0.0, 0.0, 0.0}, {0.9, -0.9, 0.9}, {1.0, 1.0, 1.0}};

/** The sentence about a mesh, empty when all guarantees hold. */
std::string
verdict(const TriangleMesh& mesh, const ConvexPartOptions& options = {})
{
  return findBrokenGuarantee(mesh, inside_cube, options).value_or("");
}

void
expectVerdict(const TriangleMesh& mesh,
              const std::string& words,
              const ConvexPartOptions& options = {})
{
  EXPECT_NE(verdict(mesh, options).find(words), std::string::npos)
      << "'" << verdict(mesh, options) << "' does not say '" << words << "'";
}

TEST(BrokenGuarantee, NothingIsWrongWithACube)
{
  EXPECT_EQ(verdict(cube()), "");
  ConvexPartOptions options;
  options.max_vertices = 8;
  options.min_thickness = 2.0;
  EXPECT_EQ(verdict(cube(), options), "");
}

TEST(BrokenGuarantee, AMissingTriangle)
{
  TriangleMesh mesh = cube();
  mesh.triangles.pop_back();
  expectVerdict(mesh, "not closed");
  mesh.triangles.clear();
  expectVerdict(mesh, "no triangle");
}

TEST(BrokenGuarantee, ATriangleTwiceOrTurned)
{
  TriangleMesh twice = cube();
  twice.triangles.push_back(twice.triangles[0]);
  expectVerdict(twice, "not closed");
  TriangleMesh turned = cube();
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  expectVerdict(turned, "not closed");
}

TEST(BrokenGuarantee, AnUnusedOrUnknownOrInfiniteVertex)
{
  TriangleMesh unused = cube();
  unused.vertices.emplace_back(0.0, 0.0, 0.0);
  expectVerdict(unused, "vertex 8 is not used");
  TriangleMesh unknown = cube();
  unknown.triangles[3][1] = 8;
  expectVerdict(unknown, "triangle 3 names vertex 8");
  TriangleMesh infinite = cube();
  infinite.vertices[2].y() = std::numeric_limits<double>::quiet_NaN();
  expectVerdict(infinite, "vertex 2 is not finite");
}

TEST(BrokenGuarantee, TwoSurfacesInOne)
{
  TriangleMesh mesh = cube();
  for (const Eigen::Vector3d& v : cube().vertices)
    mesh.vertices.push_back(0.5 * v);
  for (const auto& [a, b, c] : cube().triangles)
    mesh.triangles.push_back({a + 8, b + 8, c + 8});
  expectVerdict(mesh, "not like a sphere's: 16 vertices - 36 edges + 24 triangles");
}

TEST(BrokenGuarantee, InsideOut)
{
  TriangleMesh mesh = cube();
  for (auto& triangle : mesh.triangles)
    std::swap(triangle[0], triangle[1]);
  expectVerdict(mesh, "not oriented outward");
}

/** The cube with a corner more, on the edge between corners 1 and 3. */
TriangleMesh
cubeWithCornerOnEdge(const Eigen::Vector3d& corner)
{
  TriangleMesh mesh = cube();
  mesh.vertices.push_back(corner);
  mesh.triangles[1] = {1, 2, 8};
  mesh.triangles[10] = {1, 8, 5};
  mesh.triangles.push_back({8, 2, 3});
  mesh.triangles.push_back({8, 3, 5});
  return mesh;
}

TEST(BrokenGuarantee, ADegenerateTriangle)
{
  EXPECT_EQ(verdict(cubeWithCornerOnEdge({1.0, 0.3, -1.0})), "");
  // Two vertices at one place, and one so near that the triangle is a needle.
  expectVerdict(cubeWithCornerOnEdge({1.0, 1.0, -1.0}), "is degenerate");
  expectVerdict(cubeWithCornerOnEdge({1.0, 1.0 - 1e-7, -1.0}), "is degenerate");
}

TEST(BrokenGuarantee, ADentOrABump)
{
  const double diagonal = std::sqrt(12.0);
  for (const double outward : {-1.0, 1.0}) {
    // Up to the cube's corners, the tilt of its neighbors makes 2 / 0.7 times as much.
    const double in_tolerance = 0.9 * (0.7 / 2.0) * hull_tolerance * diagonal * outward;
    EXPECT_EQ(verdict(cubeWithCornerOnEdge({1.0 + in_tolerance, 0.3, -1.0})), "");
  }
  expectVerdict(cubeWithCornerOnEdge({0.999, 0.3, -1.0}), "not convex");
  TriangleMesh bump = cube();
  bump.vertices[7] *= 1.01; // the diagonals of its three faces now point the wrong way
  expectVerdict(bump, "not convex");
}

TEST(BrokenGuarantee, APointOutside)
{
  const double tolerance = hull_tolerance * std::sqrt(12.0);
  for (const auto& [x, is_inside] : {std::pair{1.0 + 0.9 * tolerance, true},
                                     std::pair{1.0 + 1.1 * tolerance, false}})
    EXPECT_EQ(!findBrokenGuarantee(cube(), {{x, 0.2, 0.3}}, {}), is_inside) << x;
  const auto broken = findBrokenGuarantee(cube(), {{0, 0, 0}, {0, 0, 1.5}}, {});
  ASSERT_TRUE(broken);
  EXPECT_NE(broken->find("point 1 is not contained: it is 0.5 metres"),
            std::string::npos)
      << *broken;
}

TEST(BrokenGuarantee, TooLittlePadding)
{
  ConvexPartOptions options;
  options.padding = 0.2;
  EXPECT_FALSE(findBrokenGuarantee(cube(), {{0.79, 0.0, 0.0}}, options));
  EXPECT_TRUE(findBrokenGuarantee(cube(), {{0.81, 0.0, 0.0}}, options));
}

TEST(BrokenGuarantee, TooThinAlongAFaceNormal)
{
  ConvexPartOptions options;
  options.min_thickness = 2.001;
  expectVerdict(cube(), "too thin: the hull is 2 metres", options);
}

TEST(BrokenGuarantee, TooThinBetweenTwoEdges)
{
  // Its face normals see at least 4 / sqrt(3) = 2.31, its opposite edges 2.
  TriangleMesh tetrahedron;
  tetrahedron.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  tetrahedron.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  ConvexPartOptions options;
  options.min_thickness = 1.99;
  EXPECT_FALSE(findBrokenGuarantee(tetrahedron, {}, options));
  options.min_thickness = 2.2;
  const auto broken = findBrokenGuarantee(tetrahedron, {}, options);
  ASSERT_TRUE(broken);
  EXPECT_NE(broken->find("too thin: the hull is 2 metres"), std::string::npos)
      << *broken;
}

TEST(BrokenGuarantee, TooManyVertices)
{
  ConvexPartOptions options;
  options.max_vertices = 7;
  expectVerdict(cube(), "too many vertices: there are 8; at most 7", options);
}

TEST(BrokenGuarantee, WhatRoundingExplainsIsNone)
{
  for (const NamedPoints& cloud : randomClouds()) {
    Points far = cloud.points;
    for (Eigen::Vector3f& p : far)
      p += Eigen::Vector3f(16.0f, -32.0f, 8.0f);
    TriangleMesh hull = partOf(far).hull;
    const double rounding = floatRounding(hull);
    for (Eigen::Vector3d& v : hull.vertices)
      v = v.cast<float>().cast<double>();
    const auto broken = findBrokenGuarantee(hull, inDouble(far), {}, rounding);
    EXPECT_FALSE(broken) << cloud.name << ": " << *broken;
  }
  // A point that is out by more than rounding does is found all the same.
  TriangleMesh far_cube = cube();
  for (Eigen::Vector3d& v : far_cube.vertices)
    v.x() += 1000.0;
  const double rounding = floatRounding(far_cube);
  EXPECT_LT(rounding, 1e-4);
  EXPECT_FALSE(findBrokenGuarantee(far_cube, {{1001.0001, 0, 0}}, {}, rounding));
  EXPECT_TRUE(findBrokenGuarantee(far_cube, {{1001.001, 0, 0}}, {}, rounding));
}

TEST(BrokenGuarantee, RefusesBadValues)
{
  ConvexPartOptions options;
  options.min_thickness = 0.0;
  EXPECT_THROW(findBrokenGuarantee(cube(), {}, options), CIDException);
  EXPECT_THROW(findBrokenGuarantee(cube(), {}, {}, -1.0), CIDException);
}

} // namespace
} // namespace pcl_cid::test
