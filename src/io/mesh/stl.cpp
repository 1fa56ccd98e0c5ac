/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Binary STL files of parts: written, and read back.
 */

#include "mesh_rows.h"
#include "text/binary_reading.h"
#include "text/binary_writing.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_import.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

void
writeFloats(std::ostream& stream, const Eigen::Vector3d& v)
{
  for (int axis = 0; axis < 3; ++axis)
    writeValue(stream, static_cast<float>(v[axis]));
}

void
writeSTLHeader(std::ostream& stream, std::size_t triangles)
{
  std::string comment = "convex hulls by pcl_cid";
  comment.resize(80);
  stream << comment;
  writeValue(stream, static_cast<std::uint32_t>(triangles));
}

void
writeSTLTriangles(std::ostream& stream, const TriangleMesh& mesh)
{
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
    const Eigen::Vector3d& b = mesh.vertices[triangle[1]];
    const Eigen::Vector3d& c = mesh.vertices[triangle[2]];
    writeFloats(stream, (b - a).cross(c - a).normalized());
    for (const Eigen::Vector3d* const vertex : {&a, &b, &c})
      writeFloats(stream, *vertex);
    writeValue(stream, std::uint16_t{0});
  }
}

struct LexicographicallyLess {
  bool
  operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
  {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

} // namespace

void
writeSTL(std::ostream& stream, const std::vector<ConvexPart>& parts)
{
  std::size_t triangles = 0;
  for (const ConvexPart& part : parts)
    triangles += part.hull.triangles.size();
  writeSTLHeader(stream, triangles);
  for (const ConvexPart& part : parts)
    writeSTLTriangles(stream, part.hull);
}

void
writeSTLMesh(std::ostream& stream, const TriangleMesh& mesh)
{
  writeSTLHeader(stream, mesh.triangles.size());
  writeSTLTriangles(stream, mesh);
}

TriangleMesh
readSTL(const std::string& path)
{
  constexpr std::uint64_t comment_bytes = 80;
  constexpr std::uint64_t triangle_bytes = 12 * sizeof(float) + 2;
  BinaryReading file(path);
  for (std::uint64_t i = 0; i < comment_bytes; ++i)
    file.read<char>();
  const auto count = file.read<std::uint32_t>();
  file.requireLeft(count * triangle_bytes);

  TriangleMesh mesh;
  std::map<Eigen::Vector3d, std::uint32_t, LexicographicallyLess> known;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      file.read<float>(); // the normal follows from the corners
    std::array<std::uint32_t, 3> triangle{};
    for (std::uint32_t& corner : triangle) {
      const Eigen::Vector3d vertex = file.readFinite<float>();
      const auto [place, is_new] =
          known.emplace(vertex, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new)
        mesh.vertices.push_back(vertex);
      corner = place->second;
    }
    mesh.triangles.push_back(triangle);
    file.read<std::uint16_t>(); // attributes
  }
  return mesh;
}

MeshFormat
stlFormat()
{
  MeshFormat format;
  format.name = "STL";
  format.extensions = {".stl"};
  format.is_float = true;
  format.has_parts = false;
  format.write = [](std::ostream& stream,
                    const std::vector<ConvexPart>& parts,
                    const std::string&,
                    const std::string&) { writeSTL(stream, parts); };
  format.write_mesh = [](std::ostream& stream,
                         const TriangleMesh& mesh,
                         const std::string&) { writeSTLMesh(stream, mesh); };
  format.read = [](const std::string& path) {
    return std::vector<TriangleMesh>{readSTL(path)};
  };
  return format;
}

} // namespace pcl_cid
