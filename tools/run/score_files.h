/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scores as a report and as a table, for the tools that make nothing else.
 */

#pragma once

#include <pcl_cid/io/output_files.h>

#include <ostream>
#include <string>

namespace pcl_cid::tools {

/** \brief Announce `settings.report` and `settings.csv`, where they are asked for. */
template <typename Settings>
void
announceScores(const Settings& settings, OutputFiles& outputs)
{
  for (const std::string& path : {settings.report, settings.csv})
    if (!path.empty())
      outputs.announce(path);
}

/** \brief Write toJson() and toCsv() of the scores to them, both or none. */
template <typename Settings, typename Scores>
void
saveScores(const Settings& settings, const Scores& scores, OutputFiles& outputs)
{
  if (!settings.report.empty())
    outputs.write(settings.report, [&](std::ostream& s) { s << toJson(scores); });
  if (!settings.csv.empty())
    outputs.write(settings.csv, [&](std::ostream& s) { s << toCsv(scores); });
  outputs.commit();
}

} // namespace pcl_cid::tools
