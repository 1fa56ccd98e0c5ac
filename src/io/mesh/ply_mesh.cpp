/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * PLY files of parts: written, and read back.
 */

#include "base/sentence.h"
#include "mesh_rows.h"
#include "ply/ply_header.h"
#include "text/binary_reading.h"
#include "text/binary_writing.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_import.h>

#include <algorithm>
#include <array>
#include <ostream>

#include <pcl/PCLPointField.h>

namespace pcl_cid {
namespace {

struct MeshSize {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
};

MeshSize
sizeOfAll(const std::vector<ConvexPart>& parts)
{
  MeshSize size;
  for (const ConvexPart& part : parts) {
    size.vertices += part.hull.vertices.size();
    size.triangles += part.hull.triangles.size();
  }
  return size;
}

/** A face as writePLY() lays it out. */
struct PLYFace {
  std::uint64_t offset = 0; ///< in the file
  std::array<std::uint32_t, 3> vertices{};
  std::int32_t part = 0;
};

constexpr std::uint64_t ply_vertex_bytes = 3 * sizeof(double);
constexpr std::uint64_t ply_face_bytes = 1 + 3 * sizeof(std::int32_t) + 3 + 4;

/** Whether the properties have these names and types, in this order. */
bool
isLaidOut(const PLYElement& element,
          const std::string& name,
          const std::vector<PLYProperty>& properties)
{
  return element.name == name &&
         std::equal(element.properties.begin(),
                    element.properties.end(),
                    properties.begin(),
                    properties.end(),
                    [](const PLYProperty& a, const PLYProperty& b) {
                      return a.name == b.name && a.datatype == b.datatype &&
                             a.length_datatype == b.length_datatype;
                    });
}

PLYHeader
readMeshHeader(BinaryReading& file, const std::string& path)
{
  using Field = pcl::PCLPointField;
  const PLYHeader header = readPLYHeader(file.stream(), path);
  if (header.encoding != PLYHeader::Encoding::little_endian ||
      header.elements.size() != 2 ||
      !isLaidOut(
          header.elements[0],
          "vertex",
          {{"x", Field::FLOAT64}, {"y", Field::FLOAT64}, {"z", Field::FLOAT64}}) ||
      !isLaidOut(header.elements[1],
                 "face",
                 {{"vertex_indices", Field::INT32, Field::UINT8},
                  {"red", Field::UINT8},
                  {"green", Field::UINT8},
                  {"blue", Field::UINT8},
                  {"part", Field::INT32}}))
    throw CIDException(path + ": its header is not that of a mesh with parts, as "
                              "writePLY() writes it");
  return header;
}

PLYFace
readFace(BinaryReading& file, std::size_t vertices)
{
  PLYFace face;
  face.offset = file.offset();
  if (file.read<std::uint8_t>() != 3)
    file.fail(face.offset, "the face is not a triangle");
  for (std::uint32_t& vertex : face.vertices) {
    const auto number = file.read<std::int32_t>();
    if (number < 0 || static_cast<std::size_t>(number) >= vertices)
      file.fail(face.offset,
                sentence("the face names vertex ", number, ", which is none"));
    vertex = static_cast<std::uint32_t>(number);
  }
  for (int channel = 0; channel < 3; ++channel)
    file.read<std::uint8_t>();
  face.part = file.read<std::int32_t>();
  return face;
}

/** Deals faces and their vertices out to the parts; vertices keep their order. */
class PartsOfPLY {
public:
  /** \param[in] vertices_offset where the first of them stands in the file */
  PartsOfPLY(const BinaryReading& file,
             std::uint64_t vertices_offset,
             const std::vector<Eigen::Vector3d>& vertices)
  : file_(file)
  , vertices_offset_(vertices_offset)
  , vertices_(vertices)
  , part_(vertices.size(), none)
  {
  }

  void
  add(const PLYFace& face)
  {
    const auto last = static_cast<std::int64_t>(faces_.size()) - 1;
    if (face.part < 0 || face.part < last || face.part > last + 1)
      file_.fail(face.offset,
                 sentence("the face is of part ",
                          face.part,
                          " after one of part ",
                          last,
                          "; parts must ascend from 0 without a gap"));
    const auto part = static_cast<std::size_t>(face.part);
    faces_.resize(part + 1);
    faces_.back().push_back(face.vertices);
    for (const std::uint32_t vertex : face.vertices) {
      if (part_[vertex] != none && part_[vertex] != part)
        file_.fail(face.offset,
                   sentence("the face of part ",
                            part,
                            " shares vertex ",
                            vertex,
                            " with part ",
                            part_[vertex]));
      part_[vertex] = part;
    }
  }

  std::vector<TriangleMesh>
  meshes() const
  {
    std::vector<TriangleMesh> meshes(faces_.size());
    std::vector<std::uint32_t> local(vertices_.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (part_[i] == none)
        file_.fail(vertices_offset_ + i * ply_vertex_bytes,
                   sentence("vertex ", i, " belongs to no face"));
      TriangleMesh& mesh = meshes[part_[i]];
      local[i] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(vertices_[i]);
    }
    for (std::size_t part = 0; part < faces_.size(); ++part)
      for (const auto& [a, b, c] : faces_[part])
        meshes[part].triangles.push_back({local[a], local[b], local[c]});
    return meshes;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const BinaryReading& file_;
  std::uint64_t vertices_offset_;
  const std::vector<Eigen::Vector3d>& vertices_;
  std::vector<std::size_t> part_; ///< of each vertex
  std::vector<std::vector<std::array<std::uint32_t, 3>>> faces_;
};

} // namespace

void
writePLY(std::ostream& stream, const std::vector<ConvexPart>& parts)
{
  const MeshSize size = sizeOfAll(parts);
  stream << "ply\nformat binary_little_endian 1.0\nelement vertex " << size.vertices
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
         << size.triangles
         << "\nproperty list uchar int vertex_indices\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\nproperty int part\n"
            "end_header\n";
  for (const ConvexPart& part : parts)
    for (const Eigen::Vector3d& vertex : part.hull.vertices)
      for (int axis = 0; axis < 3; ++axis)
        writeValue(stream, vertex[axis]);
  std::size_t first_vertex = 0; // through all parts
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartColor color = partColor(i);
    for (const auto& triangle : parts[i].hull.triangles) {
      writeValue(stream, std::uint8_t{3});
      for (const std::uint32_t vertex : triangle)
        writeValue(stream, static_cast<std::int32_t>(first_vertex + vertex));
      writeValue(stream, color.red);
      writeValue(stream, color.green);
      writeValue(stream, color.blue);
      writeValue(stream, static_cast<std::int32_t>(i));
    }
    first_vertex += parts[i].hull.vertices.size();
  }
}

std::vector<TriangleMesh>
readPLY(const std::string& path)
{
  BinaryReading file(path);
  const PLYHeader header = readMeshHeader(file, path);
  const std::uint64_t vertex_count = header.elements[0].count;
  const std::uint64_t face_count = header.elements[1].count;
  file.requireLeft(vertex_count * ply_vertex_bytes + face_count * ply_face_bytes);
  const std::uint64_t vertices_offset = file.offset();
  std::vector<Eigen::Vector3d> vertices;
  for (std::uint64_t i = 0; i < vertex_count; ++i)
    vertices.push_back(file.readFinite<double>());
  PartsOfPLY parts(file, vertices_offset, vertices);
  for (std::uint64_t i = 0; i < face_count; ++i)
    parts.add(readFace(file, vertices.size()));
  return parts.meshes();
}

MeshFormat
plyMeshFormat()
{
  MeshFormat format;
  format.name = "PLY";
  format.extensions = {".ply"};
  format.write = [](std::ostream& stream,
                    const std::vector<ConvexPart>& parts,
                    const std::string&,
                    const std::string&) { writePLY(stream, parts); };
  format.read = readPLY;
  return format;
}

} // namespace pcl_cid
