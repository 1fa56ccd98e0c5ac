/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Time of one distance, of one CID, and of both algorithms, on the sample scan.
 */

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/cid_sampler.h>
#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/random.h>

#include <benchmark/benchmark.h>

#include <random>
#include <stdexcept>
#include <vector>

#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_cid {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

const Cloud::Ptr&
sampleScan()
{
  static const Cloud::Ptr scan = [] {
    const auto cloud = pcl::make_shared<Cloud>();
    if (pcl::io::loadPCDFile(PCL_CID_DATA_DIR "/room.pcd", *cloud) != 0)
      throw std::runtime_error("cannot read " PCL_CID_DATA_DIR "/room.pcd");
    return cloud;
  }();
  return scan;
}

/** Points of the sample scan, drawn at random. */
Points
samplePoints(std::size_t count)
{
  std::mt19937_64 generator(0);
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(
        (*sampleScan())[drawBelow(generator, sampleScan()->size())].getVector3fMap());
  return points;
}

void
distance(benchmark::State& state)
{
  const Points points = samplePoints(static_cast<std::size_t>(state.range(0)));
  const DistanceField field(points);
  std::size_t i = 0;
  for (auto _ : state) {
    const Eigen::Vector3f middle = 0.5f * (points[i] + points[i + 1]);
    benchmark::DoNotOptimize(field.distance(middle));
    i = (i + 1) % (points.size() - 1);
  }
}
BENCHMARK(distance)->Arg(20000)->Arg(140000);

/** Eq. 2 with 100 samples for two points at random. */
void
pointCIDOfAPair(benchmark::State& state)
{
  const Points points = samplePoints(static_cast<std::size_t>(state.range(0)));
  const DistanceField field(points);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(pointCID(field, points[i], points[i + 1], 100));
    i = (i + 1) % (points.size() - 1);
  }
}
BENCHMARK(pointCIDOfAPair)->Arg(20000)->Arg(140000);

/** Algorithm 1: 100 seeds and the groups of a working set. */
void
seedProposal(benchmark::State& state)
{
  CIDSampler<pcl::PointXYZ> sampler;
  sampler.setInputCloud(sampleScan());
  sampler.setSubsample(static_cast<int>(state.range(0)));
  pcl::Indices seeds;
  for (auto _ : state)
    sampler.sample(seeds);
}
BENCHMARK(seedProposal)
    ->Arg(5000)
    ->Arg(20000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/** Algorithms 1 and 2 and the hulls of 30 parts. */
void
convexAbstraction(benchmark::State& state)
{
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(sampleScan());
  abstraction.setSubsample(static_cast<int>(state.range(0)));
  abstraction.setNumberOfParts(30);
  std::vector<ConvexPart> parts;
  for (auto _ : state)
    abstraction.reconstruct(parts);
}
BENCHMARK(convexAbstraction)->Arg(5000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace pcl_cid
