/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as a USD in text.
 */

#include "mesh_readers.h"
#include "scene_rows.h"
#include "scene_text.h"
#include "text/numbers.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <array>
#include <ostream>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

template <typename Triple>
std::string
tuple(const Triple& values)
{
  std::string text;
  for (int i = 0; i < 3; ++i) {
    text += i == 0 ? "(" : ", ";
    appendNumber(values[i], text);
  }
  return text + ")";
}

/** "[a, b, c]" of what \a text makes of each item. */
template <typename Items, typename Text>
std::string
list(const Items& items, const Text& text)
{
  std::string result;
  for (const auto& item : items)
    result += (result.empty() ? "" : ", ") + text(item);
  return "[" + result + "]";
}

std::vector<Eigen::Vector3f>
floatVertices(const TriangleMesh& mesh)
{
  std::vector<Eigen::Vector3f> vertices;
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    vertices.push_back(vertex.cast<float>());
  return vertices;
}

/** The box around vertices: where it is missing, programs compute it. */
std::string
extentOf(const std::vector<Eigen::Vector3f>& vertices)
{
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& vertex : vertices)
    box.extend(vertex);
  return "[" + tuple(box.min()) + ", " + tuple(box.max()) + "]";
}

/** A collider without a rigid body, which nothing moves. That its hull is asked for
 *  changes nothing, as it is convex; but physics knows that it is. */
std::string
prim(std::size_t part, const TriangleMesh& mesh, const SceneDescription& scene)
{
  const std::vector<Eigen::Vector3f> vertices = floatVertices(mesh);
  const auto three = [](const auto&) { return std::string("3"); };
  const auto corners = [](const std::array<std::uint32_t, 3>& triangle) {
    const std::string text = tuple(triangle);
    return text.substr(1, text.size() - 2); // one list of all
  };
  return "    def Mesh \"" + partName(part, scene.name) +
         "\" (\n"
         "        prepend apiSchemas = [\"PhysicsCollisionAPI\", "
         "\"PhysicsMeshCollisionAPI\"]\n"
         "    )\n"
         "    {\n"
         "        uniform token physics:approximation = \"convexHull\"\n"
         "        uniform token subdivisionScheme = \"none\"\n"
         "        float3[] extent = " +
         extentOf(vertices) +
         "\n        int[] faceVertexCounts = " + list(mesh.triangles, three) +
         "\n        int[] faceVertexIndices = " + list(mesh.triangles, corners) +
         "\n        point3f[] points = " + list(vertices, tuple<Eigen::Vector3f>) +
         "\n        color3f[] primvars:displayColor = [" + tuple(linearColor(part)) +
         "]\n        double3 xformOp:translate = " + tuple(scene.origin) +
         "\n        uniform token[] xformOpOrder = [\"xformOp:translate\"]\n"
         "    }\n";
}

} // namespace

void
writeUSD(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const SceneDescription& scene)
{
  requirePartsName(scene.name);
  stream << "#usda 1.0\n(\n    defaultPrim = \"" << scene.name
         << "\"\n    metersPerUnit = 1\n    upAxis = \"Z\"\n)\n\ndef Xform \""
         << scene.name << "\"\n{\n";
  for (std::size_t i = 0; i < parts.size(); ++i)
    stream << prim(i, meshInScene(parts[i], scene), scene);
  stream << "}\n";
}

SceneFormat
usdFormat()
{
  SceneFormat format;
  format.name = "USD";
  format.option = "usd";
  format.extensions = {".usda"};
  format.help =
      "write a USD in text, which holds its meshes: static colliders of physics";
  format.write = writeUSD;
  format.is_float = true;
  format.read_meshes = readMeshesOfUSD;
  return format;
}

} // namespace pcl_cid
