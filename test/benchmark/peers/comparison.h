/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Methods measured and scored on one scan.
 */

#pragma once

#include "peer_method.h"
#include "peer_scores.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::benchmarks {

/** \brief A run with its figures. */
struct PeerRow {
  PeerRun run;
  /** Why it has no figures; empty when it has. */
  std::string failure;
  Measurement measured;
  std::size_t parts = 0;
  /** Share of the points that the method gave a label. */
  double labelled = 0.0;
  /** With the other points counted as wrong. */
  double own_purity = 0.0;
  /** Once the other points have the label of the nearest labelled one, see
   *  labelTheRest(). */
  double purity = 0.0;
  /** Of CID with as many parts, see purityOfCID(); where it was asked for. */
  std::optional<double> cid_purity;
  /** Of methods with seeds. */
  std::optional<Evaluation> scores;
  /** Labels for a file: of the seeds where there are any, else of the parts. */
  std::vector<std::uint32_t> labels;
  /** Of the runs of a method without seeds, the one that counts. */
  bool is_best = false;

  bool
  hasSeeds() const
  {
    return scores.has_value();
  }

  /** \brief How much purer than CID it is. */
  double
  margin() const
  {
    return purity - cid_purity.value_or(0.0);
  }
};

/** \brief Run a method in a process of its own, and score what comes out; when it
 * fails, the row says so. This process stays without threads. */
PeerRow
measureAndScore(const PeerScan& scan, PeerRun run);

/** \brief How many parts a segmentation may have to be compared at all: with too few or
 *  too many, every method is as pure as every other. Half to five times the number of
 *  true instances, that is, compactness from 2 down to 0.2. */
struct ComparableParts {
  std::size_t least;
  std::size_t most;

  bool
  contains(std::size_t parts) const
  {
    return parts >= least && parts <= most;
  }
};

ComparableParts
comparableParts(const PeerScan& scan);

/** \brief Fill in `cid_purity` of every row with seeds and of every other one whose
 *  parts are comparable; and mark, for each method without seeds, the one with the
 *  largest margin among them (at equal margin the first) as its best. */
void
compareWithCID(const PeerScan& scan,
               const SeedSettings& settings,
               std::vector<PeerRow>& rows);

/** \brief The purity of CID at every comparable number of parts, see purityOfCID(). */
std::map<std::size_t, double>
cidCurve(const PeerScan& scan, const SeedSettings& settings);

/** \brief "voxel_spacings=2.0 k_factor=1". */
std::string
settingsAsText(const PeerRun& run);

/** \brief All rows as JSON.
 *  \param[in] curve see cidCurve(); empty where it was not asked for */
std::string
toJson(const PeerScan& scan,
       const SeedSettings& settings,
       const std::vector<PeerRow>& rows,
       const std::map<std::size_t, double>& curve);

/** \brief The rows with seeds, and the best ones of the others, as a table. */
std::string
toTable(const std::vector<PeerRow>& rows);

} // namespace pcl_cid::benchmarks
