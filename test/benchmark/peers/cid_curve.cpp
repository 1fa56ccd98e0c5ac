/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The purity of CID at any number of parts: what peers are compared with.
 */

#include "cid_curve.h"

#include "peer_scores.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/cid_sampler.h>

namespace pcl_cid::benchmarks {
namespace {

/** The part of the group of each point; groups are numbered from 0, labels from 1. */
std::vector<std::uint32_t>
labelsOfParts(const std::vector<pcl::index_t>& group, const std::vector<int>& part)
{
  std::vector<std::uint32_t> labels;
  for (const pcl::index_t k : group)
    labels.push_back(static_cast<std::uint32_t>(part[static_cast<std::size_t>(k)]) + 1);
  return labels;
}

void
configure(const PeerScan& scan,
          const SeedSettings& settings,
          std::uint64_t random_seed,
          CIDParameters& parameters)
{
  parameters.setRandomSeed(random_seed);
  parameters.setStartIndex(drawStart(scan, random_seed));
  parameters.setNumberOfThreads(settings.threads);
}

/** Purities below the size of the tree: one merge tree, cut to each number. */
void
addCutPurities(const PeerScan& scan,
               const SeedSettings& settings,
               std::uint64_t random_seed,
               const std::set<std::size_t>& parts,
               std::map<std::size_t, double>& sum)
{
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  configure(scan, settings, random_seed, abstraction);
  abstraction.setInputCloud(scan.cloud);
  abstraction.setNumberOfSeeds(settings.treeSeeds());
  std::vector<pcl::PointIndices> at_elbow;
  abstraction.segment(at_elbow);
  for (const std::size_t n : parts)
    sum[n] += purityOf(labelsOfParts(abstraction.getProposal().group,
                                     abstraction.getMergeTree().cutAtParts(n)),
                       scan);
}

/** Purities from there on: one traversal, which is extended from number to number. */
void
addSeedPurities(const PeerScan& scan,
                const SeedSettings& settings,
                std::uint64_t random_seed,
                const std::set<std::size_t>& parts,
                std::map<std::size_t, double>& sum)
{
  CIDSampler<pcl::PointXYZ> sampler;
  configure(scan, settings, random_seed, sampler);
  sampler.setInputCloud(scan.cloud);
  pcl::Indices seeds;
  for (const std::size_t n : parts) {
    if (seeds.empty()) {
      sampler.setNumberOfSeeds(static_cast<int>(n));
      sampler.sample(seeds);
    }
    else {
      sampler.extend(static_cast<int>(n), seeds);
    }
    sum[n] += purityOf(labelsOfGroups(sampler.getProposal().group), scan);
  }
}

} // namespace

std::map<std::size_t, double>
purityOfCID(const PeerScan& scan,
            const SeedSettings& settings,
            const std::set<std::size_t>& parts)
{
  const auto from_tree =
      parts.lower_bound(static_cast<std::size_t>(settings.treeSeeds()));
  const std::set<std::size_t> cuts(parts.begin(), from_tree);
  const std::set<std::size_t> seeds(from_tree, parts.end());
  std::map<std::size_t, double> purity;
  for (const std::uint64_t random_seed : settings.random_seeds) {
    if (!cuts.empty())
      addCutPurities(scan, settings, random_seed, cuts, purity);
    if (!seeds.empty())
      addSeedPurities(scan, settings, random_seed, seeds, purity);
  }
  for (auto& [n, sum] : purity)
    sum /= static_cast<double>(settings.random_seeds.size());
  return purity;
}

} // namespace pcl_cid::benchmarks
