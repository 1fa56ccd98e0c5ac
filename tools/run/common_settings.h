/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings that pcl_cid_segment and pcl_cid_abstract have in common.
 */

#pragma once

#include "command_line.h"
#include "many_scans.h"
#include "raw_scan_options.h"

#include <pcl_cid/cid_parameters.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/io/report.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

class Console;
struct LoadedScan;

/** \brief The row of `--label-type`. */
inline constexpr ChoiceSetting<LabelType, 3> label_type_setting{
    "Run",
    "label_type",
    "TYPE",
    LabelType::U4,
    {{{"U4", LabelType::U4}, {"I4", LabelType::I4}, {"F4", LabelType::F4}}},
    "type of the label field that is written: U4, I4 or F4"};

/** \brief The unit of coordinates in what is written beside scenes. */
enum class OutputUnit { file, metre };

inline constexpr ChoiceSetting<OutputUnit, 2> output_unit_setting{
    "Run",
    "output_unit",
    "UNIT",
    OutputUnit::file,
    {{{"file", OutputUnit::file}, {"metre", OutputUnit::metre}}},
    "with --scale, the unit of clouds, hulls and tables of seeds: that of the file, or "
    "the metre, which scenes for robot software and reports have anyhow"};

/** \brief Settings that tools share; what is not asked for is empty. */
struct Settings {
  std::string input;
  std::string output;
  std::string class_table; ///< of ScanNet; empty: looked for
  std::optional<int> seeds;
  std::optional<double> coverage;
  int samples = setting::samples.initial;
  int subsample = setting::subsample.initial;
  std::uint64_t random_seed = setting::random_seed.initial;
  std::optional<int> start_index;
  RawScanOptions raw_scan;
  unsigned int threads = setting::threads.initial;
  LabelType label_type = label_type_setting.initial;
  std::string report;
  double scale = setting::scale.initial;
  OutputUnit output_unit = output_unit_setting.initial;
  double mesh_spacing = setting::mesh_spacing.initial;
  std::optional<double> voxel; ///< its size; empty: all points are worked on
  std::string input_format;    ///< an extension without its dot; empty: INPUT says it
  std::string html;            ///< a picture of what was made
  bool keep_zeros = false;
  bool quiet = false;
  ManyScans many;

  /** \brief K: without `--seeds`, what `--coverage` needs, else the default. */
  int
  numberOfSeeds(std::size_t points) const;
};

/** \brief Declare the options that say how a scan is prepared and its points are
 *  grouped, whatever the seeds: the first ones below the headline that was begun, then
 *  those for raw scans. */
void
declareGroupingOptions(Settings& settings, CommandLine& line);

/** \brief Declare the options that say how many seeds are proposed, and those of
 *  declareGroupingOptions(). */
void
declareSeedOptions(Settings& settings, CommandLine& line);

/** \brief Declare `--class-table`, for an INPUT that may be a scan of ScanNet. */
void
declareClassTable(std::string& class_table, CommandLine& line);

/** \brief Begin the last headline, with what there is to say about how an input is
 *  read. */
void
declareReadingOptions(Settings& settings, CommandLine& line);

/** \brief Declare the options that stand last: threads, report, quiet. */
void
declareLastOptions(Settings& settings, CommandLine& line);

/** \brief Declare both, and the label type between them. */
void
declareRunOptions(Settings& settings, CommandLine& line);

/** \brief Hand the settings on to a class of the library.
 *  \throws CIDException when colors are wanted that the cloud does not have */
void
configure(const Settings& settings,
          const LoadedScan& scan,
          Console& console,
          CIDParameters& parameters);

/** \brief The same without those that say how many seeds are proposed. */
void
configureGrouping(const Settings& settings,
                  const LoadedScan& scan,
                  const ExecutionOptions& execution,
                  CIDParameters& parameters);

/** \brief The settings as they were used, for the report. */
std::vector<Report::Parameter>
parametersOf(const Settings& settings, const CIDParameters& parameters);

/** \brief The same without those that say how many seeds are proposed. */
std::vector<Report::Parameter>
groupingParametersOf(const Settings& settings, const CIDParameters& parameters);

} // namespace pcl_cid::tools
