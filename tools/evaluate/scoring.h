/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scan after scan is read, reduced to its overlaps, and scored.
 */

#pragma once

#include "class_table.h"
#include "evaluate_settings.h"
#include "evaluation_report.h"
#include "run/console.h"
#include "run/failed_scans.h"

#include <pcl_cid/core/instance_overlaps.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief Scores scans one by one, and then all of them together. */
class Scoring {
public:
  /** \param[in] settings,console must outlive it
   *  \throws CIDException when the classes cannot be read */
  Scoring(const EvaluateSettings& settings, Console& console);

  /** \brief Read and score a pair.
   *  \throws CIDException when it cannot be scored; then it does not count */
  void
  add(const ScanPair& pair);

  /** \brief Pairs that add() threw at, to be noted down. */
  std::vector<FailedScan>&
  failed()
  {
    return report_.failed;
  }

  /** \brief Score all scans together.
   *  \throws CIDException when there is none */
  const EvaluationReport&
  finish();

private:
  void
  settleClasses(const ScanPair& pair, const ComparedScan& scan);

  Evaluation
  evaluateScan(const ScanPair& pair, const ComparedScan& scan) const;

  const EvaluateSettings& settings_;
  Console& console_;
  ClassTable table_;
  bool has_classes_ = false;
  std::vector<InstanceOverlaps> overlaps_;
  EvaluationReport report_;
};

} // namespace pcl_cid::tools
