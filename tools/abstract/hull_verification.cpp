/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --verify: the guarantees of the hulls, checked on what is in the files.
 */

#include "hull_verification.h"

#include "file_points.h"

#include <pcl_cid/core/hull_guarantees.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <unordered_map>
#include <utility>

namespace pcl_cid::tools {
namespace {

/** A hull from a file, metres. */
struct StoredHull {
  TriangleMesh mesh;
  double rounding; ///< what the file has taken from its coordinates
};

StoredHull
inMetres(TriangleMesh mesh, bool is_float, double metres_per_unit)
{
  const double rounding = is_float ? metres_per_unit * floatRounding(mesh) : 0.0;
  for (Eigen::Vector3d& v : mesh.vertices)
    v *= metres_per_unit;
  return {std::move(mesh), rounding};
}

/** Some consecutive triangles of a mesh, as a mesh of its own. */
TriangleMesh
piece(const TriangleMesh& mesh, std::size_t first, std::size_t count)
{
  TriangleMesh part;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  for (std::size_t t = first; t < std::min(first + count, mesh.triangles.size()); ++t) {
    std::array<std::uint32_t, 3> triangle = mesh.triangles[t];
    for (std::uint32_t& v : triangle) {
      const auto next = static_cast<std::uint32_t>(part.vertices.size());
      const auto [known, is_new] = number.emplace(v, next);
      if (is_new)
        part.vertices.push_back(mesh.vertices[v]);
      v = known->second;
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

/** The parts of a mesh that does not keep them apart, such as an STL, by their numbers
 *  of triangles. */
std::vector<TriangleMesh>
splitIntoParts(const TriangleMesh& mesh, const std::vector<ConvexPart>& parts)
{
  std::vector<TriangleMesh> hulls;
  std::size_t first = 0;
  for (const ConvexPart& part : parts) {
    hulls.push_back(piece(mesh, first, part.hull.triangles.size()));
    first += part.hull.triangles.size();
  }
  if (first != mesh.triangles.size())
    throw CIDException("it has " + std::to_string(mesh.triangles.size()) +
                       " triangles; the parts have " + std::to_string(first));
  return hulls;
}

/** One hull for each part, from an output that is not committed yet. */
std::vector<StoredHull>
readHulls(const std::string& path,
          const std::vector<ConvexPart>& parts,
          double metres_per_unit,
          OutputFiles& outputs)
{
  const MeshFormat& format = meshFormatOf(path);
  if (!format.read)
    throw CIDException("nothing reads " + format.name + " again");
  std::vector<TriangleMesh> meshes = format.read(outputs.pathBeforeCommit(path));
  if (!format.has_parts)
    meshes = splitIntoParts(meshes.front(), parts);
  if (meshes.size() != parts.size())
    throw CIDException("it has " + std::to_string(meshes.size()) +
                       " hulls; it must have " + std::to_string(parts.size()));
  std::vector<StoredHull> hulls;
  for (TriangleMesh& mesh : meshes)
    hulls.push_back(inMetres(std::move(mesh), format.is_float, metres_per_unit));
  return hulls;
}

/** The points of a part, as they stand in the file, in the frame of a mesh. */
std::vector<Eigen::Vector3d>
pointsOf(const ConvexPart& part,
         const FileCoordinates& coordinates,
         const Frame& mesh_frame)
{
  std::vector<Eigen::Vector3d> inside;
  inside.reserve(part.indices.size());
  for (const pcl::index_t index : part.indices)
    inside.push_back(mesh_frame.toLocal(coordinates[static_cast<std::size_t>(index)]));
  return inside;
}

/** A mesh in the frame of the points. */
TriangleMesh
inFrameOf(const Frame& points, TriangleMesh mesh, const Frame& mesh_frame)
{
  for (Eigen::Vector3d& v : mesh.vertices)
    v = points.toLocal(mesh_frame.toFile(v));
  return mesh;
}

void
verifyHull(std::size_t number,
           const StoredHull& hull,
           const Frame& mesh_frame,
           const Verification& verification)
{
  const ConvexPart& part = verification.abstracted.parts[number];
  const double rounding =
      roundingOf(part.indices, verification.points, verification.coordinates);
  const auto broken =
      findBrokenGuarantee(hull.mesh,
                          pointsOf(part, verification.coordinates, mesh_frame),
                          verification.abstracted.optionsOf(number),
                          hull.rounding + std::min(rounding, unnoticed_rounding));
  const auto too_far = verification.error && !broken
                           ? verification.error->findTooFar(inFrameOf(
                                 verification.points.frame, hull.mesh, mesh_frame))
                           : std::nullopt;
  if (broken || too_far)
    throw CIDException("the hull of " + partName(number) +
                       " breaks a guarantee: " + (broken ? *broken : *too_far));
}

/** Check a file; errors get the name that the user knows it by. */
template <typename Work>
void
check(const std::string& path, const Work& work)
{
  try {
    work();
  }
  catch (const CIDException& error) {
    throw CIDException(path + ": verification: " + error.what());
  }
}

} // namespace

void
verifyMesh(const std::string& path,
           const Verification& verification,
           OutputFiles& outputs)
{
  check(path, [&] {
    const std::vector<StoredHull> hulls = readHulls(path,
                                                    verification.abstracted.parts,
                                                    verification.points.metres_per_unit,
                                                    outputs);
    for (std::size_t k = 0; k < hulls.size(); ++k)
      verifyHull(k, hulls[k], Frame(), verification);
  });
}

void
verifyParts(const std::string& folder,
            const SceneDescription& scene,
            const Verification& verification,
            OutputFiles& outputs)
{
  for (std::size_t k = 0; k < verification.abstracted.parts.size(); ++k) {
    if (primitiveOf(k, scene))
      continue;
    const std::string path = std::filesystem::path(folder) / partFileName(k, scene);
    check(path, [&] {
      const std::vector<StoredHull> hulls =
          readHulls(path, {verification.abstracted.parts[k]}, 1.0, outputs);
      verifyHull(k, hulls.front(), Frame{scene.origin}, verification);
    });
  }
}

void
verifyMeshesOf(const SceneFile& file,
               const SceneDescription& scene,
               const Verification& verification,
               OutputFiles& outputs)
{
  if (!file.format.read_meshes)
    return;
  check(file.path, [&] {
    std::ifstream stream(outputs.pathBeforeCommit(file.path), std::ios::binary);
    const NamedMeshes meshes = file.format.read_meshes(stream);
    std::size_t expected = 0;
    for (std::size_t k = 0; k < verification.abstracted.parts.size(); ++k) {
      if (!file.format.primitives.empty() && primitiveOf(k, scene))
        continue;
      ++expected;
      const auto found = meshes.find(partName(k, scene.name));
      if (found == meshes.end())
        throw CIDException("the mesh of " + partName(k) + " is missing");
      const PlacedMesh& placed = found->second;
      verifyHull(k,
                 inMetres(placed.mesh, file.format.is_float, 1.0),
                 Frame{placed.origin},
                 verification);
    }
    if (meshes.size() != expected)
      throw CIDException("it has " + std::to_string(meshes.size()) +
                         " meshes; it must have " + std::to_string(expected));
  });
}

} // namespace pcl_cid::tools
