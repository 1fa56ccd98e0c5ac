/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls from the mesh files of any program: what was a part gets a hull.
 */

#include "hull_files.h"

#include "obj_parts.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_formats.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace pcl_cid::benchmarks {
namespace {

/** Which vertices triangles join. */
class JoinedVertices {
public:
  explicit JoinedVertices(const TriangleMesh& mesh) : next_(mesh.vertices.size())
  {
    std::iota(next_.begin(), next_.end(), 0);
    for (const auto& [a, b, c] : mesh.triangles) {
      next_[leaderOf(b)] = leaderOf(a);
      next_[leaderOf(c)] = leaderOf(a);
    }
  }

  /** The same for all that are joined. */
  std::size_t
  leaderOf(std::size_t vertex)
  {
    while (next_[vertex] != vertex) {
      next_[vertex] = next_[next_[vertex]];
      vertex = next_[vertex];
    }
    return vertex;
  }

private:
  std::vector<std::size_t> next_;
};

/** Vertices of all parts, each with the number of its part. */
class PartVertices {
public:
  explicit PartVertices(std::string path) : path_(std::move(path)) {}

  /** \param[in] piece of each vertex, -1 for those that do not count */
  void
  add(const TriangleMesh& mesh, const std::vector<int>& piece, const Frame& frame)
  {
    const int first = parts_;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (piece[i] < 0)
        continue;
      constexpr double farthest = 1e15;
      if (!(mesh.vertices[i].array().abs() <= farthest).all())
        throw CIDException(path_ + ": has a vertex with a coordinate beyond 1e15; no "
                                   "hull of a scan has one");
      points_.push_back(frame.toLocal(mesh.vertices[i]).cast<float>());
      part_.push_back(first + piece[i]);
      parts_ = std::max(parts_, part_.back() + 1);
    }
  }

  std::vector<ConvexPart>
  hulls(const Frame& frame, unsigned threads) const
  {
    if (parts_ == 0)
      throw CIDException(path_ + ": has no hull; at least 1 is needed");
    PointSet points;
    points.frame = frame;
    points.points = points_;
    points.source.resize(points_.size());
    std::iota(points.source.begin(), points.source.end(), 0);
    ConvexPartOptions options;
    options.min_thickness = least_thickness;
    return makeConvexParts(points, part_, options, {threads, {}});
  }

private:
  std::string path_;
  Points points_;
  std::vector<int> part_;
  int parts_ = 0;
};

MeshParts
readMeshes(const std::string& path)
{
  const MeshFormat& format = meshFormatOf(path);
  if (format.name == "OBJ")
    return readOBJParts(path);
  if (!format.read)
    throw CIDException(path + ": " + format.name +
                       " is only written, not read; give "
                       "the hulls in another format");
  return {format.read(path), format.has_parts};
}

} // namespace

std::vector<int>
piecesOf(const TriangleMesh& mesh)
{
  JoinedVertices joined(mesh);
  std::vector<char> is_used(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle)
      is_used[vertex] = true;
  std::unordered_map<std::size_t, int> number_of_leader;
  std::vector<int> piece(mesh.vertices.size(), -1);
  for (std::size_t i = 0; i < piece.size(); ++i)
    if (is_used[i])
      piece[i] =
          number_of_leader
              .emplace(joined.leaderOf(i), static_cast<int>(number_of_leader.size()))
              .first->second;
  return piece;
}

std::vector<ConvexPart>
readHulls(const std::string& path, const Frame& frame, unsigned threads)
{
  PartVertices parts(path);
  const MeshParts file = readMeshes(path);
  for (const TriangleMesh& mesh : file.meshes)
    parts.add(mesh,
              file.has_names ? std::vector<int>(mesh.vertices.size(), 0)
                             : piecesOf(mesh),
              frame);
  return parts.hulls(frame, threads);
}

} // namespace pcl_cid::benchmarks
