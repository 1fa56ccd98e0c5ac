/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_abstract is told: its settings and its command line.
 */

#pragma once

#include "scene_outputs.h"
#include "tool_run.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/hull_tightness.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/report.h>

#include <optional>
#include <string>

namespace pcl_cid::tools {

constexpr const char* abstract_tool = "pcl_cid_abstract";

/** \brief Settings of pcl_cid_abstract; what is not asked for is empty. */
struct AbstractSettings : Settings {
  std::optional<int> parts;
  std::optional<double> threshold;
  std::optional<int> merges;
  int group_samples = 32;
  int min_points = 1;
  ConvexPartOptions hulls;
  std::optional<int> max_vertices;
  double free_distance = TightnessOptions().free_distance;
  bool verify = false;
  std::string labels;
  std::string tree;
  std::string curve;
  SceneSettings scenes;

  bool
  isOBJ() const
  {
    return extensionOf(output) == ".obj";
  }

  /** \brief The material library beside an OBJ. */
  std::string
  materials() const;
};

/** \brief Read the command line, or answer `--help` and `--version`.
 *  \return whether there is work to do
 *  \throws UsageError */
bool
readCommandLine(int argc, const char* const* argv, AbstractSettings& settings);

/** \brief Announce all that will be written. */
void
announceOutputs(const AbstractSettings& settings, OutputFiles& outputs);

/** \brief Tell the report the settings of parts and hulls. */
void
addParameters(const AbstractSettings& settings, Report& report);

} // namespace pcl_cid::tools
