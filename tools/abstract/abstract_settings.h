/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_abstract is told: its settings and its command line.
 */

#pragma once

#include "run/common_settings.h"
#include "scene_outputs.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/report.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

constexpr const char* abstract_tool = "pcl_cid_abstract";

/** \brief Settings of pcl_cid_abstract; what is not asked for is empty. */
struct AbstractSettings : Settings {
  std::optional<int> parts;
  std::optional<double> threshold;
  std::optional<int> merges;
  std::optional<MergingRule> merging;
  std::optional<double> max_error;
  std::optional<double> robot_radius;
  std::string viewpoints; ///< a file, or `cloud` for the pose of the cloud
  std::optional<GroupRule> groups;
  int group_samples = setting::group_samples.initial;
  int min_points = setting::min_points.initial;
  ConvexPartOptions hulls;
  std::optional<int> max_vertices;
  bool fewest_vertices = false; ///< --max-vertices auto
  double free_distance = setting::free_distance.initial;
  bool strict = false;
  bool verify = false;
  std::string session; ///< of pcl_cid_studio, whose parts are taken
  std::string labels;
  std::string tree;
  std::string curve;
  SceneSettings scenes;

  /** \brief Without `--merging`, by hull where nothing but hulls is asked for. */
  MergingRule
  mergingRule() const;

  GroupRule
  groupRule() const
  {
    return groups.value_or(setting::groups.initial);
  }

  ConvexPartOptions
  hullOptions() const;

  /** \brief The bound on the error that the hulls of the points that are worked on must
   *  keep, so that those of all points keep `--max-error`; there is one. */
  double
  fittedError() const;

  /** \brief Whether anything is said or asked about groups, which merging by hull has
   *  none of. */
  bool
  isAboutGroups() const;
};

/** \brief Begin the headline of hulls, with the options that say how they are made. */
void
declareHullOptions(AbstractSettings& settings, CommandLine& line);

/** \brief Read the command line, or answer `--help` and `--version`.
 *  \return whether there is work to do
 *  \throws UsageError */
bool
readCommandLine(int argc, const char* const* argv, AbstractSettings& settings);

/** \brief The options that name files of each scan, of several. */
std::vector<NameOption>
nameOptions(AbstractSettings& settings);

/** \brief Whether viewpoints are in a file. */
bool
hasViewpointFile(const AbstractSettings& settings);

/** \brief All files that are read, which outputs must never be written over. */
std::vector<std::string>
inputsOf(const AbstractSettings& settings);

/** \brief Announce all that will be written. */
void
announceOutputs(const AbstractSettings& settings, OutputFiles& outputs);

/** \brief The settings of parts and hulls as they were used, for the report. */
std::vector<Report::Parameter>
partParametersOf(const AbstractSettings& settings);

} // namespace pcl_cid::tools
