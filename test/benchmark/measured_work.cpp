/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The kinds of work that are measured.
 */

#include "measured_work.h"

#include "busy_processes.h"
#include "literal_method.h"

#include "base/parallel_for.h"
#include "base/random.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/cid_sampler.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/cloud_points.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <pcl/common/common.h>
#include <pcl/io/auto_io.h>

#include <unistd.h>

namespace pcl_cid::benchmarks {
namespace {

constexpr int extended_by = 10;
constexpr std::size_t parts_of_cut = 30;
constexpr int hulls_made = 60;
constexpr std::size_t checked_points = 50;
/** The literal method would go through the points in their order, for which the caches
 *  of the processor thank it: the pairs are drawn in runs of neighbors. */
constexpr std::size_t literal_run = 16;
/** Runs between two looks at the clock. */
constexpr std::size_t literal_batch = 32;

class Stopwatch {
public:
  double
  seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - begun_).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begun_ = Clock::now();
};

void
configure(const Work& work, CIDParameters& parameters)
{
  parameters.setNumberOfSeeds(work.seeds);
  parameters.setNumberOfSamples(work.samples);
  parameters.setNumberOfThreads(work.threads);
}

/** As in the paper, which is what the literal method does. */
void
configureAsPaper(const Work& work, CIDParameters& parameters)
{
  configure(work, parameters);
  parameters.setPaperSettings();
}

/** A scan made ready with the settings of the paper. */
PreparedScan::ConstPtr
prepareAsPaper(const Work& work, const Cloud::ConstPtr& cloud)
{
  CIDSampler<pcl::PointXYZ> sampler;
  sampler.setInputCloud(cloud);
  configureAsPaper(work, sampler);
  return sampler.prepare();
}

Grouping
emptyGrouping(const Work& work, const Cloud::ConstPtr& cloud)
{
  GroupingSettings settings;
  settings.samples = work.samples;
  return Grouping(prepareAsPaper(work, cloud), settings);
}

using Configure = void (*)(const Work&, CIDParameters&);

template <Configure configureFor>
Measurement
segment(const Work& work, const Cloud::ConstPtr& cloud)
{
  const Stopwatch watch;
  CIDLabelPropagation<pcl::PointXYZ> propagation;
  propagation.setInputCloud(cloud);
  configureFor(work, propagation);
  std::vector<std::uint32_t> labels;
  propagation.segment(labels);
  Measurement result;
  result.seconds = watch.seconds();
  result.seeds = propagation.getProposal().seeds;
  return result;
}

Measurement
sample(const Work& work, const Cloud::ConstPtr& cloud)
{
  const Stopwatch watch;
  CIDSampler<pcl::PointXYZ> sampler;
  sampler.setInputCloud(cloud);
  configureAsPaper(work, sampler);
  Measurement result;
  sampler.sample(result.seeds);
  result.seconds = watch.seconds();
  return result;
}

Measurement
extend(const Work& work, const Cloud::ConstPtr& cloud)
{
  if (work.seeds <= extended_by)
    throw std::invalid_argument("`extend` needs more than 10 seeds");
  CIDSampler<pcl::PointXYZ> sampler;
  sampler.setInputCloud(cloud);
  configureAsPaper(work, sampler);
  sampler.setNumberOfSeeds(work.seeds - extended_by);
  Measurement result;
  sampler.sample(result.seeds);
  const Stopwatch watch;
  sampler.extend(work.seeds, result.seeds);
  result.seconds = watch.seconds();
  return result;
}

Measurement
seeds(const Work& work, const Cloud::ConstPtr& cloud)
{
  Grouping grouping = emptyGrouping(work, cloud);
  Measurement result;
  const Stopwatch watch;
  grouping.propose(static_cast<std::size_t>(work.seeds), 0.0f, {work.threads, {}});
  result.seconds = watch.seconds();
  return result;
}

Measurement
mergeTo(std::size_t parts, const Work& work, const Cloud::ConstPtr& cloud)
{
  Grouping grouping = emptyGrouping(work, cloud);
  grouping.propose(static_cast<std::size_t>(work.seeds), 0.0f, {work.threads, {}});
  MergingSettings settings;
  settings.stop_at_parts = parts;
  Measurement result;
  const Stopwatch watch;
  mergeGroups(grouping, settings, {work.threads, {}});
  result.seconds = watch.seconds();
  return result;
}

Measurement
merge(const Work& work, const Cloud::ConstPtr& cloud)
{
  return mergeTo(1, work, cloud);
}

Measurement
cut(const Work& work, const Cloud::ConstPtr& cloud)
{
  return mergeTo(parts_of_cut, work, cloud);
}

struct Pair {
  pcl::index_t point;
  pcl::index_t seed;
};

/** The literal CIDs of pairs, on several threads. */
std::vector<float>
literalCIDs(const LiteralMethod& method,
            const Cloud& cloud,
            const std::vector<Pair>& pairs,
            unsigned int threads)
{
  std::vector<float> cids(pairs.size());
  Progress progress{ProgressCallback()};
  const auto body = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cids[i] = method.pointCID(cloud[static_cast<std::size_t>(pairs[i].point)],
                                cloud[static_cast<std::size_t>(pairs[i].seed)]);
  };
  parallelFor(
      pairs.size(), literal_run, threadCount(threads), progress, {0.0, 1.0}, body);
  return cids;
}

/** Runs of consecutive points, each with one seed; all of them drawn. */
std::vector<Pair>
drawPairs(const pcl::Indices& points,
          const pcl::Indices& given_seeds,
          RandomGenerator& generator)
{
  const std::size_t run = std::min(literal_run, points.size());
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < literal_batch; ++i) {
    const std::size_t begin = drawBelow(generator, points.size() - run + 1);
    const pcl::index_t seed = given_seeds[drawBelow(generator, given_seeds.size())];
    for (std::size_t k = begin; k < begin + run; ++k)
      pairs.push_back({points[k], seed});
  }
  return pairs;
}

Measurement
literal(const Work& work, const Cloud::ConstPtr& cloud)
{
  const pcl::Indices points = finitePoints(*cloud).source;
  const double all_pairs =
      static_cast<double>(points.size()) * static_cast<double>(work.given_seeds.size());
  RandomGenerator generator(0);

  const Stopwatch tree_watch;
  const LiteralMethod method(cloud, work.samples);
  const double tree_seconds = tree_watch.seconds();

  double done = 0.0;
  double pair_seconds = 0.0;
  while (pair_seconds < work.literal_seconds && done < all_pairs) {
    const std::vector<Pair> pairs = drawPairs(points, work.given_seeds, generator);
    const Stopwatch watch;
    literalCIDs(method, *cloud, pairs, work.threads);
    pair_seconds += watch.seconds();
    done += static_cast<double>(pairs.size());
  }
  Measurement result;
  result.share = std::min(done / all_pairs, 1.0);
  result.seconds = tree_seconds + pair_seconds * (all_pairs / done);
  return result;
}

/** The literal CIDs of one point to all seeds: is the seed of its group the nearest?
 *  Rounding differs between the two, hence the tolerance. */
bool
isNearest(pcl::index_t group, const std::vector<float>& cids, float tolerance)
{
  const float nearest = *std::min_element(cids.begin(), cids.end());
  return group >= 0 && cids[static_cast<std::size_t>(group)] <= nearest + tolerance;
}

Measurement
check(const Work& work, const Cloud::ConstPtr& cloud)
{
  const Stopwatch watch;
  CIDLabelPropagation<pcl::PointXYZ> propagation;
  propagation.setInputCloud(cloud);
  configureAsPaper(work, propagation);
  std::vector<std::uint32_t> labels;
  propagation.segment(labels);
  const SeedProposal& ours = propagation.getProposal();

  const pcl::Indices points = finitePoints(*cloud).source;
  const LiteralMethod method(cloud, work.samples);
  pcl::PointXYZ low;
  pcl::PointXYZ high;
  pcl::getMinMax3D(*cloud, low, high);
  const float diagonal = (high.getVector3fMap() - low.getVector3fMap()).norm();
  RandomGenerator generator(0);
  for (std::size_t i = 0; i < checked_points; ++i) {
    const pcl::index_t point = points[drawBelow(generator, points.size())];
    std::vector<Pair> pairs;
    for (const pcl::index_t seed : ours.seeds)
      pairs.push_back({point, seed});
    const std::vector<float> cids = literalCIDs(method, *cloud, pairs, work.threads);
    if (!isNearest(ours.group[static_cast<std::size_t>(point)], cids, 1e-5f * diagonal))
      throw std::runtime_error("the literal method puts point " +
                               std::to_string(point) + " into another group");
  }
  Measurement result;
  result.seconds = watch.seconds();
  result.share = std::min(
      1.0, static_cast<double>(checked_points) / static_cast<double>(points.size()));
  return result;
}

/** What sample() worked out serves the other two. */
Measurement
handle(const Work& work, const Cloud::ConstPtr& cloud)
{
  CIDSampler<pcl::PointXYZ> sampler;
  sampler.setInputCloud(cloud);
  configureAsPaper(work, sampler);
  Measurement result;
  sampler.sample(result.seeds);
  const Stopwatch watch;
  CIDLabelPropagation<pcl::PointXYZ> propagation;
  propagation.setGrouping(sampler.getGrouping());
  propagation.setNumberOfThreads(work.threads);
  std::vector<std::uint32_t> labels;
  propagation.segment(labels);
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setGrouping(sampler.getGrouping());
  abstraction.setNumberOfThreads(work.threads);
  abstraction.setNumberOfParts(static_cast<int>(parts_of_cut));
  abstraction.setStopAtCut(true);
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  result.seconds = watch.seconds();
  return result;
}

template <MergingRule rule>
Measurement
hulls(const Work& work, const Cloud::ConstPtr& cloud)
{
  const Stopwatch watch;
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(cloud);
  configure(work, abstraction);
  abstraction.setMergingRule(rule);
  abstraction.setNumberOfParts(hulls_made);
  abstraction.setStopAtCut(true);
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  Measurement result;
  result.seconds = watch.seconds();
  return result;
}

constexpr std::size_t corrections = 100;

/** The value that a share of all values is below. */
double
quantileOf(std::vector<double> values, double share)
{
  const auto rank =
      static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

double
medianOf(const std::vector<double>& values)
{
  return quantileOf(values, 0.5);
}

/** A grouping as an annotator has it, and points at random to correct it with. */
struct Corrected {
  Corrected(const Work& work, const Cloud::ConstPtr& cloud)
  : Corrected(work,
              Grouping(prepareAsPaper(work, cloud),
                       {work.samples, SeedingRule::farthest, true}))
  {
  }

  Corrected(const Work& work, Grouping empty)
  : grouping(std::move(empty)), execution{work.threads, {}}
  {
    grouping.propose(static_cast<std::size_t>(work.seeds), 0.0f, execution);
    const pcl::Indices& points = grouping.scan().points().source;
    RandomGenerator generator(1); // not 0, whose first point is the start
    while (clicks.size() < corrections)
      clicks.push_back(points[drawBelow(generator, points.size())]);
  }

  Grouping grouping;
  ExecutionOptions execution;
  pcl::Indices clicks;
};

/** The median of 100, each on the same grouping. */
Measurement
addOneSeed(const Work& work, const Cloud::ConstPtr& cloud)
{
  Corrected corrected(work, cloud);
  Grouping& grouping = corrected.grouping;
  std::vector<double> seconds;
  for (const pcl::index_t click : corrected.clicks) {
    const Stopwatch watch;
    grouping.addSeeds({click}, corrected.execution);
    seconds.push_back(watch.seconds());
    grouping.removeSeeds({grouping.numberOfSeeds() - 1}, corrected.execution);
  }
  Measurement result;
  result.seconds = medianOf(seconds);
  return result;
}

/** One seed and the connected groups after it, with the default settings, of 100, each
 *  on the same grouping.
 *  \tparam percent of them that are as quick */
template <int percent>
Measurement
click(const Work& work, const Cloud::ConstPtr& cloud)
{
  CIDSampler<pcl::PointXYZ> sampler;
  sampler.setInputCloud(cloud);
  configure(work, sampler);
  Corrected corrected(work, Grouping(sampler.prepare(), {work.samples}));
  Grouping& grouping = corrected.grouping;
  grouping.groups(corrected.execution);
  std::vector<double> seconds;
  for (const pcl::index_t point : corrected.clicks) {
    const Stopwatch watch;
    grouping.addSeeds({point}, corrected.execution);
    grouping.groups(corrected.execution);
    seconds.push_back(watch.seconds());
    grouping.removeSeeds({grouping.numberOfSeeds() - 1}, corrected.execution);
  }
  Measurement result;
  result.seconds = quantileOf(seconds, percent / 100.0);
  return result;
}

/** The median over the seeds of the proposal, up to 100 of them, each put back. */
Measurement
removeOneSeed(const Work& work, const Cloud::ConstPtr& cloud)
{
  Corrected corrected(work, cloud);
  Grouping& grouping = corrected.grouping;
  const pcl::Indices all = grouping.seeds();
  std::vector<double> seconds;
  for (std::size_t k = 0; k < std::min(all.size(), corrections); ++k) {
    const Stopwatch watch;
    grouping.removeSeeds({k}, corrected.execution);
    seconds.push_back(watch.seconds());
    grouping.insertSeeds({all[k]}, k, corrected.execution);
  }
  Measurement result;
  result.seconds = medianOf(seconds);
  return result;
}

constexpr std::size_t busy_processes = 2;

Measurement
besideBusyProcesses(const Work& work, const Cloud::ConstPtr& cloud)
{
  const BusyProcesses others(busy_processes);
  return segment<configure>(work, cloud);
}

/** The same in processor time, of all threads. */
Measurement
processorTime(const Work& work, const Cloud::ConstPtr& cloud)
{
  const BusyProcesses others(busy_processes);
  const std::clock_t begun = std::clock();
  Measurement result = segment<configure>(work, cloud);
  result.seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  return result;
}

/** A file format in which this module and PCL read the same points. */
struct FileKind {
  const char* extension;
  CloudLayout layout;
};

const std::vector<FileKind>&
fileKinds()
{
  static const std::vector<FileKind> all = {{".pcd", {"PCD", CloudEncoding::binary}},
                                            {".pcd", {"PCD", CloudEncoding::ascii}},
                                            {".ply", {"PLY", CloudEncoding::binary}}};
  return all;
}

/** A file in the system's folder for such, as long as this lives. */
struct CloudFile {
  CloudFile(const Cloud& cloud, const FileKind& kind)
  : path(std::filesystem::temp_directory_path() /
         ("cid_end_to_end_" + std::to_string(getpid()) + kind.extension))
  {
    std::ofstream stream(path, std::ios::binary);
    writeCloud(stream, toLabelledCloud(cloud), kind.layout);
    if (!stream.flush())
      throw std::runtime_error("cannot write " + path);
  }

  ~CloudFile() { std::remove(path.c_str()); }

  CloudFile(const CloudFile&) = delete;
  CloudFile&
  operator=(const CloudFile&) = delete;

  const std::string path;
};

void
readHere(const std::string& path)
{
  pointsOf(readCloud(path));
}

void
readByPCL(const std::string& path)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  if (pcl::io::load(path, cloud) != 0)
    throw std::runtime_error("PCL cannot read " + path);
}

/** From a file that was just written, and is in the system's memory. */
template <std::size_t kind, void (*read)(const std::string&)>
Measurement
readFile(const Work&, const Cloud::ConstPtr& cloud)
{
  const CloudFile file(*cloud, fileKinds()[kind]);
  const Stopwatch watch;
  read(file.path);
  Measurement result;
  result.seconds = watch.seconds();
  return result;
}

using Perform = Measurement (*)(const Work&, const Cloud::ConstPtr&);

const std::map<std::string, Perform>&
works()
{
  static const std::map<std::string, Perform> all = {
      {"segment", segment<configureAsPaper>},
      {"defaults", segment<configure>},
      {"sample", sample},
      {"extend", extend},
      {"seeds", seeds},
      {"merge", merge},
      {"cut", cut},
      {"literal", literal},
      {"check", check},
      {"handle", handle},
      {"hulls", hulls<MergingRule::cid>},
      {"fit", hulls<MergingRule::hull>},
      {"add", addOneSeed},
      {"remove", removeOneSeed},
      {"click", click<50>},
      {"click_p95", click<95>},
      {"read_pcd", readFile<0, readHere>},
      {"read_ascii_pcd", readFile<1, readHere>},
      {"read_ply", readFile<2, readHere>},
      {"pcl_pcd", readFile<0, readByPCL>},
      {"pcl_ascii_pcd", readFile<1, readByPCL>},
      {"pcl_ply", readFile<2, readByPCL>},
      {"busy", besideBusyProcesses},
      {"busy_cpu", processorTime}};
  return all;
}

} // namespace

bool
isWork(const std::string& name)
{
  return works().count(name) != 0;
}

bool
needsSeeds(const Work& work)
{
  return work.name == "literal";
}

Measurement
perform(const Work& work, const Cloud::ConstPtr& cloud)
{
  return works().at(work.name)(work, cloud);
}

} // namespace pcl_cid::benchmarks
