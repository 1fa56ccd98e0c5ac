/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --verify: the guarantees of the hulls, checked on what is in the files.
 */

#include "hull_verification.h"

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
  std::size_t part;
  TriangleMesh mesh;
  double rounding; ///< what the file has taken from its coordinates
  std::string path;
  Frame frame = Frame();
};

StoredHull
inMetres(std::size_t part,
         TriangleMesh mesh,
         bool is_float,
         double metres_per_unit,
         const std::string& path)
{
  const double rounding = is_float ? metres_per_unit * floatRounding(mesh) : 0.0;
  for (Eigen::Vector3d& v : mesh.vertices)
    v *= metres_per_unit;
  return {part, std::move(mesh), rounding, path};
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

/** One hull for each part, from an output that is not committed yet.
 *  \param[in] first the number of the first of these parts */
std::vector<StoredHull>
readHulls(const std::string& path,
          std::size_t first,
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
    hulls.push_back(inMetres(
        first + hulls.size(), std::move(mesh), format.is_float, metres_per_unit, path));
  return hulls;
}

/** A mesh in the frame of the points. */
TriangleMesh
inFrameOf(const Frame& points, TriangleMesh mesh, const Frame& mesh_frame)
{
  for (Eigen::Vector3d& v : mesh.vertices)
    v = points.toLocal(mesh_frame.toFile(v));
  return mesh;
}

/** Do some work on a file; errors get the name that the user knows it by. */
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

void
failIf(const std::optional<std::string>& broken, const StoredHull& hull)
{
  if (broken)
    throw CIDException(hull.path + ": verification: the hull of " +
                       partName(hull.part) + " breaks a guarantee: " + *broken);
}

/** The guarantee that depends on points, for some of a part. */
void
verifyContains(const PartPoints& points,
               const StoredHull& hull,
               const Verification& verification)
{
  const double rounding = roundingOf(points.points, verification.frame);
  const auto outside =
      findPointOutside(hull.mesh,
                       hull.frame.toLocal(points.points),
                       verification.abstracted.optionsOf(hull.part),
                       hull.rounding + std::min(rounding, unnoticed_rounding));
  if (outside)
    failIf(outside->sentenceAbout(
               static_cast<std::size_t>(points.indices[outside->point])),
           hull);
}

/** \param[in] hulls of parts with ascending numbers; primitives may stand for others */
void
verifyHulls(const std::vector<StoredHull>& hulls, const Verification& verification)
{
  for (const StoredHull& hull : hulls)
    failIf(
        findBrokenGuarantee(
            hull.mesh, {}, verification.abstracted.optionsOf(hull.part), hull.rounding),
        hull);
  verification.show([&](const PartPoints& points) {
    const auto hull = std::lower_bound(
        hulls.begin(), hulls.end(), points.part, [](const StoredHull& h, auto part) {
          return h.part < part;
        });
    if (hull != hulls.end() && hull->part == points.part)
      verifyContains(points, *hull, verification);
  });
  if (verification.error)
    for (const StoredHull& hull : hulls)
      failIf(verification.error->findTooFar(
                 inFrameOf(verification.frame, hull.mesh, hull.frame)),
             hull);
}

} // namespace

void
verifyMesh(const std::string& path,
           const Verification& verification,
           OutputFiles& outputs)
{
  std::vector<StoredHull> hulls;
  check(path, [&] {
    hulls = readHulls(
        path, 0, verification.abstracted.parts, verification.metres_per_unit, outputs);
  });
  verifyHulls(hulls, verification);
}

void
verifyParts(const std::string& folder,
            const SceneDescription& scene,
            const Verification& verification,
            OutputFiles& outputs)
{
  std::vector<StoredHull> hulls;
  for (std::size_t k = 0; k < verification.abstracted.parts.size(); ++k) {
    if (primitiveOf(k, scene))
      continue;
    const std::string path = std::filesystem::path(folder) / partFileName(k, scene);
    check(path, [&] {
      hulls.push_back(
          std::move(readHulls(path, k, {verification.abstracted.parts[k]}, 1.0, outputs)
                        .front()));
    });
    hulls.back().frame = Frame{scene.origin};
  }
  verifyHulls(hulls, verification);
}

void
verifyMeshesOf(const SceneFile& file,
               const SceneDescription& scene,
               const Verification& verification,
               OutputFiles& outputs)
{
  if (!file.format.read_meshes)
    return;
  std::vector<StoredHull> hulls;
  check(file.path, [&] {
    std::ifstream stream(outputs.pathBeforeCommit(file.path), std::ios::binary);
    const NamedMeshes meshes = file.format.read_meshes(stream);
    for (std::size_t k = 0; k < verification.abstracted.parts.size(); ++k) {
      if (!file.format.primitives.empty() && primitiveOf(k, scene))
        continue;
      const auto found = meshes.find(partName(k, scene.name));
      if (found == meshes.end())
        throw CIDException("the mesh of " + partName(k) + " is missing");
      const PlacedMesh& placed = found->second;
      hulls.push_back(inMetres(k, placed.mesh, file.format.is_float, 1.0, file.path));
      hulls.back().frame = Frame{placed.origin};
    }
    if (meshes.size() != hulls.size())
      throw CIDException("it has " + std::to_string(meshes.size()) +
                         " meshes; it must have " + std::to_string(hulls.size()));
  });
  verifyHulls(hulls, verification);
}

} // namespace pcl_cid::tools
