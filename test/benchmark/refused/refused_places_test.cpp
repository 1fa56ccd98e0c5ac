/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Free places of a room whose boxes are known, and hulls whose figures are.
 */

#include "refused_places.h"

#include "hull/hull_samples.h"
#include "hulls.h"
#include "portable_draw.h"
#include "refusal_table.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::benchmarks {
namespace {

using Box = Eigen::AlignedBox3d;
using Vector = Eigen::Vector3d;

const Box room(Vector(0, 0, 0), Vector(4, 3, 2.5));
const Box cupboard(Vector(1.6, 1, 0), Vector(2.2, 1.7, 1.4));
const Vector eye(0.7, 0.8, 1.6);

/** Whether a segment meets a box: the shares of it between the box's planes overlap. */
bool
crosses(const Box& box, const Vector& from, const Vector& to)
{
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double way = to[axis] - from[axis];
    const double low = (box.min()[axis] - from[axis]) / way;
    const double high = (box.max()[axis] - from[axis]) / way;
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  return enter <= leave;
}

/** Whether the cupboard does not hide a place from the eye. */
bool
isVisible(const Vector& x)
{
  return !crosses(cupboard, eye, eye + 0.9999 * (x - eye));
}

/** Points on the sides of a box that the eye sees. */
void
addSides(const Box& box, Points& points)
{
  constexpr double step = 0.025;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    Vector x = side % 2 == 0 ? box.min() : box.max();
    for (x[u] = box.min()[u] + step / 2; x[u] < box.max()[u]; x[u] += step)
      for (x[v] = box.min()[v] + step / 2; x[v] < box.max()[v]; x[v] += step)
        if (isVisible(x))
          points.push_back(x.cast<float>());
  }
}

Points
scanOfRoom()
{
  Points points;
  addSides(room, points);
  addSides(cupboard, points);
  return points;
}

Vector
drawIn(const Box& box, RandomGenerator& generator)
{
  Vector x;
  for (int axis = 0; axis < 3; ++axis)
    x[axis] = test::drawWithin(generator, {box.min()[axis], box.max()[axis]});
  return x;
}

/** The corners of a box, as a part. */
ConvexPart
hullOfBox(const Box& box)
{
  Points corners;
  for (int corner = 0; corner < 8; ++corner)
    corners.push_back(box.corner(static_cast<Box::CornerType>(corner)).cast<float>());
  return test::partOf(corners);
}

PlaceOptions
somePlaces(std::size_t places, double radius)
{
  PlaceOptions options;
  options.places = places;
  options.robot_radius = radius;
  return options;
}

TEST(VoxelGrid, VisitsTheCubesThatASegmentCrosses)
{
  const VoxelGrid grid(Box(Vector(-1, 2, 0), Vector(0.1, 2.9, 1.3)), 0.2);
  ASSERT_EQ(grid.size(), 6 * 5 * 7);
  RandomGenerator generator;
  for (int round = 0; round < 300; ++round) {
    const Box around(Vector(-1.5, 1.5, -0.5), Vector(0.6, 3.4, 1.8));
    const Vector from = drawIn(around, generator);
    const Vector to = drawIn(around, generator);
    std::vector<char> is_visited(static_cast<std::size_t>(grid.size()));
    grid.forEachOn(from, to, [&](std::size_t voxel) { is_visited[voxel] = true; });
    for (std::size_t voxel = 0; voxel < is_visited.size(); ++voxel) {
      const Vector half = Vector::Constant(0.1);
      const Vector center = grid.centerOf(voxel);
      EXPECT_EQ(grid.indexOf(center), voxel);
      EXPECT_EQ(is_visited[voxel] != 0,
                crosses(Box(center - half, center + half), from, to));
    }
  }
}

TEST(SeenSpace, IsWhatTheEyeSees)
{
  const Points scan = scanOfRoom();
  const SeenSpace space(scan, {eye}, SightOptions());
  RandomGenerator generator;
  std::size_t seen = 0;
  std::size_t hidden = 0;
  const Box inside(room.min().array() + 0.2, room.max().array() - 0.2);
  for (int round = 0; round < 5000; ++round) {
    const Vector x = drawIn(inside, generator);
    if (cupboard.exteriorDistance(x) < 0.2)
      continue;
    // The shadow of a box is convex: where it has all corners of a voxel, it has it
    // all.
    const Vector center = space.grid().centerOf(space.grid().indexOf(x));
    const Vector half = Vector::Constant(space.grid().voxel() / 2);
    const Box voxel(center - half, center + half);
    int visible = 0;
    for (int corner = 0; corner < 8; ++corner)
      visible += isVisible(voxel.corner(static_cast<Box::CornerType>(corner))) ? 1 : 0;
    if (visible != 0 && visible != 8)
      continue;
    (visible == 8 ? seen : hidden) += 1;
    EXPECT_EQ(space.isFree(x), visible == 8) << x.transpose();
  }
  EXPECT_GT(seen, 2000u);
  EXPECT_GT(hidden, 200u);
  EXPECT_FALSE(space.isFree(Vector(-1, 1, 1)));
  EXPECT_FALSE(space.isFree(cupboard.center()));
}

TEST(SeenSpace, WithoutViewpointsIsAllWithoutPoints)
{
  const Points scan{{0, 0, 0}, {1, 1, 1}, {0.5f, 0.5f, 0.5f}};
  SightOptions options;
  options.voxel = 0.25;
  const SeenSpace space(scan, {}, options);
  EXPECT_EQ(space.size(), 125u);
  EXPECT_DOUBLE_EQ(space.freeVolume(), (125 - 3) / 64.0);
  EXPECT_FALSE(space.isFree(Vector(0.6, 0.6, 0.6)));
  options.voxel = 1e-4;
  EXPECT_THROW(SeenSpace(scan, {}, options), CIDException);
}

TEST(SeenSpace, IsNotSeenThroughWhatIsNearer)
{
  // In one cell of directions: the nearest, one within 5 % and 5 cm, one beyond; then
  // one straight up.
  const Points scan{
      {2, 0.01f, 0.01f}, {2.14f, 0.01f, 0.01f}, {2.16f, 0.01f, 0.01f}, {0, 0, 1}};
  const Vector origin(0, 0, 0);
  SightOptions options;
  EXPECT_EQ(seenFrom(origin, scan, false, options), (std::vector<char>{1, 1, 0, 1}));
  EXPECT_EQ(seenFrom(origin, scan, true, options), (std::vector<char>{1, 1, 1, 1}));
  options.max_elevation_sine = 0.5;
  EXPECT_EQ(seenFrom(origin, scan, true, options), (std::vector<char>{1, 1, 1, 0}));
}

TEST(ConvexBody, IsAsFarAsTheBoxThatItIs)
{
  const ConvexPart part = hullOfBox(cupboard);
  const ConvexBody body(part.hull);
  const Box around(cupboard.min().array() - 0.5, cupboard.max().array() + 0.5);
  Box box; // as float has it
  for (const Vector& v : part.hull.vertices)
    box.extend(v);
  RandomGenerator generator;
  for (int round = 0; round < 3000; ++round) {
    Vector x = drawIn(around, generator);
    if (round % 3 == 0) // on a plane of a side
      x[round % 9 / 3] = box.max()[round % 9 / 3];
    const double distance = box.exteriorDistance(x);
    EXPECT_NEAR(body.distanceUpTo(10.0, x), distance, 1e-6) << x.transpose();
    EXPECT_NEAR(body.distanceUpTo(0.2, x), std::min(distance, 0.2), 1e-6);
  }
}

TEST(ConvexBody, IsAsFarAsTheNearestOfManySamples)
{
  const ConvexPart part = test::partOf(test::randomCube(60, 3));
  const ConvexBody body(part.hull);
  constexpr std::size_t count = 20000;
  const std::vector<Vector> samples = surfaceSamples(part.hull, count);
  const double gap = 3.0 * std::sqrt(part.area / count);
  RandomGenerator generator;
  for (int round = 0; round < 200; ++round) {
    const Vector x = drawIn(Box(Vector(-1, -1, -1), Vector(2, 2, 2)), generator);
    double nearest = 10.0;
    for (const Vector& sample : samples)
      nearest = std::min(nearest, (sample - x).norm());
    const double distance = body.distanceUpTo(10.0, x);
    EXPECT_EQ(distance == 0.0, test::excess(part.hull, x) <= 0.0);
    EXPECT_EQ(distance == 0.0, body.contains(x));
    if (distance > 0.0) {
      EXPECT_LE(distance, nearest + 1e-12);
      EXPECT_GE(distance, nearest - gap);
    }
  }
}

TEST(RefusedPlaces, AreAllWithinTheRadiusOfAHullThatFillsHalfTheRoom)
{
  const Points scan = scanOfRoom();
  const double radius = 0.15;
  const RefusedPlaces places(test::pointSet(scan), {eye}, somePlaces(3000, radius));
  ASSERT_EQ(places.places().size(), 3000u);
  std::size_t near = 0;
  for (const Eigen::Vector3f& x : places.places()) {
    EXPECT_TRUE(places.space().isFree(x.cast<double>()));
    float nearest = 10.0f;
    for (const Eigen::Vector3f& p : scan)
      nearest = std::min(nearest, (p - x).squaredNorm());
    EXPECT_GE(std::sqrt(nearest), 0.1499f);
    near += x.x() < 2.0 + radius ? 1 : 0;
  }
  const ConvexPart half = hullOfBox(Box(room.min(), Vector(2, 3, 2.5)));
  const RefusalFigures figures = places.measure({half});
  EXPECT_NEAR(figures.refused, static_cast<double>(near) / 3000.0, 0.002);
  EXPECT_NEAR(figures.refused, 0.5, 0.15);
  EXPECT_EQ(places.measure({hullOfBox(room)}).refused, 1.0);
  EXPECT_EQ(places.measure({hullOfBox(Box(Vector(5, 5, 5), Vector(6, 6, 6)))}).refused,
            0.0);
}

TEST(RefusedPlaces, CountThePointsThatHullsMiss)
{
  Points scan(5, Eigen::Vector3f(0.5f, 0.5f, 0.9f));
  for (const auto& [count, height] : {std::pair(4, 0.0005f),
                                      std::pair(3, 0.002f),
                                      std::pair(2, 0.02f),
                                      std::pair(1, 0.05f)})
    scan.insert(
        scan.end(), static_cast<std::size_t>(count), {0.3f, 0.6f, 1.0f + height});
  scan.emplace_back(0.0f, 0.0f, 0.0f);
  scan.emplace_back(1.0f, 1.0f, 1.0f);
  const RefusedPlaces places(test::pointSet(scan), {}, somePlaces(10, 0.05));
  const RefusalFigures figures =
      places.measure({hullOfBox(Box(Vector(0, 0, 0), Vector(1, 1, 1)))});
  EXPECT_EQ(figures.missed, (std::array<std::size_t, 3>{6, 3, 1}));
}

TEST(RefusedPlaces, MeasureVolumesOfTheUnion)
{
  const Points scan{{0, 0, 0}, {2, 2, 2}};
  const RefusedPlaces places(test::pointSet(scan), {}, somePlaces(10, 0.1));
  const Box first(Vector(0, 0, 0), Vector(1, 1, 1));
  const Box second(Vector(0.5, 0, 0), Vector(1.5, 1, 1));
  const RefusalFigures figures = places.measure({hullOfBox(first), hullOfBox(second)});
  EXPECT_EQ(figures.hulls, 2u);
  EXPECT_NEAR(figures.volume_sum, 2.0, 1e-4);
  EXPECT_NEAR(figures.union_volume, 1.5, 0.005);
  EXPECT_NEAR(figures.free_volume, 1.5, 0.005); // but the voxel of a point, 0.000125
  // Far from both points; centers of voxels are at 0.025, 0.075, and so on.
  double deepest = 0.0;
  for (double x = 0.025; x < 1.5; x += 0.05)
    for (double y = 0.025; y < 1.0; y += 0.05)
      for (double z = 0.025; z < 1.0; z += 0.05)
        deepest = std::max(
            deepest,
            std::min(Vector(x, y, z).norm(), Vector(2 - x, 2 - y, 2 - z).norm()));
  EXPECT_NEAR(figures.deepest, deepest, 1e-5);
}

TEST(RefusedPlaces, AreTheSameForEveryNumberOfThreads)
{
  std::vector<MeasuredHulls> rows;
  for (const unsigned threads : {1u, 4u}) {
    PlaceOptions options = somePlaces(500, 0.15);
    options.sight.threads = threads;
    const RefusedPlaces places(
        test::pointSet(scanOfRoom()), {eye, Vector(3.5, 2.5, 1)}, options);
    MeasuredHulls row;
    row.figures = places.measure(
        {hullOfBox(cupboard), hullOfBox(Box(cupboard.center(), Vector(3, 2, 2)))});
    rows.push_back(row);
  }
  EXPECT_EQ(toCsv({rows[0]}), toCsv({rows[1]}));
}

TEST(RefusedPlaces, AreRefusedWhereThereIsNoRoom)
{
  const Points scan{{0, 0, 0}, {0.1f, 0.1f, 0.1f}};
  EXPECT_THROW(RefusedPlaces(test::pointSet(scan), {}, somePlaces(10, 1.0)),
               CIDException);
  EXPECT_THROW(RefusedPlaces(PointSet(), {}, somePlaces(10, 1.0)), CIDException);
}

TEST(RefusalTable, IsAlignedForPeopleAndExactForPrograms)
{
  MeasuredHulls row;
  row.file = "a,\"b\".obj";
  row.vertices = 8;
  row.figures.hulls = 1;
  row.figures.refused = 0.125;
  row.figures.missed = {30, 20, 10};
  row.figures.volume_sum = 1.25;
  row.seconds = 0.5;
  EXPECT_EQ(toText({row}),
            "file       hulls  vertices  refused %  > 1 mm  > 1 cm  > 3 cm  sum m3  "
            "union m3  free m3  deepest m    s\n"
            "a,\"b\".obj      1         8      12.50      30      20      10   1.250  "
            "   0.000    0.000      0.000  0.5\n");
  const std::string csv = toCsv({row});
  EXPECT_EQ(csv.substr(csv.find('\n') + 1),
            "\"a,\"\"b\"\".obj\",1,8,12.5,30,20,10,1.25,0,0,0,0.5\n");
}

} // namespace
} // namespace pcl_cid::benchmarks
