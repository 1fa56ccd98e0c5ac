/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The kinds of work that are measured.
 */

#include "measured_work.h"

#include "literal_method.h"

#include "base/parallel_for.h"

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/cid_sampler.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/prepared_scan.h>
#include "base/random.h"
#include <pcl_cid/io/cloud_points.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <pcl/common/common.h>

namespace pcl_cid::benchmarks {
namespace {

constexpr int extended_by = 10;
constexpr std::size_t parts_of_cut = 30;
constexpr std::size_t checked_points = 50;
/** The literal method would go through the points in their order, for which the caches
 *  of the processor thank it: the pairs are drawn in runs of neighbours. */
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
  parameters.setDensityWeight(DensityWeight::off);
  parameters.setIsolatedNeighbors(0);
  parameters.setFillBlindSpot(false);
}

/** Algorithm 1 begun: what comes before the seeds and what comes after them. */
class Decomposition {
public:
  Decomposition(const Work& work, const Cloud& cloud)
  {
    configureAsPaper(work, parameters_);
    execution_.threads = work.threads;
    ready_ = prepare({finitePoints(cloud), {}, {}, {}}, {}, parameters_, execution_);
  }

  SeedProposal
  proposeSeeds() const
  {
    return propose(ready_, parameters_, false, execution_, "cid_end_to_end");
  }

  MergeTree
  mergeGroups(const SeedProposal& proposal, std::size_t parts) const
  {
    GroupMergingOptions options;
    options.samples = parameters_.getNumberOfSamples();
    options.stop_at_parts = parts;
    options.execution = execution_;
    return pcl_cid::mergeGroups(ready_.working->field(),
                                ready_.working->points(),
                                proposal.group,
                                proposal.seeds.size(),
                                options);
  }

private:
  CIDParameters parameters_;
  ExecutionOptions execution_;
  Preparation ready_;
};

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
  const Decomposition decomposition(work, *cloud);
  Measurement result;
  const Stopwatch watch;
  decomposition.proposeSeeds();
  result.seconds = watch.seconds();
  return result;
}

Measurement
mergeTo(std::size_t parts, const Work& work, const Cloud::ConstPtr& cloud)
{
  const Decomposition decomposition(work, *cloud);
  const SeedProposal proposal = decomposition.proposeSeeds();
  Measurement result;
  const Stopwatch watch;
  decomposition.mergeGroups(proposal, parts);
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
      {"check", check}};
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
