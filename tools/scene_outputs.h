/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scenes for robot software that pcl_cid_abstract writes beside its mesh.
 */

#pragma once

#include "tool_run.h"

#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scene_export.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief Which scenes to write; what is not asked for is empty. */
struct SceneSettings {
  std::string parts_dir;
  std::size_t parts_format = 0; ///< as in partMeshExtensions()
  std::string urdf;
  std::string sdf;
  std::string mjcf;
  std::string moveit;
  std::string frame = SceneDescription().frame;

  /** \brief Where the meshes of the parts go: `--parts-dir`, else "NAME_parts" beside
   *  the first of the scenes that refer to them, NAME being its name without extension;
   *  empty when nothing asks for meshes. */
  std::string
  partsFolder() const;
};

void
declareSceneOptions(SceneSettings& settings, CommandLine& line);

/** \brief Refuse names of the wrong kind.
 *  \throws UsageError */
void
checkSceneOptions(const SceneSettings& settings);

/** \brief Announce the scenes and the folder of the parts; first of all outputs, as
 *  others may be in that folder. */
void
announceScenes(const SceneSettings& settings, OutputFiles& outputs);

/** \brief Write the scenes and the meshes of the parts; what an earlier run left in
 *  their folder goes with the commit. An origin that was subtracted from the meshes is
 *  told to the user and the report.
 *  \return with the origin and the format of the meshes */
SceneDescription
writeScenes(const SceneSettings& settings,
            const std::vector<ConvexPart>& parts,
            const Console& console,
            OutputFiles& outputs,
            Report& report);

} // namespace pcl_cid::tools
