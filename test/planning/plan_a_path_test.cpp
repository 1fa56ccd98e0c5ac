/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The example that plans a path, run on scans; its paths measured against the points.
 */

#include "clouds.h"
#include "even_sampler.h"
#include "tool_process.h"

#include <pcl_cid/core/convex_part.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <pcl/common/common.h>
#include <pcl/common/point_tests.h>
#include <pcl/io/pcd_io.h>
#include <pcl/kdtree/kdtree_flann.h>

namespace pcl_cid::test {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Path = std::vector<Eigen::Vector3d>;

constexpr double radius = 0.15; // of the example's robot
constexpr const char* room = PCL_CID_DATA_DIR "/room.pcd";

ToolRun
planIn(const std::vector<std::string>& arguments)
{
  const TemporaryFolder folder;
  return ToolProcess("plan_a_path", arguments, folder).wait();
}

/** The sample room again, by hulls that are made quickly: where any hulls do. */
ToolRun
planInRoom(std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), {room, "--merging", "cid"});
  return planIn(arguments);
}

Path
pathIn(const std::string& printed)
{
  Path path;
  std::istringstream stream(printed);
  for (Eigen::Vector3d place; stream >> place.x() >> place.y() >> place.z();)
    path.push_back(place);
  return path;
}

/** Places along a path, a centimetre apart at most. */
Path
densely(const Path& path)
{
  Path places;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d way = path[i] - path[i - 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / 0.01)));
    for (int s = 0; s <= steps; ++s)
      places.push_back(path[i - 1] + way * s / steps);
  }
  return places;
}

Cloud::Ptr
finitePointsOf(const Cloud& cloud)
{
  auto finite = pcl::make_shared<Cloud>();
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isFinite(point))
      finite->push_back(point);
  return finite;
}

double
diagonalOf(const Cloud& cloud)
{
  pcl::PointXYZ low, high;
  pcl::getMinMax3D(cloud, low, high);
  return (high.getVector3fMap() - low.getVector3fMap()).norm();
}

/** Distance from the nearest of these places to a point of the scan. */
double
clearanceOf(const Path& places, const Cloud::ConstPtr& scan)
{
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(scan);
  double clearance = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& place : places) {
    pcl::PointXYZ query;
    query.getVector3fMap() = place.cast<float>();
    pcl::Indices index(1);
    std::vector<float> distance2(1);
    tree.nearestKSearch(query, 1, index, distance2);
    clearance = std::min(clearance, std::sqrt(double{distance2[0]}));
  }
  return clearance;
}

/** Whether a point of the scan lies behind a place, seen from the origin. */
bool
hasAPointBehind(const Eigen::Vector3d& place, const Cloud& scan)
{
  constexpr double wide = 0.02; // radians; the example's own limit is half of it
  return std::any_of(scan.begin(), scan.end(), [&place](const pcl::PointXYZ& p) {
    const Eigen::Vector3d point = p.getVector3fMap().cast<double>();
    return point.norm() > place.norm() &&
           (point.normalized() - place.normalized()).norm() < wide;
  });
}

/** A path that turns, and that never comes nearer to a point than a hull allows. */
void
expectGoodPath(const Path& path, const Cloud::ConstPtr& scan)
{
  ASSERT_GT(path.size(), 2u) << "the straight way is not free, so a path has to turn";
  const double tolerance = hull_tolerance * diagonalOf(*scan);
  EXPECT_GE(clearanceOf(densely(path), scan), radius - tolerance);
}

TEST(PlanAPath, CrossesTheSampleRoom)
{
  const auto scan = pcl::make_shared<Cloud>();
  ASSERT_EQ(pcl::io::loadPCDFile(room, *scan), 0);
  const ToolRun run = planInRoom({});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Path path = pathIn(run.out);
  expectGoodPath(path, scan);
  EXPECT_GT((path.back() - path.front()).norm(), 0.5 * diagonalOf(*scan));
  EXPECT_EQ(planInRoom({}).out, run.out) << "another run, another path";
}

/** An empty room of 2.4 m height with solids in it, scanned evenly. */
class PlanAPathThrough : public testing::Test {
protected:
  void
  makeRoomWith(double width, const std::vector<Primitive>& solids)
  {
    RoomScene scene;
    scene.size = {width, depth, height};
    scene.primitives = {makeBox(0, width, 0, depth, 0, 0),
                        makeBox(0, width, 0, depth, height, height),
                        makeBox(0, 0, 0, depth, 0, height),
                        makeBox(width, width, 0, depth, 0, height),
                        makeBox(0, width, 0, 0, 0, height),
                        makeBox(0, width, depth, depth, 0, height)};
    scene.primitives.insert(scene.primitives.end(), solids.begin(), solids.end());
    scene.class_of_instance = {RoomClass::none}; // of them all
    for (const Eigen::Vector3f& p : sampleRoomEvenly(scene, 3000, 1).points)
      scan_->emplace_back(p.x(), p.y(), p.z());
    ASSERT_EQ(pcl::io::savePCDFileBinary(file_, *scan_), 0);
  }

  /** From the one side to the other. */
  ToolRun
  planBy(const std::string& merging, const std::vector<std::string>& ends)
  {
    std::vector<std::string> arguments{file_, "--merging", merging, "--parts", "20"};
    arguments.insert(arguments.end(), ends.begin(), ends.end());
    return planIn(arguments);
  }

  static constexpr double depth = 3.0;
  static constexpr double height = 2.4;
  TemporaryFolder folder_;
  std::string file_ = folder_.file("scan.pcd");
  Cloud::Ptr scan_ = pcl::make_shared<Cloud>();
};

/** Two rooms joined by a door of 0.9 x 2 m. By CID, the door stays open, too, but
 * places nearer to the walls, to which the same robot has to go, are in the hulls. */
TEST_F(PlanAPathThrough, ADoor)
{
  makeRoomWith(6.0,
               {makeBox(2.95, 3.05, 0.0, 1.05, 0.0, height),
                makeBox(2.95, 3.05, 1.95, depth, 0.0, height),
                makeBox(2.95, 3.05, 1.05, 1.95, 2.0, height)});
  const std::vector<std::string> ends{"0.3", "0.3", "0.3", "5.7", "0.3", "0.3"};
  const ToolRun run = planBy("hull", ends);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expectGoodPath(pathIn(run.out), scan_);
  EXPECT_EQ(planBy("cid", ends).exit_code, 1);
}

/** 0.4 m between a cupboard, as high as the room, and the wall: hardly more than the
 *  0.32 m of the sphere that is checked. By CID, the way through is closed. */
TEST_F(PlanAPathThrough, AGapAtTheWall)
{
  makeRoomWith(5.0, {makeBox(2.1, 2.9, 0.0, depth - 0.4, 0.0, height)});
  const std::vector<std::string> ends{"1", "1", "1.2", "4", "1", "1.2"};
  const ToolRun run = planBy("hull", ends);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expectGoodPath(pathIn(run.out), scan_);
  const ToolRun by_cid = planBy("cid", ends);
  EXPECT_EQ(by_cid.exit_code, 1);
  EXPECT_NE(by_cid.err.find("no path was found"), std::string::npos) << by_cid.err;
}

TEST(PlanAPath, StaysWhereTheCameraSawTheOffice)
{
  const auto loaded = loadSharedScan("office1.pcd");
  if (!loaded)
    GTEST_SKIP() << "../shared/data/office1.pcd is absent";
  const Cloud::ConstPtr scan = finitePointsOf(*loaded);
  const ToolRun run = planIn({sharedFile("data/office1.pcd"), "--one-view"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Path path = pathIn(run.out);
  expectGoodPath(path, scan);
  for (const Eigen::Vector3d& place : densely(path))
    EXPECT_TRUE(hasAPointBehind(place, *scan)) << place.transpose();
}

TEST(PlanAPath, GoesWhereItIsTold)
{
  const Path chosen = pathIn(planInRoom({}).out);
  ASSERT_FALSE(chosen.empty());
  std::vector<std::string> arguments;
  for (const Eigen::Vector3d& end : {chosen.back(), chosen.front()})
    for (const double coordinate : end)
      arguments.push_back(std::to_string(coordinate));
  const Path back = pathIn(planInRoom(arguments).out);
  ASSERT_FALSE(back.empty());
  constexpr double printed_digits = 1e-5;
  EXPECT_LT((back.front() - chosen.back()).norm(), printed_digits);
  EXPECT_LT((back.back() - chosen.front()).norm(), printed_digits);
}

TEST(PlanAPath, RefusesAStartInThePoints)
{
  Cloud scan;
  ASSERT_EQ(pcl::io::loadPCDFile(room, scan), 0);
  const pcl::PointXYZ& p = scan[0];
  const ToolRun run = planInRoom(
      {std::to_string(p.x), std::to_string(p.y), std::to_string(p.z), "1", "1", "1"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("start or goal is not free"), std::string::npos) << run.err;
  EXPECT_TRUE(run.out.empty());
}

TEST(PlanAPath, RefusesABadCommandLine)
{
  EXPECT_EQ(planIn({}).exit_code, 2);
  EXPECT_EQ(planIn({room, "1", "2", "3"}).exit_code, 2);
  EXPECT_EQ(planIn({room, "--sideways"}).exit_code, 2);
  EXPECT_EQ(planIn({room, "--merging", "chance"}).exit_code, 2);
  EXPECT_EQ(planIn({room, "--merging"}).exit_code, 2);
  EXPECT_EQ(planIn({room, "--parts", "many"}).exit_code, 2);
  EXPECT_EQ(planIn({room, "--parts", "0"}).exit_code, 1);
  EXPECT_EQ(planIn({"absent.pcd"}).exit_code, 1);
}

} // namespace
} // namespace pcl_cid::test
