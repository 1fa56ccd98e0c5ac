/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_segment writes for the tools of ScanNet.
 */

#include "scannet_outputs.h"

#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/scannet.h>
#include <pcl_cid/io/scannet_annotation.h>
#include <pcl_cid/io/scannet_export.h>

#include <ostream>

namespace pcl_cid::tools {
namespace {

void
writeSubmission(const ScannetSettings& settings,
                const SegmentedScan& scan,
                const Console& console,
                OutputFiles& outputs)
{
  const std::vector<PredictedInstance> all =
      instancesWithTrueClass(scan.labels, scan.true_labels, scan.true_classes);
  const std::vector<PredictedInstance> instances = ofBenchmarkClasses(all);
  console.value("Instances of the benchmark's classes",
                std::to_string(instances.size()) + " of " + std::to_string(all.size()));
  writeScannetSubmission(
      settings.submission, scan.name, scan.labels, instances, outputs);
}

} // namespace

void
declareScannetOptions(ScannetSettings& settings, CommandLine& line)
{
  line.group("For tools of ScanNet");
  line.file("superpoints",
            "FILE.json",
            {".json"},
            settings.superpoints,
            "write the group of each point as segIndices, as in ScanNet's segs.json");
  line.text("scannet-submission",
            "DIR",
            settings.submission,
            "write predictions for ScanNet's instance benchmark to this folder, made "
            "when missing: <id>.txt and pred_mask/; INPUT must be a scan of ScanNet; "
            "needs --labels-from, and takes the class of the true instance");
}

void
checkScannetOptions(const ScannetSettings& settings, const std::string& labels_from)
{
  if (!settings.submission.empty() && labels_from.empty())
    throw UsageError("--scannet-submission needs --labels-from, which says what "
                     "instance, and so what class, a label means");
}

void
announceScannetOutputs(const ScannetSettings& settings,
                       const std::string& input,
                       OutputFiles& outputs)
{
  if (!settings.submission.empty()) {
    if (!isScannetScan(input))
      throw CIDException(input + ": is no scan of ScanNet; --scannet-submission needs "
                                 "one, for its id and its classes");
    announceScannetSubmission(settings.submission, scanName(input), outputs);
  }
  if (!settings.superpoints.empty())
    outputs.announce(settings.superpoints);
}

void
writeScannetOutputs(const ScannetSettings& settings,
                    const SegmentedScan& scan,
                    const Console& console,
                    OutputFiles& outputs)
{
  if (!settings.superpoints.empty())
    outputs.write(settings.superpoints, [&](std::ostream& stream) {
      writeSuperpoints(stream, scan.name, scan.group);
    });
  if (!settings.submission.empty())
    writeSubmission(settings, scan, console, outputs);
}

} // namespace pcl_cid::tools
