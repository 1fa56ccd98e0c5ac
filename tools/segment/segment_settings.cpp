/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_segment is told: its settings and its command line.
 */

#include "segment_settings.h"

#include "heat_map.h"
#include "picture/picture.h"
#include "run/loaded_scan.h"
#include "run/parameter.h"
#include "run/session_settings.h"
#include "run/voxel_scan.h"
#include "run/words.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/seed_table.h>

#include <utility>

namespace pcl_cid::tools {
namespace {

constexpr const char* about =
    "Label every point of a scan by its CID-nearest seed. INPUT is a file of\n"
    "points (PCD, PLY, text, NumPy, KITTI), a mesh, a room folder of S3DIS or a scan\n"
    "folder of ScanNet (with their `label` and `semantic`); OUTPUT (.pcd or .ply) has\n"
    "the same points and fields, and the field `label`. Either may be -, the standard\n"
    "input or output.\n\n"
    "  1. pcl_cid_segment scan.pcd groups.pcd --propose seeds.csv\n"
    "  2. fill in the column `label` of seeds.csv (0 for none; empty: not asked)\n"
    "  3. pcl_cid_segment scan.pcd labelled.pcd --labels seeds.csv\n\n"
    "Without --labels and --labels-from, the label is the number of the group + 1.\n"
    "Points that are not finite get label 0, which means none.";

void
declareLabelOptions(SegmentSettings& settings, CommandLine& line)
{
  line.group("Labels");
  line.text("propose", "FILE.csv", settings.propose, "write the seeds, to be labelled");
  line.text("labels", "FILE.csv", settings.labels, "seeds with their labels");
  line.text("labels-from",
            "FIELD",
            settings.labels_from,
            "propose seeds and read their labels from this field of INPUT; prints how "
            "many points then have the label that the field says");
  declareSessionOption(
      settings.session, "the labels of a session of pcl_cid_studio on INPUT", line);
  line.exclude("session",
               {"labels",
                "labels-from",
                "propose",
                "cid-from",
                "superpoints",
                "scannet-submission"});
  line.choice(setting::clean_up, settings.clean_up);
}

/** OUTPUT: a cloud, which may go to the standard output. */
FileArgument
labelledOutput()
{
  FileArgument argument = outputArgument("OUTPUT", writableCloudExtensions());
  argument.may_be_stream = true;
  return argument;
}

} // namespace

bool
readCommandLine(int argc, const char* const* argv, SegmentSettings& settings)
{
  CommandLine line(segment_tool,
                   "pcl_cid_segment INPUT OUTPUT [options]\n"
                   "pcl_cid_segment SCAN... --output-dir DIR [options]",
                   about);
  declareLabelOptions(settings, line);
  declareHeatMapOption(settings.cid_from, line);
  declareScannetOptions(settings.scannet, line);
  line.group("To look at");
  declarePictureOption(settings.html, line);
  declareSeedOptions(settings, line);
  std::vector<std::string> formats = withoutDots(writableCloudExtensions());
  formats.insert(formats.begin(), settings.many.format = same_format);
  declareManyScans(settings.many, "cloud-format", formats, line);
  declareRunOptions(settings, line);
  declareVoxelOption(settings.voxel,
                     {"session",
                      "cid-from",
                      "superpoints",
                      "scannet-submission",
                      "html",
                      "class-table",
                      optionName(setting::mesh_spacing)},
                     line);
  line.exclude("labels",
               {"labels-from",
                "propose",
                optionName(setting::seeds),
                optionName(setting::coverage),
                optionName(setting::start_index),
                optionName(setting::seeding)});
  if (!parseScans(argc, argv, labelledOutput(), nameOptions(settings), settings, line))
    return false;
  checkScannetOptions(settings.scannet, settings.labels_from);
  checkVoxelOption(settings);
  return true;
}

std::vector<NameOption>
nameOptions(SegmentSettings& settings)
{
  return {{"labels", &settings.labels},
          {"propose", &settings.propose},
          {"session", &settings.session},
          {"report", &settings.report},
          {"html", &settings.html},
          {"superpoints", &settings.scannet.superpoints},
          {"scannet-submission", &settings.scannet.submission, true}};
}

std::vector<std::string>
inputsOf(const SegmentSettings& settings)
{
  std::vector<std::string> inputs = inputFiles(settings);
  inputs.push_back(settings.labels);
  inputs.push_back(settings.session);
  return inputs;
}

void
announceOutputs(const SegmentSettings& settings, OutputFiles& outputs)
{
  announceScannetOutputs(settings.scannet, settings.input, outputs);
  announceCloud(settings.output, outputs);
  if (!settings.propose.empty()) {
    if (holdsLabels(settings.propose))
      throw CIDException(settings.propose +
                         ": holds labels, which would be lost; choose another name");
    outputs.announce(settings.propose);
  }
  announcePicture(settings.html, outputs);
  if (!settings.report.empty())
    outputs.announce(settings.report);
}

std::vector<Report::Parameter>
labelParametersOf(const SegmentSettings& settings)
{
  std::vector<Report::Parameter> parameters{
      parameter(setting::clean_up, settings.clean_up)};
  for (const auto& [name, value] : {std::pair("labels", settings.labels),
                                    std::pair("labels_from", settings.labels_from)})
    if (!value.empty())
      parameters.push_back({name, value});
  return parameters;
}

} // namespace pcl_cid::tools
