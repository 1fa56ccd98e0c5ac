/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scenes for robot software that pcl_cid_abstract writes beside its mesh.
 */

#include "scene_outputs.h"

#include "run/words.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>

namespace pcl_cid::tools {
namespace {

namespace fs = std::filesystem;

/** Options of the formats with a property.
 *  \param[in] prefix goes before each of them */
std::vector<std::string>
optionsWith(bool SceneFormat::*property,
            const SceneSettings& settings,
            const std::string& prefix = "")
{
  std::vector<std::string> options;
  for (const SceneFile& scene : settings.files)
    if (scene.format.*property)
      options.push_back(prefix + scene.format.option);
  return options;
}

std::vector<std::string>
meshFormatWords()
{
  return withoutDots(partMeshExtensions());
}

/** What the settings say; the origin is that of the file. Scenes always have a name,
 *  meshes alone have that which is asked for. */
SceneDescription
descriptionOf(const SceneSettings& settings, const std::string& scan)
{
  SceneDescription description;
  description.name = settings.name;
  if (settings.name.empty() && !settings.wanted().empty())
    description.name = partsNameFrom(scan);
  description.frame = settings.frame;
  description.mesh_folder = settings.mesh_prefix;
  description.mesh_extension = "." + settings.parts_format;
  return description;
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

/** Let go of parts that this run does not have, and of those in another format. */
void
announceOldParts(const std::string& folder,
                 const SceneDescription& scene,
                 OutputFiles& outputs)
{
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (isPartFileName(entry.path().filename().string(), scene.name))
      outputs.announceRemoval(entry.path().string());
}

void
writeParts(const std::string& folder,
           const std::vector<ConvexPart>& parts,
           const SceneDescription& scene,
           OutputFiles& outputs)
{
  announceOldParts(folder, scene, outputs);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (primitiveOf(i, scene))
      continue;
    const std::string path = fs::path(folder) / partFileName(i, scene);
    outputs.announce(path);
    outputs.write(path, [&](std::ostream& s) { writePartMesh(s, parts, i, scene); });
  }
}

void
describe(const SceneDescription& scene, Run& run)
{
  const std::string origin = wholeNumbers(scene.origin);
  if (!scene.origin.isZero())
    run.console.value("Origin of the parts' meshes", origin + " metres");
  run.report.parameters.push_back({"name", scene.name});
  run.report.parameters.push_back({"frame", linkName(scene)});
  run.report.parameters.push_back({"meshes_origin", origin});
}

/** Errors get the name of an option. */
template <typename Check>
void
checkFor(const std::string& option, const Check& check)
{
  try {
    check();
  }
  catch (const CIDException& error) {
    throw UsageError("--" + option + ": " + error.what());
  }
}

/** Where the meshes of the parts go, and in what format. */
void
declareMeshOptions(SceneSettings& settings, CommandLine& line)
{
  constexpr auto refers = &SceneFormat::refers_to_meshes;
  line.text("parts-dir",
            "DIR",
            settings.parts_dir,
            "write the mesh of each part to this folder, made when missing: "
            "NAME_part_000.obj, ...; part files of that name of an earlier run in it "
            "go; default with " +
                alternatives(optionsWith(refers, settings, "--")) +
                ": FILE_parts beside the first of them");
  line.word("parts-format",
            "F",
            meshFormatWords(),
            settings.parts_format,
            "format of these meshes: " + alternatives(meshFormatWords()));
  line.text("mesh-prefix",
            "PREFIX",
            settings.mesh_prefix,
            "what stands before the names of these meshes in scenes: a folder, or, in "
            "URDF and SDF, a URI such as package://my_robot/meshes; default: the path "
            "to the folder from the scene");
  std::vector<std::string> asking = optionsWith(refers, settings);
  line.require("mesh-prefix", asking);
  asking.insert(asking.begin(), "parts-dir");
  line.require("parts-format", asking);
}

} // namespace

SceneSettings::SceneSettings()
: parts_format(SceneDescription().mesh_extension.substr(1))
{
  for (const SceneFormat& format : sceneFormats())
    files.push_back({format, ""});
}

std::string
SceneSettings::partsFolder() const
{
  if (!parts_dir.empty())
    return parts_dir;
  for (const SceneFile& scene : wanted())
    if (scene.format.refers_to_meshes)
      return fs::path(scene.path).replace_extension().string() + "_parts";
  return "";
}

std::vector<SceneFile>
SceneSettings::wanted() const
{
  std::vector<SceneFile> scenes;
  for (const SceneFile& scene : files)
    if (!scene.path.empty())
      scenes.push_back(scene);
  return scenes;
}

std::vector<HullPrimitive::Kind>
SceneSettings::primitiveKinds() const
{
  std::vector<HullPrimitive::Kind> kinds = PrimitiveOptions().kinds;
  for (const SceneFile& scene : wanted()) {
    const std::vector<HullPrimitive::Kind>& known = scene.format.primitives;
    if (known.empty() && !scene.format.refers_to_meshes)
      continue;
    const auto is_unknown = [&](HullPrimitive::Kind kind) {
      return std::find(known.begin(), known.end(), kind) == known.end();
    };
    kinds.erase(std::remove_if(kinds.begin(), kinds.end(), is_unknown), kinds.end());
  }
  return kinds;
}

void
declareSceneOptions(SceneSettings& settings, CommandLine& line)
{
  line.group("Scenes for robot software (a mesh for each part)");
  line.text("name",
            "NAME",
            settings.name,
            "before the names of all parts, so that scenes of different names can be "
            "loaded together: letters, digits and underscores; default in scenes: the "
            "name of INPUT, elsewhere none");
  declareMeshOptions(settings, line);
  for (SceneFile& scene : settings.files)
    line.file(scene.format.option,
              "FILE" + scene.format.extensions.front(),
              scene.format.extensions,
              scene.path,
              scene.format.help);
  line.text("frame",
            "NAME",
            settings.frame,
            "the cloud's frame: the link in URDF and SDF; default NAME");
  line.require("frame", optionsWith(&SceneFormat::names_frame, settings));
  line.flag(
      "primitives",
      settings.primitives,
      "a box, a sphere, a cylinder or, where all formats with any know it, a capsule "
      "instead of the mesh of a part that it holds, when it is at most " +
          shortNumber(100.0 * primitive_share) + " % larger than its hull");
  std::vector<std::string> scenes;
  for (const SceneFile& scene : settings.files)
    if (!scene.format.primitives.empty())
      scenes.push_back(scene.format.option);
  line.require("primitives", scenes);
}

void
checkSceneOptions(const SceneSettings& settings)
{
  if (settings.primitives && settings.primitiveKinds().empty())
    throw UsageError("--primitives: one of the scenes is of a format without any");
  if (!settings.name.empty())
    checkFor("name", [&] { requirePartsName(settings.name); });
  for (const SceneFile& scene : settings.wanted())
    if (scene.format.check)
      checkFor(scene.format.option,
               [&] { scene.format.check(descriptionOf(settings, "scan")); });
}

void
announceScenes(const SceneSettings& settings, OutputFiles& outputs)
{
  const std::string folder = settings.partsFolder();
  if (!folder.empty())
    outputs.announceFolder(folder);
  for (const SceneFile& scene : settings.wanted())
    outputs.announce(scene.path);
}

SceneDescription
writeScenes(const SceneSettings& settings,
            const std::string& scan,
            const std::vector<ConvexPart>& parts,
            const std::vector<std::optional<HullPrimitive>>& primitives,
            Run& run)
{
  const std::string folder = settings.partsFolder();
  const std::vector<SceneFile> scenes = settings.wanted();
  SceneDescription description = descriptionOf(settings, scan);
  if (folder.empty() && scenes.empty())
    return description;
  description.origin = sceneOrigin(parts);
  description.primitives = primitives;
  if (!folder.empty())
    writeParts(folder, parts, description, run.outputs);
  for (const SceneFile& scene : scenes) {
    if (scene.format.refers_to_meshes && settings.mesh_prefix.empty())
      description.mesh_folder = meshFolderFrom(scene.path, folder);
    run.outputs.write(scene.path, [&](std::ostream& s) {
      scene.format.write(s, parts, description);
    });
  }
  describe(description, run);
  return description;
}

} // namespace pcl_cid::tools
