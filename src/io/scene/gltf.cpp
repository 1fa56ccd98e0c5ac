/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as a binary glTF.
 */

#include "gltf.h"

#include "mesh_readers.h"
#include "scene_rows.h"
#include "scene_text.h"
#include "text/binary_writing.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <array>
#include <limits>
#include <ostream>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson
toJson(const Eigen::Vector3d& v)
{
  return {v.x(), v.y(), v.z()};
}

OrderedJson
opaque(const Eigen::Vector3d& color)
{
  return {color.x(), color.y(), color.z(), 1.0};
}

Eigen::Vector3d
asFloat(const Eigen::Vector3d& v)
{
  return v.cast<float>().cast<double>();
}

/** The JSON and the binary chunk of a file, to which parts are added. In the chunk all
 *  corners come before all triangles, a view each. */
class GLTFWriting {
public:
  explicit GLTFWriting(const SceneDescription& scene) : scene_(scene)
  {
    root_["name"] = scene.name;
    root_["matrix"] = gltf::z_up_to_y_up;
  }

  void
  add(std::size_t part, const TriangleMesh& mesh)
  {
    const std::string name = partName(part, scene_.name);
    const std::size_t corners = addAccessor(cornersOf(mesh));
    const std::size_t triangles = addAccessor(trianglesOf(mesh));
    const OrderedJson primitive = {{"attributes", {{"POSITION", corners}}},
                                   {"indices", triangles},
                                   {"material", part}};
    meshes_.push_back(
        {{"name", name}, {"primitives", OrderedJson::array({primitive})}});
    materials_.push_back(
        {{"name", name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", opaque(linearColor(part))}, {"metallicFactor", 0.0}}}});
    root_["children"].push_back(part + 1);
    nodes_.push_back(
        {{"name", name}, {"mesh", part}, {"translation", toJson(scene_.origin)}});
    corners_.insert(corners_.end(), mesh.vertices.begin(), mesh.vertices.end());
    triangles_.insert(triangles_.end(), mesh.triangles.begin(), mesh.triangles.end());
  }

  void
  writeTo(std::ostream& stream) const
  {
    std::string json = document().dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::uint64_t bytes = cornerBytes() + triangleBytes();
    const std::uint64_t all = 12 + 8 + json.size() + (bytes > 0 ? 8 + bytes : 0);
    if (all > std::numeric_limits<std::uint32_t>::max())
      throw CIDException("the scene has more than 4 GB, which binary glTF cannot hold");
    for (const std::uint64_t value : {std::uint64_t{gltf::magic},
                                      std::uint64_t{gltf::version},
                                      all,
                                      std::uint64_t{json.size()},
                                      std::uint64_t{gltf::json_chunk}})
      writeValue(stream, static_cast<std::uint32_t>(value));
    stream << json;
    if (bytes > 0)
      writeBinary(stream, static_cast<std::uint32_t>(bytes));
  }

private:
  OrderedJson
  cornersOf(const TriangleMesh& mesh) const
  {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
      box.extend(asFloat(vertex));
    return {{"bufferView", gltf::corner_view},
            {"byteOffset", cornerBytes()},
            {"componentType", gltf::float_type},
            {"count", mesh.vertices.size()},
            {"type", "VEC3"},
            {"min", toJson(box.min())},
            {"max", toJson(box.max())}};
  }

  OrderedJson
  trianglesOf(const TriangleMesh& mesh) const
  {
    return {{"bufferView", gltf::triangle_view},
            {"byteOffset", triangleBytes()},
            {"componentType", gltf::unsigned_type},
            {"count", 3 * mesh.triangles.size()},
            {"type", "SCALAR"}};
  }

  std::size_t
  addAccessor(const OrderedJson& accessor)
  {
    accessors_.push_back(accessor);
    return accessors_.size() - 1;
  }

  std::uint64_t
  cornerBytes() const
  {
    return corners_.size() * gltf::corner_bytes;
  }

  std::uint64_t
  triangleBytes() const
  {
    return triangles_.size() * gltf::triangle_bytes;
  }

  /** Arrays must not be empty: without parts they are left out. */
  OrderedJson
  document() const
  {
    OrderedJson nodes = OrderedJson::array({root_});
    nodes.insert(nodes.end(), nodes_.begin(), nodes_.end());
    OrderedJson document = {{"asset", {{"version", "2.0"}, {"generator", "pcl_cid"}}},
                            {"scene", 0},
                            {"scenes", OrderedJson::array({{{"nodes", {0}}}})},
                            {"nodes", nodes}};
    if (meshes_.empty())
      return document;
    document["meshes"] = meshes_;
    document["materials"] = materials_;
    document["accessors"] = accessors_;
    document["bufferViews"] = OrderedJson::array({{{"buffer", 0},
                                                   {"byteLength", cornerBytes()},
                                                   {"byteStride", gltf::corner_bytes},
                                                   {"target", gltf::corner_target}},
                                                  {{"buffer", 0},
                                                   {"byteOffset", cornerBytes()},
                                                   {"byteLength", triangleBytes()},
                                                   {"target", gltf::triangle_target}}});
    document["buffers"] =
        OrderedJson::array({{{"byteLength", cornerBytes() + triangleBytes()}}});
    return document;
  }

  void
  writeBinary(std::ostream& stream, std::uint32_t bytes) const
  {
    writeValue(stream, bytes);
    writeValue(stream, gltf::binary_chunk);
    for (const Eigen::Vector3d& corner : corners_)
      for (int axis = 0; axis < 3; ++axis)
        writeValue(stream, static_cast<float>(corner[axis]));
    for (const auto& triangle : triangles_)
      for (const std::uint32_t corner : triangle)
        writeValue(stream, corner);
  }

  const SceneDescription& scene_;
  OrderedJson root_;
  OrderedJson nodes_ = OrderedJson::array();
  OrderedJson meshes_ = OrderedJson::array();
  OrderedJson materials_ = OrderedJson::array();
  OrderedJson accessors_ = OrderedJson::array();
  std::vector<Eigen::Vector3d> corners_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

} // namespace

void
writeGLTF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene)
{
  requirePartsName(scene.name);
  GLTFWriting writing(scene);
  for (std::size_t i = 0; i < parts.size(); ++i)
    writing.add(i, meshInScene(parts[i], scene));
  writing.writeTo(stream);
}

SceneFormat
gltfFormat()
{
  SceneFormat format;
  format.name = "glTF";
  format.option = "gltf";
  format.extensions = {".glb"};
  format.help = "write a binary glTF 2.0, which holds its meshes: for viewers";
  format.write = writeGLTF;
  format.is_float = true;
  format.read_meshes = readMeshesOfGLTF;
  return format;
}

} // namespace pcl_cid
