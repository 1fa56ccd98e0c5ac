/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scores as a table for people, as JSON and as CSV.
 */

#pragma once

#include "class_table.h"
#include "compared_scan.h"
#include "run/failed_scans.h"

#include <pcl_cid/core/evaluation.h>
#include <pcl_cid/core/settings.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief A scan and its scores. */
struct ScoredScan {
  ScanPair pair;
  std::size_t points = 0;
  ClassRule class_rule = ClassRule::same_label;
  std::vector<std::string> remarks;
  Evaluation evaluation;
};

/** \brief What pcl_cid_evaluate found. */
struct EvaluationReport {
  std::string prediction;
  std::string truth;
  EvaluationProtocol protocol = EvaluationProtocol::paper;
  ClassTable classes;
  std::vector<ScoredScan> scans;
  std::vector<FailedScan> failed;
  /** The scores of all scans together. */
  Evaluation pooled;
};

/** \brief Figures of each class, and their means, with 3 digits. */
void
printTable(std::ostream& stream, const EvaluationReport& report);

/** \brief All scores, those of each scan and class among them. */
std::string
toJson(const EvaluationReport& report);

/** \brief A row for each scan and class, and for all. */
std::string
toCsv(const EvaluationReport& report);

} // namespace pcl_cid::tools
