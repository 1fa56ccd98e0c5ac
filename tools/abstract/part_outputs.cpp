/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts on their way into files: told of, written, read again, verified.
 */

#include "part_outputs.h"

#include "error_verification.h"
#include "hull_verification.h"
#include "mesh_output.h"
#include "picture/picture.h"
#include "primitive_verification.h"
#include "run/words.h"

#include <pcl_cid/core/hull_simplification.h>
#include <pcl_cid/io/mesh_export.h>

#include <optional>
#include <ostream>

namespace pcl_cid::tools {
namespace {

void
printParts(const AbstractedScan& result, const Console& console)
{
  double volume = 0.0;
  std::size_t thickened = 0;
  std::size_t boxed = 0;
  std::size_t trimmed = 0;
  for (std::size_t k = 0; k < result.parts.size(); ++k) {
    const ConvexPart& part = result.parts[k];
    trimmed += result.followed.empty() ? part.trimmed.size()
                                       : result.followed[k].trimmed_points;
    volume += part.volume;
    thickened += part.thickened ? 1 : 0;
    boxed += part.boxed ? 1 : 0;
  }
  console.value("Volume", shortNumber(volume) + " cubic metres");
  console.value("Thickened", std::to_string(thickened));
  if (boxed > 0)
    console.value("Boxes instead of hulls", std::to_string(boxed));
  if (trimmed > 0)
    console.value("Stray points trimmed", std::to_string(trimmed));
  if (result.dropped_points > 0)
    console.value("Points in parts that were dropped, not covered",
                  std::to_string(result.dropped_points));
}

/** Tell the user and the report about the parts, which must outlive the report. */
void
describe(const AbstractSettings& settings, const AbstractedScan& result, Run& run)
{
  for (const Report::Parameter& each : partParametersOf(settings))
    run.report.parameters.push_back(each);
  run.report.parts = &result.parts;
  run.report.followed_parts = result.followed;
  run.report.dropped_points = result.dropped_points;
  if (!run.report.coverage.empty())
    run.console.value("Coverage", shortNumber(run.report.coverage.back()) + " metres");
  printParts(result, run.console);
  if (run.report.tightness)
    run.console.value("Hull concavity",
                      shortNumber(run.report.tightness->all.max_concavity) +
                          " metres, mean " +
                          shortNumber(run.report.tightness->all.mean_concavity));
}

void
writeLabels(const AbstractSettings& settings,
            const std::vector<ConvexPart>& parts,
            LabelledCloud cloud,
            OutputFiles& outputs)
{
  std::vector<std::uint32_t> labels(cloud.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const pcl::index_t point : parts[i].indices)
      labels[static_cast<std::size_t>(point)] = static_cast<std::uint32_t>(i + 1);
  setLabels(labels, settings.label_type, cloud);
  writeScan(settings.labels, cloud, settings.output_unit, outputs);
}

SceneDescription
save(const AbstractSettings& settings,
     const AbstractedScan& result,
     const LoadedScan& scan,
     Run& run)
{
  run.begin("Saving " + settings.output);
  saveMesh(settings.output,
           result.parts,
           scan.points.metres_per_unit,
           settings.scenes.name,
           run.outputs);
  if (!settings.labels.empty() && !settings.voxel) // with it, they are there already
    writeLabels(settings, result.parts, scan.cloud, run.outputs);
  if (!settings.tree.empty())
    run.outputs.write(settings.tree,
                      [&](std::ostream& s) { s << toJson(result.tree); });
  const SceneDescription scene =
      writeScenes(settings.scenes, scan.name, result.parts, result.primitives, run);
  run.end(std::to_string(result.parts.size()) + " parts", "save");
  return scene;
}

/** Check what hulls guarantee on the meshes as they are on the disk. */
void
verify(const AbstractSettings& settings,
       const Verification& verification,
       const SceneDescription& scene,
       Run& run)
{
  run.begin("Verifying " + settings.output);
  verifyMesh(settings.output, verification, run.outputs);
  if (const std::string folder = settings.scenes.partsFolder(); !folder.empty())
    verifyParts(folder, scene, verification, run.outputs);
  for (const SceneFile& file : settings.scenes.wanted()) {
    verifyMeshesOf(file, scene, verification, run.outputs);
    if (settings.scenes.primitives && file.format.read_primitives)
      verifyPrimitives(file, scene, verification, run.outputs);
  }
  run.end("all guarantees hold", "verify");
}

/** What checks the bound on the error. */
std::optional<ErrorVerification>
errorVerification(const AbstractSettings& settings,
                  const CloudPoints& points,
                  const Viewpoints& viewpoints)
{
  if (!settings.max_error)
    return std::nullopt;
  return std::optional<ErrorVerification>(
      std::in_place,
      points,
      paddedBound(*settings.max_error, settings.hulls.padding),
      viewpoints);
}

} // namespace

void
requireOutputsCanHold(const AbstractSettings& settings,
                      const LoadedScan& scan,
                      Run& run)
{
  requireRoomForFloat(settings.output, scan, settings.hulls.min_thickness);
  if (!settings.labels.empty() && !settings.voxel)
    requireOutputHolds(settings.labels, scan, run);
  requirePictureOf(settings.html, scan);
}

void
writeParts(const AbstractSettings& settings,
           const Viewpoints& viewpoints,
           const AbstractedScan& abstracted,
           const LoadedScan& scan,
           const ShowParts& show,
           Run& run)
{
  describe(settings, abstracted, run);
  const SceneDescription scene = save(settings, abstracted, scan, run);
  if (settings.verify) {
    const std::optional<ErrorVerification> error =
        errorVerification(settings, scan.points, viewpoints);
    verify(settings,
           {abstracted,
            scan.points.frame,
            show,
            scan.points.metres_per_unit,
            error ? &*error : nullptr},
           scene,
           run);
  }
  savePicture(settings.html, pictureOf(abstracted.parts), scan, run);
  run.finish(settings.report);
}

} // namespace pcl_cid::tools
