/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings that pcl_cid_segment and pcl_cid_abstract have in common.
 */

#include "common_settings.h"

#include "console.h"
#include "loaded_scan.h"
#include "parameter.h"
#include "words.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>

namespace pcl_cid::tools {
namespace {

/** What a scan may be read as; how it is packed, its content tells. */
std::vector<std::string>
fileFormats()
{
  std::vector<std::string> formats = withoutDots(scanExtensions());
  formats.erase(std::remove(formats.begin(), formats.end(), "gz"), formats.end());
  return formats;
}

/** The place of a point of the input among those that are worked on. Where these are
 *  all, the library refuses what is no point of it. */
int
placeOf(int start_index, const CloudPoints& points)
{
  if (points.source.empty())
    return start_index;
  if (start_index >= 0 && static_cast<std::size_t>(start_index) >= points.sizeOfFile())
    throw CIDException("--start-index is " + std::to_string(start_index) +
                       "; INPUT has " + std::to_string(points.sizeOfFile()) +
                       " points, numbered from 0");
  const pcl::index_t place = points.find(start_index);
  if (place < 0)
    throw CIDException(
        "--start-index is " + std::to_string(start_index) +
        ", which is no point of INPUT that a voxel kept; the nearest seed "
        "that --propose lists may serve");
  return place;
}

} // namespace

int
Settings::numberOfSeeds(std::size_t points) const
{
  if (seeds)
    return *seeds;
  return coverage ? static_cast<int>(points) : setting::seeds.initial;
}

void
declareGroupingOptions(Settings& settings, CommandLine& line)
{
  line.setting(setting::samples, settings.samples);
  line.setting(setting::subsample, settings.subsample);
  line.setting(setting::random_seed, settings.random_seed);
  line.optional(setting::start_index, settings.start_index);
  declareRawScanOptions(settings.raw_scan, line);
}

void
declareSeedOptions(Settings& settings, CommandLine& line)
{
  line.group(setting::seeds.group);
  line.optional(setting::seeds,
                settings.seeds,
                "default " + std::to_string(setting::seeds.initial) +
                    ", or as many as --coverage needs");
  line.optional(
      setting::coverage, settings.coverage, "with --seeds, whichever comes first");
  declareGroupingOptions(settings, line);
}

void
declareClassTable(std::string& class_table, CommandLine& line)
{
  line.text("class-table",
            "FILE.tsv",
            class_table,
            "ScanNet's scannetv2-labels.combined.tsv, when INPUT is a scan of "
            "ScanNet; default: looked for in INPUT and the folders above it");
}

void
declareReadingOptions(Settings& settings, CommandLine& line)
{
  line.group(setting::threads.group);
  declareClassTable(settings.class_table, line);
  line.word(
      "input-format",
      "F",
      fileFormats(),
      settings.input_format,
      "read INPUT as a file with this extension, whatever its name says; INPUT - is "
      "the standard input, whose format its content may not tell");
  line.setting(setting::scale, settings.scale);
  line.setting(setting::mesh_spacing, settings.mesh_spacing);
  line.flag("keep-zeros",
            settings.keep_zeros,
            "10 points and more exactly at (0, 0, 0), or at the sensor, are points; "
            "without it they count as what did not return, and get label 0");
}

void
declareLastOptions(Settings& settings, CommandLine& line)
{
  line.setting(setting::threads, settings.threads);
  line.text("report",
            "FILE.json",
            settings.report,
            "write what was done, and how long it took");
  line.flag("quiet", settings.quiet, "print nothing but errors");
  line.helpOptions();
}

void
declareRunOptions(Settings& settings, CommandLine& line)
{
  declareReadingOptions(settings, line);
  line.choice(label_type_setting, settings.label_type);
  line.choice(output_unit_setting, settings.output_unit);
  line.require("output-unit", {"scale"});
  declareLastOptions(settings, line);
}

void
configure(const Settings& settings,
          const LoadedScan& scan,
          Console& console,
          CIDParameters& parameters)
{
  parameters.setNumberOfSeeds(settings.numberOfSeeds(scan.cloud.size()));
  parameters.setCoverage(static_cast<float>(settings.coverage.value_or(0.0)));
  configureGrouping(settings, scan, {settings.threads, console.progress()}, parameters);
}

void
configureGrouping(const Settings& settings,
                  const LoadedScan& scan,
                  const ExecutionOptions& execution,
                  CIDParameters& parameters)
{
  parameters.setNumberOfSamples(settings.samples);
  parameters.setSubsample(settings.subsample);
  parameters.setRandomSeed(settings.random_seed);
  if (settings.start_index)
    parameters.setStartIndex(placeOf(*settings.start_index, scan.points));
  configureForRawScan(settings.raw_scan, scan.cloud, parameters);
  parameters.setNumberOfThreads(execution.threads);
  parameters.setProgressCallback(execution.progress);
}

std::vector<Report::Parameter>
parametersOf(const Settings& settings, const CIDParameters& parameters)
{
  std::vector<Report::Parameter> list{
      parameter(setting::seeds, parameters.getNumberOfSeeds()),
      parameter(setting::coverage, settings.coverage)};
  for (Report::Parameter& each : groupingParametersOf(settings, parameters))
    list.push_back(std::move(each));
  return list;
}

std::vector<Report::Parameter>
groupingParametersOf(const Settings& settings, const CIDParameters& parameters)
{
  std::vector<Report::Parameter> list{
      parameter(setting::samples, parameters.getNumberOfSamples()),
      parameter(setting::subsample, parameters.getSubsample()),
      parameter(setting::random_seed, parameters.getRandomSeed()),
      parameter(setting::start_index, settings.start_index),
      parameter(setting::scale, settings.scale),
      {"output_unit", output_unit_setting.wordOf(settings.output_unit)},
      parameter(setting::mesh_spacing, settings.mesh_spacing),
      parameter(setting::threads, parameters.getNumberOfThreads())};
  for (Report::Parameter& each : parametersOf(settings.raw_scan))
    list.push_back(std::move(each));
  return list;
}

} // namespace pcl_cid::tools
