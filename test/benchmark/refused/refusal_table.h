/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The figures of several sets of hulls as a table.
 */

#pragma once

#include "refused_places.h"

#include <string>
#include <vector>

namespace pcl_cid::benchmarks {

/** \brief A row of the table. */
struct MeasuredHulls {
  std::string file;
  std::size_t vertices = 0; ///< of the parts in the file
  RefusalFigures figures;
  double seconds = 0.0; ///< of reading and measuring them
};

/** \brief For people: columns are aligned. */
std::string
toText(const std::vector<MeasuredHulls>& rows);

/** \brief For programs (RFC 4180): numbers with all of their digits. */
std::string
toCsv(const std::vector<MeasuredHulls>& rows);

} // namespace pcl_cid::benchmarks
