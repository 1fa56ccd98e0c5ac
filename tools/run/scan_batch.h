/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scan after scan in one call, each as a run of its own.
 */

#pragma once

#include "many_scans.h"
#include "scan_summary.h"

#include <pcl_cid/io/output_files.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief What a tool does with a scan, which it is told by its path. */
struct ScanWork {
  const char* tool;
  const char* doing; ///< "Segmenting"
  const char* done;  ///< "segmented"
  bool has_format;   ///< whether it is said which format all scans have
  bool in_blocks;    ///< whether scans may be larger than the memory
  std::function<std::vector<std::string>(const std::string&)> inputs;
  std::function<void(const std::string&, OutputFiles&)> announce;
  std::function<ScanFigures(const std::string&)> run;
};

/** \brief Do each scan, and tell the user and the summary how it ended. What can be
 *  known before is checked before: a scan that cannot be read fails at once, an
 *  output that cannot be written, or means a file that is written or read elsewhere,
 *  stops all.
 *  \throws CIDException when an output cannot be written, or, at the end, when scans
 *  failed
 *  \throws Interrupted those that are done stay */
void
doEachScan(const ScanWork& work, const ManyScans& many, bool quiet);

/** \brief The same with what a tool has for one scan: inputsOf(), announceOutputs() and
 *  nameOptions() of its settings.
 *  \param[in] run the work on one scan */
template <typename ToolSettings, typename RunScan>
void
doEachScan(const char* tool,
           const char* doing,
           const char* done,
           ToolSettings settings,
           const RunScan& run)
{
  const auto settingsFor = [&](const std::string& scan) {
    ToolSettings one = settings;
    one.many.scans.clear();
    one.input = scan;
    insertName(scan, nameOptions(one));
    one.output = outputOf(one.many, scan);
    return one;
  };
  doEachScan({tool,
              doing,
              done,
              !settings.input_format.empty(),
              settings.voxel.has_value(),
              [&](const std::string& scan) { return inputsOf(settingsFor(scan)); },
              [&](const std::string& scan, OutputFiles& outputs) {
                announceOutputs(settingsFor(scan), outputs);
              },
              [&](const std::string& scan) { return run(settingsFor(scan)); }},
             settings.many,
             settings.quiet);
}

} // namespace pcl_cid::tools
