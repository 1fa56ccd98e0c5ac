/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --verify: the guarantees of the hulls, checked on what is in the files.
 */

#include "hull_verification.h"

#include "tool_run.h"

#include <pcl_cid/core/hull_guarantees.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_import.h>

#include <algorithm>
#include <filesystem>
#include <unordered_map>

namespace pcl_cid::tools {
namespace {

/** Hulls from a file, and whether it has rounded their coordinates to float. */
struct StoredHulls {
  std::vector<TriangleMesh> hulls;
  bool is_float;
};

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

/** An STL knows no parts: they are told apart by their numbers of triangles. */
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

StoredHulls
readFile(const std::string& file,
         const std::string& extension,
         const std::vector<ConvexPart>& parts)
{
  if (extension == ".obj")
    return {readOBJ(file), false};
  if (extension == ".ply")
    return {readPLY(file), false};
  return {splitIntoParts(readSTL(file), parts), true};
}

/** One hull for each part, from an output that is not committed yet. */
StoredHulls
readHulls(const std::string& path,
          const std::vector<ConvexPart>& parts,
          OutputFiles& outputs)
{
  StoredHulls stored =
      readFile(outputs.pathBeforeCommit(path), extensionOf(path), parts);
  if (stored.hulls.size() != parts.size())
    throw CIDException("it has " + std::to_string(stored.hulls.size()) +
                       " hulls; it must have " + std::to_string(parts.size()));
  return stored;
}

std::vector<Eigen::Vector3d>
pointsOf(const ConvexPart& part,
         const CloudPoints& points,
         const Eigen::Vector3d& origin)
{
  std::vector<Eigen::Vector3d> inside;
  inside.reserve(part.indices.size());
  for (const pcl::index_t index : part.indices)
    inside.push_back((*points.points)[static_cast<std::size_t>(index)]
                         .getVector3fMap()
                         .cast<double>() +
                     (points.frame.origin - origin));
  return inside;
}

void
verifyHull(std::size_t number,
           const TriangleMesh& hull,
           bool is_float,
           const Eigen::Vector3d& origin,
           const Verification& verification)
{
  const auto broken = findBrokenGuarantee(
      hull,
      pointsOf(verification.parts[number], verification.points, origin),
      verification.options,
      is_float ? floatRounding(hull) : 0.0);
  if (broken)
    throw CIDException("the hull of " + partName(number) +
                       " breaks a guarantee: " + *broken);
}

/** Errors get the name that the user knows the file by. */
template <typename Work>
void
named(const std::string& path, const Work& work)
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
  named(path, [&] {
    const StoredHulls stored = readHulls(path, verification.parts, outputs);
    for (std::size_t k = 0; k < stored.hulls.size(); ++k)
      verifyHull(
          k, stored.hulls[k], stored.is_float, Eigen::Vector3d::Zero(), verification);
  });
}

void
verifyParts(const std::string& folder,
            const SceneDescription& scene,
            const Verification& verification,
            OutputFiles& outputs)
{
  for (std::size_t k = 0; k < verification.parts.size(); ++k) {
    const std::string path =
        std::filesystem::path(folder) / partFileName(k, scene.mesh_extension);
    named(path, [&] {
      const StoredHulls stored = readHulls(path, {verification.parts[k]}, outputs);
      verifyHull(k, stored.hulls.front(), stored.is_float, scene.origin, verification);
    });
  }
}

} // namespace pcl_cid::tools
