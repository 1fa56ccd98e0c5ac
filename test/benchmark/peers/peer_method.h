/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a method of segmentation is to the comparison: settings, and work to do.
 */

#pragma once

#include "../child_process.h"
#include "peer_scan.h"

#include <pcl_cid/io/report.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::benchmarks {

/** \brief One run of a method. */
struct PeerRun {
  std::string method;
  std::vector<Report::Parameter> settings;
  /** Segments the scan and returns `labels`, one for each point, from 1; and `seeds`
   *  where there are any, with the label k + 1 for seed k. */
  std::function<Measurement()> work;
};

/** \brief How methods with seeds are run. */
struct SeedSettings {
  int seeds = 100;
  /** Groups of the merge tree that fewer parts are cut from; not set: as many as
   *  `seeds`. */
  std::optional<int> tree_seeds;
  std::vector<std::uint64_t> random_seeds = {0};
  unsigned int threads = 1;

  int
  treeSeeds() const
  {
    return tree_seeds.value_or(seeds);
  }
};

/** \brief The point that every method with seeds begins at. */
pcl::index_t
drawStart(const PeerScan& scan, std::uint64_t random_seed);

/** \brief Label k + 1 for each point of group k, 0 for those of none (-1). */
std::vector<std::uint32_t>
labelsOfGroups(const std::vector<pcl::index_t>& group);

/** \brief CIDSampler, one run for each random seed.
 *  \param[in] subsample 0 for full resolution (`cid`), else as in
 *  CIDParameters::setSubsample (`cid20k`) */
std::vector<PeerRun>
cidRuns(const PeerScan& scan, const SeedSettings& settings, int subsample);

/** \brief The ablation: farthest-first traversal in Euclidean distance, and the nearest
 *  seed of every point; one run for each random seed (`euclidean`). */
std::vector<PeerRun>
euclideanRuns(const PeerScan& scan, const SeedSettings& settings);

/** \brief pcl::SupervoxelClustering and pcl::LCCPSegmentation, all settings that are
 *  tried (`lccp`).
 *  \param[in] spacing see pointSpacing(); lengths of the settings are multiples of it
 */
std::vector<PeerRun>
lccpRuns(const PeerScan& scan, double spacing);

/** \brief pcl::RegionGrowing with estimated normals, all settings that are tried
 *  (`region_growing`). */
std::vector<PeerRun>
regionGrowingRuns(const PeerScan& scan);

/** \brief Weakly convex components by lines of sight, see weak_convexity.h; all
 *  settings that are tried (`wcseg`). */
std::vector<PeerRun>
wcsegRuns(const PeerScan& scan);

/** \brief Median distance from a point to its nearest neighbor: what lengths of a
 *  sweep are multiples of, for clouds of any unit and density.
 *  \throws CIDException when it is 0 */
double
pointSpacing(const Cloud& cloud);

/** \brief Give points that a method left without a label (0) that of the nearest point
 *  with one. It can only raise the purity. All 0 stays all 0. */
void
labelTheRest(const Cloud& cloud, std::vector<std::uint32_t>& labels);

} // namespace pcl_cid::benchmarks
