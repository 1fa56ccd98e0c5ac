/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scenes for robot software that pcl_cid_abstract writes beside its mesh.
 */

#include "scene_outputs.h"

#include <pcl_cid/io/mesh_formats.h>

#include <cmath>
#include <filesystem>
#include <ostream>

namespace pcl_cid::tools {
namespace {

namespace fs = std::filesystem;

/** A scene that is written. */
struct SceneOutput {
  const char* option;
  const std::string& path;
  std::vector<std::string> extensions;
  void (*write)(std::ostream&, const std::vector<ConvexPart>&, const SceneDescription&);
  bool needs_meshes; ///< refers to files in the folder of the parts
};

/** Those that are asked for. */
std::vector<SceneOutput>
scenesOf(const SceneSettings& settings)
{
  std::vector<SceneOutput> scenes;
  for (const SceneOutput& scene :
       {SceneOutput{"--urdf", settings.urdf, {".urdf"}, writeURDF, true},
        SceneOutput{"--sdf", settings.sdf, {".sdf"}, writeSDF, true},
        SceneOutput{"--mjcf", settings.mjcf, {".xml", ".mjcf"}, writeMJCF, true},
        SceneOutput{"--moveit", settings.moveit, {".scene"}, writeMoveItScene, false}})
    if (!scene.path.empty())
      scenes.push_back(scene);
  return scenes;
}

/** "524288 4194305 102": an origin has whole metres. */
std::string
wholeNumbers(const Eigen::Vector3d& v)
{
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    text += (axis == 0 ? "" : " ") + std::to_string(std::llround(v[axis]));
  return text;
}

/** The folder of the parts as seen from the file of a scene. */
std::string
meshFolderFrom(const std::string& scene, const std::string& parts_folder)
{
  const fs::path from = fs::weakly_canonical(fs::absolute(scene)).parent_path();
  const fs::path relative =
      fs::weakly_canonical(fs::absolute(parts_folder)).lexically_relative(from);
  return relative == "." ? std::string() : relative.string();
}

/** Let go of parts that this run does not have, and of those in the other format. */
void
announceOldParts(const std::string& folder, OutputFiles& outputs)
{
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (isPartFileName(entry.path().filename().string()))
      outputs.announceRemoval(entry.path().string());
}

void
writeParts(const std::string& folder,
           const std::vector<ConvexPart>& parts,
           const SceneDescription& scene,
           OutputFiles& outputs)
{
  announceOldParts(folder, outputs);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string path = fs::path(folder) / partFileName(i, scene.mesh_extension);
    outputs.announce(path);
    outputs.write(path, [&](std::ostream& s) { writePartMesh(s, parts, i, scene); });
  }
}

} // namespace

std::string
SceneSettings::partsFolder() const
{
  if (!parts_dir.empty())
    return parts_dir;
  for (const SceneOutput& scene : scenesOf(*this))
    if (scene.needs_meshes)
      return fs::path(scene.path).replace_extension().string() + "_parts";
  return "";
}

void
declareSceneOptions(SceneSettings& settings, CommandLine& line)
{
  line.group("Scenes for robot software (a mesh for each part)");
  line.text("parts-dir",
            "DIR",
            settings.parts_dir,
            "write the mesh of each part to this folder, made when missing: "
            "part_000.obj, ...; part files of an earlier run in it go; default with "
            "--urdf, --sdf or --mjcf: NAME_parts beside the first of them");
  line.choice("parts-format",
              "F",
              {"obj", "stl"},
              settings.parts_format,
              "format of these meshes: obj or stl");
  line.text("urdf", "FILE.urdf", settings.urdf, "write a URDF: one link");
  line.text("sdf", "FILE.sdf", settings.sdf, "write an SDF 1.9: a static model");
  line.text("mjcf", "FILE.xml", settings.mjcf, "write an MJCF for MuJoCo");
  line.text(
      "moveit", "FILE.scene", settings.moveit, "write a scene in MoveIt's text form");
  line.text("frame",
            "NAME",
            settings.frame,
            "the cloud's frame: the link in URDF and SDF; default " + settings.frame);
  line.require("parts-format", {"parts-dir", "urdf", "sdf", "mjcf"});
  line.require("frame", {"urdf", "sdf"});
}

void
checkSceneOptions(const SceneSettings& settings)
{
  for (const SceneOutput& scene : scenesOf(settings))
    requireExtension(scene.option, scene.path, scene.extensions);
  if (settings.sdf.empty())
    return;
  try {
    requireFrameForSDF(settings.frame);
  }
  catch (const CIDException& error) {
    throw UsageError("--frame: " + std::string(error.what()));
  }
}

void
announceScenes(const SceneSettings& settings, OutputFiles& outputs)
{
  const std::string folder = settings.partsFolder();
  if (!folder.empty())
    outputs.announceFolder(folder);
  for (const SceneOutput& scene : scenesOf(settings))
    outputs.announce(scene.path);
}

SceneDescription
writeScenes(const SceneSettings& settings,
            const std::vector<ConvexPart>& parts,
            const Console& console,
            OutputFiles& outputs,
            Report& report)
{
  const std::string folder = settings.partsFolder();
  const std::vector<SceneOutput> scenes = scenesOf(settings);
  SceneDescription description;
  if (folder.empty() && scenes.empty())
    return description;
  description.frame = settings.frame;
  description.origin = sceneOrigin(parts);
  description.mesh_extension = partMeshExtensions().at(settings.parts_format);
  if (!folder.empty())
    writeParts(folder, parts, description, outputs);
  for (const SceneOutput& scene : scenes) {
    if (scene.needs_meshes)
      description.mesh_folder = meshFolderFrom(scene.path, folder);
    outputs.write(scene.path,
                  [&](std::ostream& s) { scene.write(s, parts, description); });
  }
  const std::string origin = wholeNumbers(description.origin);
  if (!description.origin.isZero())
    console.value("Origin of the parts' meshes", origin + " metres");
  report.parameters.push_back({"frame", settings.frame});
  report.parameters.push_back({"meshes_origin", origin});
  return description;
}

} // namespace pcl_cid::tools
