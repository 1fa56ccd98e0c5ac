/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scenes for robot software that pcl_cid_abstract writes beside its mesh.
 */

#pragma once

#include "run/command_line.h"
#include "run/run.h"

#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scene_export.h>
#include <pcl_cid/io/scene_formats.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief The file of a scene. */
struct SceneFile {
  SceneFormat format;
  std::string path; ///< empty: it is not asked for
};

/** \brief Which scenes to write; what is not asked for is empty. */
struct SceneSettings {
  /** One for each format in the table, in its order. */
  SceneSettings();

  /** \brief Where the meshes of the parts go: `--parts-dir`, else "NAME_parts" beside
   *  the first of the scenes that refer to them, NAME being its name without extension;
   *  empty when nothing asks for meshes. */
  std::string
  partsFolder() const;

  /** \brief The scenes that are asked for. */
  std::vector<SceneFile>
  wanted() const;

  /** \brief The primitives that all of these know, but for those that know none and
   *  hold meshes themselves: these have the hulls. */
  std::vector<HullPrimitive::Kind>
  primitiveKinds() const;

  std::vector<SceneFile> files;
  std::string name; ///< of all parts; empty: that of the scan, in scenes
  std::string
      mesh_prefix; ///< what scenes name the folder of the meshes; empty: its path
  std::string parts_dir;
  std::string parts_format; ///< extension of the meshes, without the dot
  std::string frame;        ///< empty: the name
  bool primitives = false;  ///< instead of the meshes of parts that are nearly such
};

/** \brief Declare an option for each format of scenes, and those for the meshes that
 *  they refer to. */
void
declareSceneOptions(SceneSettings& settings, CommandLine& line);

/** \brief Refuse names of the wrong kind, and what a format cannot hold.
 *  \throws UsageError */
void
checkSceneOptions(const SceneSettings& settings);

/** \brief Announce the scenes and the folder of the parts: before all other outputs,
 *  which may be in that folder. */
void
announceScenes(const SceneSettings& settings, OutputFiles& outputs);

/** \brief Write the scenes and the meshes of the parts; what an earlier run of the same
 *  name left in their folder goes with the commit. An origin that was subtracted from
 *  the meshes is told to the user and the report.
 *  \param[in] scan its name, for scenes that were given none
 *  \param[in] primitives what stands for each part; empty: nothing does
 *  \return with the origin and the format of the meshes */
SceneDescription
writeScenes(const SceneSettings& settings,
            const std::string& scan,
            const std::vector<ConvexPart>& parts,
            const std::vector<std::optional<HullPrimitive>>& primitives,
            Run& run);

} // namespace pcl_cid::tools
