/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the tools share: settings, messages, progress, how a run ends.
 */

#pragma once

#include "command_line.h"
#include "raw_scan_options.h"

#include <pcl_cid/cid_parameters.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/report.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief Settings that both tools have. */
struct Settings {
  std::string input;
  std::string output;
  std::string class_table; ///< of ScanNet; empty: looked for
  std::optional<int> seeds;
  std::optional<double> coverage;
  int samples = 100;
  int subsample = 0;
  std::uint64_t random_seed = 0;
  std::optional<int> start_index;
  RawScanOptions raw_scan;
  unsigned int threads = 0;
  std::size_t label_type = 0; ///< as in LabelType
  std::string report;
  bool quiet = false;

  /** \brief K: without `--seeds`, what `--coverage` needs, else 100. */
  int
  numberOfSeeds(std::size_t points) const;

  LabelType
  labelType() const
  {
    return static_cast<LabelType>(label_type);
  }
};

/** \brief Declare the options that say how seeds are proposed, those for raw scans
 *  among them. */
void
declareSeedOptions(Settings& settings, CommandLine& command_line);

/** \brief Declare `--class-table`, for an INPUT that may be a scan of ScanNet. */
void
declareClassTable(std::string& class_table, CommandLine& command_line);

/** \brief Declare the options that stand last: class table, label type, threads,
 *  report, quiet. */
void
declareRunOptions(Settings& settings, CommandLine& command_line);

/** \brief Refuse a file name of another kind.
 *  \param[in] name what the user calls it: OUTPUT, --labels
 *  \throws UsageError */
void
requireExtension(const std::string& name,
                 const std::string& path,
                 const std::vector<std::string>& extensions);

/** \brief The extension in small letters, with the dot. */
std::string
extensionOf(const std::string& path);

/** \brief Messages in the look of PCL's tools: results to the standard output, the
 *  progress bar to a terminal. */
class Console {
public:
  explicit Console(bool quiet);

  /** \brief Begin a step of the run.
   *  \throws Interrupted */
  void
  begin(const std::string& step);

  /** \brief End it: "> Loading room.pcd [done, 12 ms : 3400 points]".
   *  \param[in] result "3400 points"
   *  \param[in] name of its seconds in the report */
  void
  end(const std::string& result, const std::string& name, Report& report);

  /** \brief Something that the user should know about the input, to the standard
   *  error. */
  void
  remark(const std::string& sentence) const;

  /** \brief "Coverage: 0.05 metres". */
  void
  value(const std::string& name, const std::string& value) const;

  /** \brief For the library: draws the bar, and cancels when the run is interrupted. */
  ProgressCallback
  progress();

private:
  void
  drawBar(double fraction);

  void
  eraseBar();

  bool quiet_;
  bool has_terminal_;
  bool bar_drawn_ = false;
  std::string step_;
  std::chrono::steady_clock::time_point begun_;
};

/** \brief The user, or the system, asked the run to end. */
class Interrupted : public std::exception {};

/** \brief What to tell the user, and what to do about it. */
std::string
messageOf(const std::exception& error);

/** \brief The files of the input, which outputs must never be written over. */
std::vector<std::string>
inputFiles(const Settings& settings);

/** \brief Load the input and its points, with messages; remarks on it go to the user
 *  and the report.
 *  \throws CIDException when it has no finite point */
LabelledCloud
loadCloud(const Settings& settings,
          Console& console,
          Report& report,
          CloudPoints& points);

/** \brief Hand the settings on to a class of the library.
 *  \throws CIDException when colours are wanted that the cloud does not have */
void
configure(const Settings& settings,
          const LabelledCloud& cloud,
          const CloudPoints& points,
          Console& console,
          CIDParameters& parameters);

/** \brief The settings as they were used, for the report. */
std::vector<Report::Parameter>
parametersOf(const Settings& settings, const CIDParameters& parameters);

/** \brief A number for the user, 4 digits. */
std::string
shortNumber(double value);

/** \brief "91.25 %". */
std::string
percent(double share);

/** \brief Run a tool: exceptions become messages and exit codes.
 *  \param[in] work returns when all is done
 *  \return 0; 1 when the work failed; 2 when the command line is wrong; 128 + the
 * signal when one ended the run */
int
runTool(const std::string& tool, const std::function<void()>& work);

} // namespace pcl_cid::tools
