/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_segment writes for the tools of ScanNet.
 */

#include "scannet_outputs.h"

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/scannet.h>
#include <pcl_cid/io/scannet_export.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

namespace pcl_cid::tools {
namespace {

namespace fs = std::filesystem;

std::string
listPath(const ScannetSettings& settings, const std::string& scan_id)
{
  return fs::path(settings.submission) / (scan_id + ".txt");
}

std::string
maskFolder(const ScannetSettings& settings)
{
  return fs::path(settings.submission) / mask_folder;
}

/** Those of the classes that the benchmark has; it takes no others. */
std::vector<PredictedInstance>
ofBenchmarkClasses(std::vector<PredictedInstance> instances)
{
  const auto isNot = [](const PredictedInstance& instance) {
    return !className(scannetBenchmarkClasses(), instance.semantic);
  };
  instances.erase(std::remove_if(instances.begin(), instances.end(), isNot),
                  instances.end());
  return instances;
}

void
announceOldMasks(const std::string& folder,
                 const std::string& scan_id,
                 OutputFiles& outputs)
{
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (isMaskFileName(entry.path().filename().string(), scan_id))
      outputs.announceRemoval(entry.path().string());
}

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
  const std::string folder = maskFolder(settings);
  announceOldMasks(folder, scan.name, outputs);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const std::string path = fs::path(folder) / maskFileName(scan.name, i);
    outputs.announce(path);
    outputs.write(path, [&](std::ostream& stream) {
      writeMask(stream, scan.labels, instances[i].label);
    });
  }
  outputs.write(listPath(settings, scan.name), [&](std::ostream& stream) {
    writePredictions(stream, scan.name, instances);
  });
}

} // namespace

void
declareScannetOptions(ScannetSettings& settings, CommandLine& line)
{
  line.group("For tools of ScanNet");
  line.text("superpoints",
            "FILE.json",
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
  if (!settings.superpoints.empty())
    requireExtension("--superpoints", settings.superpoints, {".json"});
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
    outputs.announceFolder(settings.submission);
    outputs.announceFolder(maskFolder(settings));
    outputs.announce(listPath(settings, scanName(input)));
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
