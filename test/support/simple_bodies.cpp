/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scene of simple bodies: most of its parts are primitives.
 */

#include "simple_bodies.h"

#include "hulls.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_formats.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {
namespace {

constexpr double pi = 3.14159265358979323846;

/** Points in rings about the z axis; a ring for each height, of a radius each. */
template <typename Radius>
Points
rings(double height, const Radius& radius)
{
  constexpr int heights = 24;
  constexpr int corners = 24;
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(0.9, -0.3, 0.5, 0.2 * height).normalized();
  Points points;
  for (int i = 0; i <= heights; ++i)
    for (int k = 0; k < corners; ++k) {
      const double z = -0.5 * height * std::cos(pi * i / heights);
      const double angle = 2.0 * pi * k / corners;
      const double r = radius(z);
      points.push_back(
          (turn * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z))
              .cast<float>());
    }
  return points;
}

Points
at(float x, Points points)
{
  for (Eigen::Vector3f& p : points)
    p += Eigen::Vector3f(x, 0.3f * x, -0.2f);
  return points;
}

Points
askewBox()
{
  const Eigen::Quaternionf turn =
      Eigen::Quaternionf(0.7f, 0.2f, -0.6f, 0.1f).normalized();
  Points points;
  for (int i = 0; i < 27; ++i)
    points.push_back(turn * Eigen::Vector3f(0.2f * static_cast<float>(i % 3),
                                            0.3f * static_cast<float>(i / 3 % 3),
                                            0.1f * static_cast<float>(i / 9)));
  return points;
}

} // namespace

SimpleBodies
simpleBodies(const std::vector<HullPrimitive::Kind>& kinds,
             const Eigen::Vector3d& offset)
{
  const auto ball = [](double r) {
    return [r](double z) { return std::sqrt(std::max(0.0, r * r - z * z)); };
  };
  const Points pyramid = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5f, 0.5f, 1}};
  SimpleBodies bodies;
  bodies.content = partsOf(
      "simple bodies",
      {askewBox(),
       at(2.0f, rings(0.8, ball(0.4))),
       at(4.0f, rings(0.9, [](double) { return 0.2; })),
       at(6.0f,
          rings(1.2,
                [&](double z) { return ball(0.2)(std::max(0.0, std::abs(z) - 0.4)); })),
       at(8.0f, pyramid)},
      offset);
  bodies.description.origin = sceneOrigin(bodies.content.parts);
  PrimitiveOptions options;
  options.kinds = kinds;
  bodies.description.primitives =
      fitPrimitives(bodies.content.parts, Frame{offset}, options);
  return bodies;
}

std::string
SimpleBodies::textIn(const std::string& format) const
{
  std::ostringstream text;
  findSceneFormat(format)->write(text, content.parts, description);
  return text.str();
}

void
expectHolds(const HullPrimitive& read, const SimpleBodies& bodies, std::size_t part)
{
  const HullPrimitive* expected = primitiveOf(part, bodies.description);
  ASSERT_NE(expected, nullptr) << partName(part);
  EXPECT_STREQ(nameOf(read.kind), nameOf(expected->kind)) << partName(part);
  for (const pcl::index_t point : bodies.content.parts[part].indices)
    EXPECT_LE(excess(read, bodies.content.points[static_cast<std::size_t>(point)]), 0.0)
        << partName(part);
  EXPECT_NEAR(volumeOf(read), volumeOf(*expected), 1e-6) << partName(part);
}

} // namespace pcl_cid::test
