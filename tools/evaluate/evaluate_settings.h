/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_evaluate is told: its settings and its command line.
 */

#pragma once

#include "compared_scan.h"
#include "scan_pairs.h"

#include <pcl_cid/core/evaluation.h>
#include <pcl_cid/io/output_files.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

constexpr const char* evaluate_tool = "pcl_cid_evaluate";

/** \brief Settings of pcl_cid_evaluate; what is not asked for is empty. */
struct EvaluateSettings {
  std::string prediction;
  std::string truth;
  EvaluationProtocol protocol = EvaluationProtocol::paper;
  FieldNames fields;
  std::string classes;     ///< empty: those of the protocol
  std::string class_table; ///< of ScanNet; empty: looked for
  bool partial = false;
  std::string report;
  std::string csv;
  bool quiet = false;

  std::string
  classesOrDefault() const;
};

/** \brief Read the command line, or answer `--help` and `--version`.
 *  \return whether there is work to do
 *  \throws UsageError */
bool
readCommandLine(int argc, const char* const* argv, EvaluateSettings& settings);

/** \brief The files that will be read, as far as that can be told beforehand: outputs
 *  must never be written over them. What is wrong with a scan is reported when its turn
 *  comes. */
std::vector<std::string>
inputsOf(const EvaluateSettings& settings, const std::vector<ScanPair>& pairs);

} // namespace pcl_cid::tools
