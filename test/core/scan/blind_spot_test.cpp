/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The blind spot of a scanner: where there is one, where there is none, what fills it.
 */

#include "clouds.h"
#include "lidar_scan.h"
#include "oracle.h"
#include "prepared_points.h"
#include "scan/blind_spot.h"
#include "scan/local_spacing.h"

#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/exceptions.h>

#include <limits>
#include <memory>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr float height = 1.3f; ///< of LidarOptions

float
tangent(float degrees)
{
  return std::tan(degrees * 0.017453293f);
}

float
nearest(const Points& points, const Eigen::Vector3f& x)
{
  float best = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& p : points)
    best = std::min(best, (p - x).norm());
  return best;
}

/** A cuboid that stands on the floor of the room, as points on its sides and top. */
Points
cuboid(const Eigen::AlignedBox3f& box, float spacing)
{
  Points points;
  const auto places = [&](int axis) {
    return static_cast<int>(box.sizes()[axis] / spacing);
  };
  for (int i = 0; i <= places(0); ++i)
    for (int j = 0; j <= places(1); ++j)
      for (int k = 0; k <= places(2); ++k)
        if (i == 0 || j == 0 || i == places(0) || j == places(1) || k == places(2))
          points.push_back(box.min() +
                           spacing * Eigen::Vector3d(i, j, k).cast<float>());
  return points;
}

Points
joined(Points first, const Points& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(BlindSpot, IsTheDiscThatTheScannerHides)
{
  for (const float blind : {20.0f, 38.0f, 55.0f}) {
    LidarOptions options;
    options.blind = blind;
    const std::optional<BlindSpot> spot = findBlindSpot(lidarScan(options), {}, {});
    ASSERT_TRUE(spot) << blind;
    // The first ray that passes the mount is less than a step farther out.
    EXPECT_GE(spot->radius, 0.98f * height * tangent(blind)) << blind;
    EXPECT_LE(spot->radius, 1.02f * height * tangent(blind + options.step)) << blind;
    EXPECT_NEAR((spot->center - Eigen::Vector3f(0, 0, -height)).norm(), 0.0f, 0.01f);
  }
}

TEST(BlindSpot, IsFilledAllOverWithPointsOfTheFloor)
{
  const Points scan = lidarScan({});
  const std::optional<BlindSpot> spot = findBlindSpot(scan, {}, {});
  ASSERT_TRUE(spot);
  for (const Eigen::Vector3f& p : spot->filling) {
    EXPECT_NEAR(p.z(), -height, 0.02f);
    EXPECT_LE((p - spot->center).norm(), spot->radius * 1.001f);
  }
  // No place of it is farther from the surface than the floor beside it is sparse.
  const Points surface = joined(scan, spot->filling);
  RandomGenerator generator(3);
  for (int probe = 0; probe < 500; ++probe) {
    const auto draw = [&] {
      return static_cast<float>(drawBelow(generator, 2001)) / 1000.0f - 1.0f;
    };
    const Eigen::Vector3f offset(draw(), draw(), 0.0f);
    if (offset.norm() > 1.0f)
      continue;
    EXPECT_LE(nearest(surface, spot->center + spot->radius * offset), 0.06f);
  }
}

/// Tilted floors, sensors that lie on their side, millimetres, other places.
TEST(BlindSpot, MovesWithTheScan)
{
  const Points scan = lidarScan({});
  const std::optional<BlindSpot> plain = findBlindSpot(scan, {}, {});
  ASSERT_TRUE(plain);
  const Eigen::Quaternionf turn(0.5f, -0.5f, 0.1f, 0.7f);
  const Eigen::Vector3f shift(7.0f, -3.0f, 2.0f);
  for (const float scale : {0.001f, 1.0f, 1000.0f})
    for (const float tilt : {0.0f, 5.0f}) {
      const Eigen::Quaternionf tilted(
          Eigen::AngleAxisf(tilt * 0.017453293f, Eigen::Vector3f::UnitX()));
      const auto moved = [&](const Eigen::Vector3f& p) -> Eigen::Vector3f {
        return scale * (turn.normalized() * (tilted * p) + shift);
      };
      Points points;
      for (const Eigen::Vector3f& p : scan)
        points.push_back(moved(p));
      const SensorPose pose{scale * shift,
                            turn.normalized() * -Eigen::Vector3f::UnitZ()};
      const std::optional<BlindSpot> spot = findBlindSpot(points, pose, {});
      ASSERT_TRUE(spot) << scale << " " << tilt;
      EXPECT_NEAR(spot->radius / scale, plain->radius, 0.02f);
      EXPECT_LE((spot->center - moved(plain->center)).norm() / scale, 0.02f);
    }
}

/// Reflections under the floor.
TEST(BlindSpot, IsFoundInASceneWithStrayReturns)
{
  Points scan = lidarScan({});
  RandomGenerator generator(4);
  for (std::size_t k = 0, size = scan.size(); k < size; k += 400) {
    const auto draw = [&](std::uint64_t to) {
      return static_cast<float>(drawBelow(generator, to)) / 1000.0f;
    };
    scan.emplace_back(draw(8000) - 4.0f, draw(8000) - 4.0f, -2.0f - draw(6000));
  }
  const std::optional<BlindSpot> plain = findBlindSpot(lidarScan({}), {}, {});
  const std::optional<BlindSpot> spot = findBlindSpot(scan, {}, {});
  ASSERT_TRUE(plain && spot);
  EXPECT_NEAR(spot->radius, plain->radius, 0.02f);
  EXPECT_NEAR(spot->center.z(), -height, 0.01f);
}

TEST(BlindSpot, IsNoneWhereTheFloorIsSeen)
{
  LidarOptions options;
  options.blind = 0.0f;
  EXPECT_FALSE(findBlindSpot(lidarScan(options), {}, {}));
}

TEST(BlindSpot, IsNoneWhereTheFloorIsNotSeenAllAround)
{
  LidarOptions half;
  half.azimuth_end = 200.0f;
  EXPECT_FALSE(findBlindSpot(lidarScan(half), {}, {}));

  LidarOptions corner;
  corner.room.min() = Eigen::Vector3f(-0.4f, -0.4f, -1.3f);
  EXPECT_FALSE(findBlindSpot(lidarScan(corner), {}, {}));
}

/// Only what nobody saw may be filled: not what lies on a platform or in a pit.
TEST(BlindSpot, IsNoneWhereSomethingWasSeen)
{
  const Points scan = lidarScan({});
  const Points platform =
      cuboid({Eigen::Vector3f(-0.5f, -0.5f, -1.2f), Eigen::Vector3f(0.5f, 0.5f, -1.0f)},
             0.05f);
  EXPECT_FALSE(findBlindSpot(joined(scan, platform), {}, {}));
  const Points pit =
      cuboid({Eigen::Vector3f(-0.5f, -0.5f, -2.3f), Eigen::Vector3f(0.5f, 0.5f, -1.4f)},
             0.05f);
  EXPECT_FALSE(findBlindSpot(joined(scan, pit), {}, {}));
}

/// A box that is sampled evenly, seen from wherever the origin may be.
TEST(BlindSpot, IsNoneInAnEvenScan)
{
  const Points room =
      cuboid({Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(5, 4, 2.5f)}, 0.08f);
  RandomGenerator generator(5);
  ::testing::internal::CaptureStderr();
  for (int k = 0; k < 100; ++k) {
    SensorPose pose;
    for (int axis = 0; axis < 3; ++axis)
      pose.position[axis] =
          static_cast<float>(drawBelow(generator, 7000)) / 1000.0f - 1;
    EXPECT_FALSE(findBlindSpot(room, pose, {})) << pose.position.transpose();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "PCL has no say in it";
}

TEST(BlindSpot, IsNoneInRandomAndDegenerateClouds)
{
  ::testing::internal::CaptureStderr();
  for (const NamedPoints& cloud : allClouds())
    for (const Eigen::Vector3f& position :
         {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(0.5f, 0.5f, 1.5f)})
      EXPECT_FALSE(findBlindSpot(cloud.points, {position}, {})) << cloud.name;
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "PCL has no say in it";
  EXPECT_THROW(findBlindSpot({}, {}, {}), CIDException);
}

TEST(BlindSpot, IsTheSameEachTimeAndCanBeCancelled)
{
  const Points scan = lidarScan({});
  const std::optional<BlindSpot> once = findBlindSpot(scan, {}, {});
  const std::optional<BlindSpot> again = findBlindSpot(scan, {}, {});
  ASSERT_TRUE(once && again);
  EXPECT_EQ(once->filling, again->filling);
  ExecutionOptions cancelled;
  cancelled.progress = [](double) { return false; };
  EXPECT_THROW(findBlindSpot(scan, {}, cancelled), CIDCancelled);
}

/** A scan of a lidar that gets ready. */
class PreparationWithBlindSpot : public ::testing::Test {
protected:
  PreparationWithBlindSpot()
  {
    LidarOptions coarse;
    coarse.step = 6.0f;
    scan_ = rawScan(lidarScan(coarse));
    scan_.sensor = SensorPose();
    settings_.normals = 0.0f; // the oracle has neither
    settings_.connected = false;
  }

  PreparedScan::ConstPtr
  ready(const ExecutionOptions& execution = {}) const
  {
    return std::make_shared<const PreparedScan>(scan_, settings_, execution);
  }

  static SeedProposal
  propose(const PreparedScan::ConstPtr& scan, const ExecutionOptions& execution = {})
  {
    Grouping grouping(scan, {24, SeedingRule::farthest, true});
    grouping.propose(12, 0.0f, execution);
    return grouping.proposal();
  }

  RawScan scan_;
  PreparationSettings settings_;
};

/// The filling is of the surface, and of nothing else: seeds and groups are those that
/// all pairs give on the surface with it.
TEST_F(PreparationWithBlindSpot, ItsSurfaceIsThatOfTheOracle)
{
  const std::optional<BlindSpot> spot = findBlindSpot(scan_.points.points, {}, {});
  ASSERT_TRUE(spot);
  const Points surface = joined(scan_.points.points, spot->filling);
  for (const DensityWeight weight : {DensityWeight::off, DensityWeight::on}) {
    settings_.density = weight;
    const PreparedScan::ConstPtr prepared = ready();
    ASSERT_TRUE(prepared->blindSpot());
    EXPECT_EQ(prepared->blindSpot()->points, spot->filling.size());
    EXPECT_EQ(prepared->working().points(), scan_.points.points);
    EXPECT_EQ(prepared->field().size(), surface.size());

    PairCosts costs;
    if (weight == DensityWeight::on)
      costs.spacing = localSpacing(NearestNeighbors(scan_.points.points, {}),
                                   settings_.density_power);
    SeedProposalOptions options;
    options.seeds = 12;
    options.samples = 24;
    options.costs = weight == DensityWeight::on ? &costs : nullptr;
    options.isolated = prepared->isolated();
    const SeedProposal proposal = propose(prepared);
    expectAgreesWithAlgorithm1(proposal, surface, scan_.points.points, options);
    expectSameProposal(
        proposal,
        proposeByAllPairs(
            prepared->field(), scan_.points.points, proposal.seeds.front(), options));
    for (const unsigned int threads : {1u, 2u, 3u, 8u}) {
      const ExecutionOptions execution{threads, {}};
      expectSameProposal(proposal, propose(ready(execution), execution));
    }
  }
}

/// Points that were not drawn follow one that was, never one of the filling.
TEST_F(PreparationWithBlindSpot, SubsamplesFollowTheirOwnPoints)
{
  settings_.subsample = 300;
  const PreparedScan::ConstPtr prepared = ready();
  ASSERT_TRUE(prepared->blindSpot());
  const Points& working = prepared->working().points();
  Grouping grouping(prepared, {24, SeedingRule::farthest, false});
  grouping.propose(12);
  const std::vector<pcl::index_t> group = grouping.groupsOfWorkingPoints();
  const std::vector<pcl::index_t> carried = grouping.groups();
  for (std::size_t i = 0; i < scan_.points.size(); ++i) {
    const Eigen::Vector3f& p = scan_.points.points[i];
    float near = std::numeric_limits<float>::infinity();
    pcl::index_t expected = -1;
    for (std::size_t k = 0; k < working.size(); ++k)
      if ((working[k] - p).norm() < near) {
        near = (working[k] - p).norm();
        expected = group[k];
      }
    EXPECT_EQ(carried[i], expected) << i;
  }
}

TEST_F(PreparationWithBlindSpot, IsWithoutItWhereThatIsWanted)
{
  settings_.blind_spot = false;
  EXPECT_FALSE(ready()->blindSpot());
  settings_.blind_spot = true;
  EXPECT_TRUE(ready()->blindSpot());
  scan_.sensor.reset();
  EXPECT_FALSE(ready()->blindSpot());
  scan_.sensor = SensorPose();
  scan_.surface = scan_.points.points;
  EXPECT_FALSE(ready()->blindSpot());
}

} // namespace
} // namespace pcl_cid::test
