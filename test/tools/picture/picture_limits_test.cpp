/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A picture of a large scan is small, and what it has of it is spread evenly.
 */

#include "cloud_files.h"
#include "picture/page_template.h"
#include "picture/picture.h"
#include "picture/thinning.h"
#include "picture_page.h"

#include <pcl_cid/core/hull_primitive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using tools::Picture;

/** A number from 0 to 1 that looks like chance. */
float
draw(std::size_t i, std::size_t what)
{
  const double x = std::sin(12.9898 * static_cast<double>(i) +
                            78.233 * (1.0 + static_cast<double>(what))) *
                   43758.5453;
  return static_cast<float>(x - std::floor(x));
}

/** A floor of 40 x 30 m and a wall, ten times as dense near a scanner. */
Points
unevenScan(std::size_t size)
{
  Points points;
  for (std::size_t i = 0; i < size; ++i) {
    const float reach = i % 10 == 0 ? 1.0f : 0.2f;
    const float x = 40.0f * reach * draw(i, 0);
    const float y = 30.0f * reach * draw(i, 1);
    points.emplace_back(x, i % 3 == 0 ? 0.0f : y, i % 3 == 0 ? 0.1f * y : 0.0f);
  }
  return points;
}

using Cell = std::array<int, 3>;

/** How many cells of a grid hold points. */
double
cellsOf(const Points& points, float side)
{
  std::set<Cell> cells;
  for (const Eigen::Vector3f& p : points)
    cells.insert({static_cast<int>(std::floor(p.x() / side)),
                  static_cast<int>(std::floor(p.y() / side)),
                  static_cast<int>(std::floor(p.z() / side))});
  return static_cast<double>(cells.size());
}

Points
taken(const Points& points, const std::vector<std::size_t>& positions, std::size_t most)
{
  Points some;
  for (std::size_t i = 0; i < std::min(most, positions.size()); ++i)
    some.push_back(points[positions[i]]);
  return some;
}

TEST(Thinning, TakesPointsFromEverywhere)
{
  const Points points = unevenScan(300'000);
  const auto positions = tools::spreadEvenly(points, tools::usualBox(points), 50'000);
  ASSERT_EQ(positions.size(), 50'000u);
  EXPECT_EQ(std::set<std::size_t>(positions.begin(), positions.end()).size(), 50'000u);
  // Of the cells with points, nearly all have some of those that were taken, and the
  // first ones are a thinner scan; drawn by chance, far fewer have.
  EXPECT_GE(cellsOf(taken(points, positions, 50'000), 0.3f),
            0.99 * cellsOf(points, 0.3f));
  EXPECT_GE(cellsOf(taken(points, positions, 4'000), 1.5f),
            0.99 * cellsOf(points, 1.5f));
  Points first(points.begin(), points.begin() + 50'000);
  EXPECT_LT(cellsOf(first, 0.3f), 0.8 * cellsOf(points, 0.3f));
  EXPECT_EQ(positions, tools::spreadEvenly(points, tools::usualBox(points), 50'000));
}

TEST(Thinning, TakesAllPointsWhereTheyAreFew)
{
  for (const Points& points :
       {Points{{1, 2, 3}}, Points(5, {1, 2, 3}), unevenScan(1000)}) {
    auto positions = tools::spreadEvenly(points, tools::usualBox(points), 1000);
    std::sort(positions.begin(), positions.end());
    ASSERT_EQ(positions.size(), points.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
      EXPECT_EQ(positions[i], i);
  }
}

TEST(Thinning, IsNotLedAstray)
{
  Points points = unevenScan(100'000);
  const Eigen::AlignedBox3f box = tools::usualBox(points);
  const auto cells =
      cellsOf(taken(points, tools::spreadEvenly(points, box, 20'000), 20'000), 0.5f);
  points.emplace_back(1e9f, 0.0f, -5000.0f);
  const Eigen::AlignedBox3f same = tools::usualBox(points);
  EXPECT_LT((same.max() - box.max()).norm() + (same.min() - box.min()).norm(), 15.0f);
  const auto after =
      cellsOf(taken(points, tools::spreadEvenly(points, same, 20'000), 20'000), 0.5f);
  EXPECT_GE(after, 0.98 * cells);
}

/** A scan with colors, far from the origin. */
tools::LoadedScan
coloredScan(std::size_t size)
{
  std::vector<double> x, y, z;
  std::vector<std::uint32_t> rgb;
  for (const Eigen::Vector3f& p : unevenScan(size)) {
    x.push_back(482000.25 + p.x());
    y.push_back(5470000.5 + p.y());
    z.push_back(110.0 + p.z());
    rgb.push_back(static_cast<std::uint32_t>(x.size()));
  }
  tools::LoadedScan scan;
  appendField("x", x, scan.cloud.fields);
  appendField("y", y, scan.cloud.fields);
  appendField("z", z, scan.cloud.fields);
  appendField("rgb", rgb, scan.cloud.fields);
  scan.points = pointsOf(scan.cloud);
  return scan;
}

class LargePicture : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (tools::pageTemplate().empty())
      GTEST_SKIP() << "this build has no page";
  }

  PicturePage
  pageOf(const Picture& picture,
         const tools::LoadedScan& scan,
         const Report& report = {})
  {
    const std::string path = folder_.file("page.html");
    tools::Run run("test", true, {});
    run.report = report;
    tools::announcePicture(path, run.outputs);
    tools::savePicture(path, picture, scan, run);
    run.outputs.commit();
    const std::string page = readText(path);
    EXPECT_LT(page.size(), tools::most_picture_bytes);
    return PicturePage(page);
  }

  TemporaryFolder folder_;
};

TEST_F(LargePicture, IsBelowItsLimit)
{
  const tools::LoadedScan scan = coloredScan(1'000'000);
  std::vector<std::uint32_t> labels;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) // more than can be listed
    labels.push_back(static_cast<std::uint32_t>(i % 77'777));
  Picture picture{Picture::Kind::labels, &labels};
  picture.instances = {{5, std::string(2'000'000, 'x'), ""},
                       {6, "", std::string(100'000, '<')}};
  Report report;
  report.input = "scan.pcd";
  report.remarks.assign(5000, std::string(500, '<'));
  const PicturePage page = pageOf(picture, scan, report);
  EXPECT_EQ(page.positions.size(), 3 * tools::most_picture_points);
  EXPECT_EQ(page.colors.size(), 3 * tools::most_picture_points);
  EXPECT_EQ(page.facts["indices"], 77'776);
  EXPECT_GT(page.facts["marks"].size(), 1000u);
  EXPECT_LT(page.facts["marks"].size(), 77'776u);
  for (std::size_t i = 0; i < tools::most_picture_points; ++i) {
    const std::size_t point =
        (std::size_t{page.colors[3 * i]} << 16 |
         std::size_t{page.colors[3 * i + 1]} << 8 | page.colors[3 * i + 2]) -
        1;
    ASSERT_EQ(page.labels[i], labels[point]);
    ASSERT_LT((page.position(i) - FileCoordinates(scan.cloud)[point]).norm(), 1e-4);
  }
}

TEST_F(LargePicture, HasTheHullsOfTheLargestParts)
{
  const tools::LoadedScan scan = coloredScan(250'000);
  HullPrimitive ball;
  ball.kind = HullPrimitive::Kind::sphere;
  ball.center = {482000.0, 5470000.0, 110.0};
  ball.extents.setConstant(2.0);
  ConvexPart part;
  part.hull = meshAround(ball);
  std::vector<ConvexPart> parts(5000, part);
  for (std::size_t i = 0; i < 200'000; ++i) // the last ones are the largest
    parts[static_cast<std::size_t>(5000.0 *
                                   std::sqrt(static_cast<double>(i) / 200'000.0))]
        .indices.push_back(static_cast<int>(i));
  Report report;
  report.input = "scan.pcd";
  report.parts = &parts;
  const PicturePage page = pageOf(tools::pictureOf(parts), scan, report);
  const std::size_t shown = page.facts["hulls"].size();
  EXPECT_GT(shown, 20u);
  EXPECT_LT(shown, 5000u);
  std::size_t least = scan.cloud.size();
  std::set<std::size_t> seen;
  for (const nlohmann::json& hull : page.facts["hulls"]) {
    seen.insert(hull["part"].get<std::size_t>() - 1);
    least = std::min(least, parts[*seen.rbegin()].indices.size());
  }
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (seen.count(k) == 0) {
      EXPECT_LE(parts[k].indices.size(), least + 1);
    }
  EXPECT_EQ(page.facts["report"]["parts"], 5000);
}

} // namespace
} // namespace pcl_cid::test
