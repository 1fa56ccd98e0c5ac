/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID, at full resolution and on a draw; and its Euclidean ablation.
 */

#include "euclidean_sampling.h"
#include "peer_method.h"

#include <pcl_cid/cid_sampler.h>

namespace pcl_cid::benchmarks {
namespace {

Measurement
withGroups(const pcl::Indices& seeds, const std::vector<pcl::index_t>& group)
{
  Measurement result;
  result.seeds = seeds;
  result.labels = labelsOfGroups(group);
  return result;
}

std::vector<Report::Parameter>
describe(const SeedSettings& settings, std::uint64_t random_seed)
{
  return {{"seeds", std::int64_t(settings.seeds)}, {"random_seed", random_seed}};
}

void
configureAsInThePaper(int subsample, CIDParameters& parameters)
{
  parameters.setSubsample(subsample);
  parameters.setPaperSettings();
}

} // namespace

std::vector<PeerRun>
cidRuns(const PeerScan& scan, const SeedSettings& settings, int subsample)
{
  std::vector<PeerRun> runs;
  for (const std::uint64_t random_seed : settings.random_seeds) {
    PeerRun run;
    run.method = subsample == 0 ? "cid" : "cid20k";
    run.settings = describe(settings, random_seed);
    run.settings.push_back({"subsample", std::int64_t(subsample)});
    run.work = [=, &scan] {
      CIDSampler<pcl::PointXYZ> sampler;
      sampler.setInputCloud(scan.cloud);
      sampler.setNumberOfSeeds(settings.seeds);
      if (subsample != 0) // the paper's setting, which is Algorithm 1 as it is
        configureAsInThePaper(subsample, sampler);
      sampler.setRandomSeed(random_seed);
      sampler.setStartIndex(drawStart(scan, random_seed));
      sampler.setNumberOfThreads(settings.threads);
      pcl::Indices seeds;
      sampler.sample(seeds);
      return withGroups(seeds, sampler.getProposal().group);
    };
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<PeerRun>
euclideanRuns(const PeerScan& scan, const SeedSettings& settings)
{
  std::vector<PeerRun> runs;
  for (const std::uint64_t random_seed : settings.random_seeds) {
    PeerRun run;
    run.method = "euclidean";
    run.settings = describe(settings, random_seed);
    run.work = [=, &scan] {
      const EuclideanSample sample =
          sampleFarthestFirst(finitePoints(*scan.cloud).points,
                              drawStart(scan, random_seed),
                              static_cast<std::size_t>(settings.seeds));
      return withGroups(sample.seeds, sample.group);
    };
    runs.push_back(std::move(run));
  }
  return runs;
}

} // namespace pcl_cid::benchmarks
