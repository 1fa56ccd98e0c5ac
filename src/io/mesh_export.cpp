/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts as mesh files: OBJ, PLY, STL.
 */

#include "field_values.h"

#include <pcl_cid/io/mesh_export.h>

#include <ostream>

#include <pcl/common/colors.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

void
appendVector(const Eigen::Vector3d& v, std::string& text)
{
  for (int axis = 0; axis < 3; ++axis) {
    text += ' ';
    appendNumber(v[axis], text);
  }
}

template <typename Value>
void
writeValue(std::ostream& stream, Value value)
{
  stream.write(reinterpret_cast<const char*>(&value), sizeof(value));
}

void
writeFloats(std::ostream& stream, const Eigen::Vector3d& v)
{
  for (int axis = 0; axis < 3; ++axis)
    writeValue(stream, static_cast<float>(v[axis]));
}

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

void
appendVertices(const TriangleMesh& mesh, std::string& text)
{
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    text += 'v';
    appendVector(vertex, text);
    text += '\n';
  }
}

/** \param[in] first_vertex number of the mesh's first vertex in the file, from 1 */
void
appendFaces(const TriangleMesh& mesh, std::size_t first_vertex, std::string& text)
{
  for (const auto& triangle : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t vertex : triangle)
      text += ' ' + std::to_string(first_vertex + vertex);
    text += '\n';
  }
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

} // namespace

PartColour
partColour(std::size_t part)
{
  const pcl::RGB colour = pcl::GlasbeyLUT::at(part % pcl::GlasbeyLUT::size());
  return {colour.r, colour.g, colour.b};
}

std::string
partName(std::size_t part)
{
  std::string number = std::to_string(part);
  if (number.size() < 3)
    number.insert(0, 3 - number.size(), '0');
  return "part_" + number;
}

void
writeOBJ(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const std::string& material_library)
{
  stream << "mtllib " << material_library << '\n';
  std::size_t first_vertex = 1; // counted from 1, through all parts
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TriangleMesh& hull = parts[i].hull;
    std::string text = "o " + partName(i) + "\n";
    appendVertices(hull, text);
    text += "usemtl " + partName(i) + "\n";
    appendFaces(hull, first_vertex, text);
    stream << text;
    first_vertex += hull.vertices.size();
  }
}

void
writeOBJMesh(std::ostream& stream, const TriangleMesh& mesh, const std::string& name)
{
  std::string text = "o " + name + "\n";
  appendVertices(mesh, text);
  appendFaces(mesh, 1, text);
  stream << text;
}

void
writeMTL(std::ostream& stream, const std::vector<ConvexPart>& parts)
{
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartColour colour = partColour(i);
    std::string text = "newmtl " + partName(i) + "\nKd";
    appendVector(Eigen::Vector3d(colour.red, colour.green, colour.blue) / 255.0, text);
    stream << text << '\n';
  }
}

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
    const PartColour colour = partColour(i);
    for (const auto& triangle : parts[i].hull.triangles) {
      writeValue(stream, std::uint8_t{3});
      for (const std::uint32_t vertex : triangle)
        writeValue(stream, static_cast<std::int32_t>(first_vertex + vertex));
      writeValue(stream, colour.red);
      writeValue(stream, colour.green);
      writeValue(stream, colour.blue);
      writeValue(stream, static_cast<std::int32_t>(i));
    }
    first_vertex += parts[i].hull.vertices.size();
  }
}

void
writeSTL(std::ostream& stream, const std::vector<ConvexPart>& parts)
{
  writeSTLHeader(stream, sizeOfAll(parts).triangles);
  for (const ConvexPart& part : parts)
    writeSTLTriangles(stream, part.hull);
}

void
writeSTLMesh(std::ostream& stream, const TriangleMesh& mesh)
{
  writeSTLHeader(stream, mesh.triangles.size());
  writeSTLTriangles(stream, mesh);
}

pcl::PolygonMesh
toPolygonMesh(const TriangleMesh& mesh)
{
  pcl::PointCloud<pcl::PointXYZ> vertices;
  for (const Eigen::Vector3d& v : mesh.vertices)
    vertices.emplace_back(static_cast<float>(v.x()),
                          static_cast<float>(v.y()),
                          static_cast<float>(v.z()));
  pcl::PolygonMesh result;
  pcl::toPCLPointCloud2(vertices, result.cloud);
  for (const auto& triangle : mesh.triangles) {
    pcl::Vertices polygon;
    polygon.vertices.assign(triangle.begin(), triangle.end());
    result.polygons.push_back(polygon);
  }
  return result;
}

void
translate(const Eigen::Vector3d& offset, std::vector<ConvexPart>& parts)
{
  for (ConvexPart& part : parts)
    for (Eigen::Vector3d& vertex : part.hull.vertices)
      vertex += offset;
}

} // namespace pcl_cid
