/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What became of each of several scans.
 */

#pragma once

#include <pcl_cid/io/report.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief The size of a scan and of what was made of it; what does not apply is
 *  empty. */
struct ScanFigures {
  std::size_t points = 0;
  std::size_t finite = 0;
  std::optional<std::size_t> seeds;
  std::optional<std::size_t> groups;
  std::optional<std::size_t> parts;
};

/** \brief Those of a run, as its report has them. */
ScanFigures
figuresOf(const Report& report);

/** \brief "3400 points, 12 groups". */
std::string
wordsOf(const ScanFigures& figures);

/** \brief One of several scans, and how it ended. */
struct ScanRow {
  std::string scan;
  std::string name;
  std::string error;                  ///< why it failed
  std::optional<ScanFigures> figures; ///< once it is done
  double seconds = 0.0;               ///< until then

  /** \brief "done", "failed", or "not done" where the run was interrupted before. */
  const char*
  status() const;
};

/** \brief A row for each scan, as JSON or as CSV, whichever the extension of its file
 *  says. */
std::string
summaryFor(const std::string& path,
           const std::string& tool,
           const std::vector<ScanRow>& rows);

} // namespace pcl_cid::tools
