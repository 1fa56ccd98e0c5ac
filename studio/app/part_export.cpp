/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts of a session in files, as pcl_cid_abstract writes them.
 */

#include "part_export.h"

#include "abstract/part_outputs.h"
#include "abstract/session_parts.h"
#include "run/words.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/mesh_formats.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace pcl_cid::studio {
namespace {

namespace fs = std::filesystem;
using tools::AbstractSettings;
using tools::SceneFile;

/** \throws CIDException when it is none of these */
void
requireOneOf(const std::string& word,
             const std::vector<std::string>& words,
             const std::string& what)
{
  if (std::find(words.begin(), words.end(), word) == words.end())
    throw CIDException("there is no format '" + word + "' of " + what + "; there are " +
                       tools::alternatives(words));
}

/** Ask for a scene beside the mesh. */
void
addScene(const std::string& option, const std::string& path, AbstractSettings& settings)
{
  std::vector<std::string> options;
  for (SceneFile& file : settings.scenes.files) {
    options.push_back(file.format.option);
    const std::string extension = file.format.extensions.front();
    if (file.format.option == option)
      file.path = path + (extension == "." + option ? "" : "_" + option) + extension;
  }
  requireOneOf(option, options, "scenes");
}

/** \throws CIDException for scenes that cannot be written so */
void
requirePossible(const tools::SceneSettings& scenes)
{
  try {
    tools::checkSceneOptions(scenes);
  }
  catch (const tools::UsageError& error) {
    throw CIDException(error.what());
  }
}

std::vector<std::string>
filesOf(const AbstractSettings& settings)
{
  std::vector<std::string> files{settings.output};
  for (const std::string& path : {materialsBeside(settings.output),
                                  settings.scenes.partsFolder(),
                                  settings.labels,
                                  settings.report})
    if (!path.empty())
      files.push_back(path);
  for (const SceneFile& scene : settings.scenes.wanted())
    files.push_back(scene.path);
  return files;
}

} // namespace

std::vector<std::string>
partMeshes()
{
  std::vector<std::string> extensions;
  for (const MeshFormat& format : meshFormats())
    if (format.read)
      extensions.push_back(format.extensions.front());
  return tools::withoutDots(std::move(extensions));
}

PartExporter::PartExporter(const tools::LoadedScan& scan,
                           const AbstractSettings& settings,
                           std::vector<std::string> inputs,
                           std::string folder,
                           std::string name)
: scan_(scan)
, settings_(settings)
, inputs_(std::move(inputs))
, folder_(std::move(folder))
, name_(std::move(name))
{
}

AbstractSettings
PartExporter::settingsFor(const PartExport& wanted) const
{
  const std::string file = wanted.name.empty() ? name_ + "_parts" : wanted.name;
  requireFileName(file);
  const std::string path = (fs::path(folder_) / file).string();
  AbstractSettings settings = settings_;
  requireOneOf(wanted.mesh, partMeshes(), "meshes");
  settings.output = path + "." + wanted.mesh;
  for (const std::string& scene : wanted.scenes)
    addScene(scene, path, settings);
  settings.scenes.primitives = wanted.primitives;
  requirePossible(settings.scenes);
  if (!wanted.labels.empty()) {
    requireOneOf(
        wanted.labels, tools::withoutDots(writableCloudExtensions()), "labels");
    settings.labels = path + "_labels." + wanted.labels;
  }
  if (wanted.report)
    settings.report = path + "_report.json";
  settings.verify = true;
  settings.quiet = true;
  return settings;
}

ExportedFiles
PartExporter::write(const PartSession& session, const PartExport& wanted) const
{
  const AbstractSettings settings = settingsFor(wanted);
  tools::Run run(tools::abstract_tool, settings.quiet, inputs_);
  announceOutputs(settings, run.outputs);
  requireOutputsCanHold(settings, scan_, run);
  const tools::AbstractedScan abstracted =
      abstractChosenParts(settings, session, scan_, run);
  writeParts(settings,
             {},
             abstracted,
             scan_,
             tools::pointsOfParts(scan_.cloud, abstracted.parts),
             run);
  return {filesOf(settings), run.report.remarks};
}

} // namespace pcl_cid::studio
