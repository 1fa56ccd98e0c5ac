/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The meshes that scenes refer to, one for each part.
 */

#include "text/numbers.h"
#include "text/path_names.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>
#include <pcl_cid/io/scene_export.h>

#include <algorithm>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

/** The format of an extension in which scenes refer to meshes. */
const MeshFormat&
partMeshFormat(const std::string& extension)
{
  const std::vector<std::string> known = partMeshExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end())
    throw CIDException("the mesh of a part is written as " + listed(known) + ", not '" +
                       extension + "'");
  return meshFormatOf("mesh" + extension);
}

} // namespace

Eigen::Vector3d
sceneOrigin(const std::vector<ConvexPart>& parts)
{
  constexpr double far_away = 1000.0;
  Eigen::AlignedBox3d box;
  for (const ConvexPart& part : parts)
    for (const Eigen::Vector3d& vertex : part.hull.vertices)
      box.extend(vertex);
  if (box.isEmpty() ||
      box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff() <= far_away)
    return Eigen::Vector3d::Zero();
  return box.center().array().round();
}

TriangleMesh
meshInScene(const ConvexPart& part, const SceneDescription& scene)
{
  const Frame frame{scene.origin};
  TriangleMesh mesh = part.hull;
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = frame.toLocal(vertex);
  return mesh;
}

const HullPrimitive*
primitiveOf(std::size_t part, const SceneDescription& scene)
{
  const bool is_one = part < scene.primitives.size() && scene.primitives[part];
  return is_one ? &*scene.primitives[part] : nullptr;
}

std::string
partFileName(std::size_t part, const SceneDescription& scene)
{
  partMeshFormat(scene.mesh_extension);
  return partName(part, scene.name) + scene.mesh_extension;
}

bool
isPartFileName(const std::string& file, const std::string& name)
{
  const std::size_t dot = file.rfind('.');
  const std::size_t digits = partName(0, name).rfind('_') + 1;
  if (dot == std::string::npos || digits > dot)
    return false;
  const auto part = parseNumber<std::size_t>(file.substr(digits, dot - digits));
  const std::vector<std::string> extensions = partMeshExtensions();
  return part &&
         std::any_of(extensions.begin(), extensions.end(), [&](const auto& extension) {
           return file == partName(*part, name) + extension;
         });
}

void
writePartMesh(std::ostream& stream,
              const std::vector<ConvexPart>& parts,
              std::size_t part,
              const SceneDescription& scene)
{
  partMeshFormat(scene.mesh_extension)
      .write_mesh(stream, meshInScene(parts[part], scene), partName(part, scene.name));
}

} // namespace pcl_cid
