/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Times of the single steps on generated rooms.
 */

#include "benchmark_cloud.h"

#include "base/random.h"
#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/cloud_points.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace pcl_cid::benchmarks {
namespace {

constexpr int samples = 100;       // M
constexpr std::size_t seeds = 100; // K
constexpr std::size_t queries = 1 << 14;

PreparedScan::ConstPtr
prepareAsPaper(RawScan scan)
{
  PreparationSettings settings;
  settings.setPaperSettings();
  return std::make_shared<const PreparedScan>(std::move(scan), settings);
}

GroupingSettings
withCIDs(bool keep_cid)
{
  GroupingSettings settings;
  settings.samples = samples;
  settings.keep_cid = keep_cid;
  return settings;
}

/** A room, and what its steps hand on to each other; each made once, when asked for. */
class Room {
public:
  Room(RoomScan scan, std::size_t points)
  : points_(finitePoints(*makeRoomCloud(scan, points)))
  , scan_(prepareAsPaper({points_, points_.size(), {}, {}, {}}))
  {
  }

  const PointSet&
  pointSet() const
  {
    return points_;
  }

  const Points&
  points() const
  {
    return points_.points;
  }

  const PreparedScan::ConstPtr&
  scan() const
  {
    return scan_;
  }

  const DistanceField&
  field() const
  {
    return scan_->field();
  }

  const Grouping&
  grouping()
  {
    if (!grouping_) {
      grouping_ = std::make_unique<Grouping>(scan_, withCIDs(true));
      grouping_->propose(seeds);
    }
    return *grouping_;
  }

  const MergeTree&
  mergeTree()
  {
    if (merge_tree_.numberOfGroups() == 0)
      merge_tree_ = mergeGroups(grouping());
    return merge_tree_;
  }

private:
  PointSet points_;
  PreparedScan::ConstPtr scan_;
  std::unique_ptr<Grouping> grouping_;
  MergeTree merge_tree_;
};

/** The room that the arguments of a benchmark name. */
Room&
roomOf(benchmark::State& state)
{
  static std::map<std::pair<std::int64_t, std::int64_t>, std::unique_ptr<Room>> rooms;
  const auto scan = static_cast<RoomScan>(state.range(0));
  state.SetLabel(scan == RoomScan::even ? "even" : "sensor");
  std::unique_ptr<Room>& room = rooms[{state.range(0), state.range(1)}];
  if (!room)
    room = std::make_unique<Room>(scan, static_cast<std::size_t>(state.range(1)));
  return *room;
}

/** A segment from a point to a seed. */
struct Query {
  std::size_t point;
  Eigen::Vector3f p;
  Eigen::Vector3f q;
};

/** Random pairs of a point and a seed: what Algorithm 1 looks at. */
std::vector<Query>
drawSegments(Room& room)
{
  RandomGenerator generator(0);
  const pcl::Indices& seeds = room.grouping().seeds();
  std::vector<Query> segments;
  for (std::size_t i = 0; i < queries; ++i) {
    const std::size_t point = drawBelow(generator, room.points().size());
    const auto seed =
        static_cast<std::size_t>(seeds[drawBelow(generator, seeds.size())]);
    segments.push_back({point, room.points()[point], room.points()[seed]});
  }
  return segments;
}

/** Random samples of such segments: where distances are asked for. */
Points
drawSamples(Room& room)
{
  RandomGenerator generator(1);
  Points positions;
  for (const Query& segment : drawSegments(room))
    positions.push_back(segmentSample(segment.p,
                                      segment.q,
                                      static_cast<int>(drawBelow(generator, samples)),
                                      samples));
  return positions;
}

/** Time \a ask for one query after the other. */
template <typename Item, typename Ask>
void
timeEach(benchmark::State& state, const std::vector<Item>& all, const Ask& ask)
{
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ask(all[i]));
    i = (i + 1) % all.size();
  }
}

void
fieldBuild(benchmark::State& state)
{
  const Points& points = roomOf(state).points();
  for (auto _ : state)
    DistanceField field(points);
}

void
fieldDistance(benchmark::State& state)
{
  Room& room = roomOf(state);
  const DistanceField& field = room.field();
  timeEach(state, drawSamples(room), [&](const Eigen::Vector3f& x) {
    return field.distance(x);
  });
}

void
fieldBounds(benchmark::State& state)
{
  Room& room = roomOf(state);
  const DistanceField& field = room.field();
  timeEach(state, drawSamples(room), [&](const Eigen::Vector3f& x) {
    return field.bounds(x);
  });
}

void
pointCIDExact(benchmark::State& state)
{
  Room& room = roomOf(state);
  const DistanceField& field = room.field();
  timeEach(state, drawSegments(room), [&](const Query& segment) {
    return pointCID(field, segment.p, segment.q, samples);
  });
}

/** A seed that competes with the one that the point has. */
void
pointCIDWithLimit(benchmark::State& state)
{
  Room& room = roomOf(state);
  const DistanceField& field = room.field();
  const std::vector<float> cid = room.grouping().cids();
  timeEach(state, drawSegments(room), [&](const Query& segment) {
    return pointCID(field, segment.p, segment.q, samples, cid[segment.point]);
  });
}

void
seedProposal(benchmark::State& state)
{
  const Room& room = roomOf(state);
  for (auto _ : state) {
    Grouping grouping(room.scan(), withCIDs(false));
    benchmark::DoNotOptimize(grouping.propose(seeds));
  }
}

void
seedProposalWithCIDs(benchmark::State& state)
{
  const Room& room = roomOf(state);
  for (auto _ : state) {
    Grouping grouping(room.scan(), withCIDs(true));
    benchmark::DoNotOptimize(grouping.propose(seeds));
  }
}

void
groupMerging(benchmark::State& state)
{
  Room& room = roomOf(state);
  const Grouping& grouping = room.grouping();
  for (auto _ : state)
    benchmark::DoNotOptimize(mergeGroups(grouping));
}

/** The hulls of 30 parts. */
void
convexHulls(benchmark::State& state)
{
  Room& room = roomOf(state);
  const std::vector<int> part_of_group = room.mergeTree().cutAtParts(30);
  std::vector<int> part;
  for (const pcl::index_t group : room.grouping().groups())
    part.push_back(part_of_group[static_cast<std::size_t>(group)]);
  for (auto _ : state)
    benchmark::DoNotOptimize(makeConvexParts(
        room.pointSet(), part, ConvexPartOptions(), ExecutionOptions()));
}

/** A room in a file, and back: x, y, z. */
void
readFile(benchmark::State& state, const char* extension, CloudEncoding encoding)
{
  Room& room = roomOf(state);
  pcl::PointCloud<pcl::PointXYZ> points;
  for (const Eigen::Vector3f& p : room.points())
    points.emplace_back(p.x(), p.y(), p.z());
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("pcl_cid_benchmark_" + std::to_string(getpid()) + extension);
  std::ofstream stream(path, std::ios::binary);
  CloudLayout layout = layoutFor(path.string(), {});
  layout.encoding = encoding;
  writeCloud(stream, toLabelledCloud(points), layout);
  stream.close();
  for (auto _ : state)
    benchmark::DoNotOptimize(pointsOf(readCloud(path.string())));
  std::filesystem::remove(path);
}

void
readAsciiPCD(benchmark::State& state)
{
  readFile(state, ".pcd", CloudEncoding::ascii);
}

void
readBinaryPCD(benchmark::State& state)
{
  readFile(state, ".pcd", CloudEncoding::binary);
}

void
readAsciiPLY(benchmark::State& state)
{
  readFile(state, ".ply", CloudEncoding::ascii);
}

void
readBinaryPLY(benchmark::State& state)
{
  readFile(state, ".ply", CloudEncoding::binary);
}

void
queryRooms(benchmark::internal::Benchmark* kernel)
{
  kernel->ArgsProduct({{0, 1}, {20000, 200000}})->Unit(benchmark::kNanosecond);
}

void
stepRooms(benchmark::internal::Benchmark* kernel)
{
  kernel->ArgsProduct({{0, 1}, {20000, 200000}})
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

BENCHMARK(fieldBuild)->Apply(stepRooms);
BENCHMARK(fieldDistance)->Apply(queryRooms);
BENCHMARK(fieldBounds)->Apply(queryRooms);
BENCHMARK(pointCIDExact)->Apply(queryRooms);
BENCHMARK(pointCIDWithLimit)->Apply(queryRooms);
BENCHMARK(seedProposal)->Apply(stepRooms);
BENCHMARK(seedProposalWithCIDs)->Apply(stepRooms);
BENCHMARK(groupMerging)->Apply(stepRooms);
BENCHMARK(convexHulls)->Apply(stepRooms);
BENCHMARK(readAsciiPCD)->Apply(stepRooms);
BENCHMARK(readBinaryPCD)->Apply(stepRooms);
BENCHMARK(readAsciiPLY)->Apply(stepRooms);
BENCHMARK(readBinaryPLY)->Apply(stepRooms);

} // namespace
} // namespace pcl_cid::benchmarks
