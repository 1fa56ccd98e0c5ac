/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The meshes of a binary glTF, read back to check them.
 */

#include "gltf.h"
#include "mesh_readers.h"

#include <pcl_cid/exceptions.h>

#include <cstring>
#include <istream>
#include <iterator>

namespace pcl_cid {
namespace {

using Json = nlohmann::json;

void
require(bool condition, const char* what)
{
  if (!condition)
    throw CIDException(std::string("it is no glTF as it was written: ") + what);
}

template <typename Value>
Value
valueAt(const std::string& bytes, std::size_t offset)
{
  require(offset <= bytes.size() && bytes.size() - offset >= sizeof(Value),
          "it ends too early");
  Value value{};
  std::memcpy(&value, bytes.data() + offset, sizeof(Value));
  return value;
}

/** A file in its two chunks. */
class GLTFReading {
public:
  explicit GLTFReading(const std::string& bytes)
  {
    require(valueAt<std::uint32_t>(bytes, 0) == gltf::magic, "wrong beginning");
    require(valueAt<std::uint32_t>(bytes, 4) == gltf::version, "wrong version");
    require(valueAt<std::uint32_t>(bytes, 8) == bytes.size(), "wrong length");
    const std::string json = chunk(bytes, 12, gltf::json_chunk);
    const std::size_t binary = 12 + 8 + json.size();
    if (binary < bytes.size())
      binary_ = chunk(bytes, binary, gltf::binary_chunk);
    document_ = Json::parse(json);
  }

  NamedMeshes
  meshes() const
  {
    const Json& nodes = document_.at("nodes");
    require(document_.at("scenes").at(0).at("nodes") == Json::array({0}),
            "wrong scene");
    require(nodes.at(0).at("matrix") == Json(gltf::z_up_to_y_up), "z is not up");
    NamedMeshes meshes;
    for (const Json& child : nodes.at(0).value("children", Json::array()))
      require(meshes.insert(meshOf(nodes.at(child.get<std::size_t>()))).second,
              "a name stands twice");
    return meshes;
  }

private:
  static std::string
  chunk(const std::string& bytes, std::size_t offset, std::uint32_t type)
  {
    const auto size = valueAt<std::uint32_t>(bytes, offset);
    require(valueAt<std::uint32_t>(bytes, offset + 4) == type, "wrong chunk");
    require(offset + 8 + size <= bytes.size(), "it ends too early");
    return bytes.substr(offset + 8, size);
  }

  std::pair<std::string, PlacedMesh>
  meshOf(const Json& node) const
  {
    const auto origin = node.at("translation").get<std::array<double, 3>>();
    const Json& mesh = document_.at("meshes").at(node.at("mesh").get<std::size_t>());
    const Json& primitive = mesh.at("primitives").at(0);
    const Json& corners = accessor(primitive.at("attributes").at("POSITION"));
    const Json& triangles = accessor(primitive.at("indices"));
    require(corners.at("componentType") == gltf::float_type &&
                triangles.at("componentType") == gltf::unsigned_type,
            "wrong types");
    PlacedMesh placed;
    placed.origin = {origin[0], origin[1], origin[2]};
    const std::size_t first_corner = offsetOf(corners);
    const auto corner_count = corners.at("count").get<std::size_t>();
    for (std::size_t i = 0; i < corner_count; ++i) {
      const auto [x, y, z] = tripleAt<float>(first_corner + i * gltf::corner_bytes);
      placed.mesh.vertices.emplace_back(x, y, z);
    }
    const std::size_t first_triangle = offsetOf(triangles);
    const auto index_count = triangles.at("count").get<std::size_t>();
    for (std::size_t i = 0; i < index_count / 3; ++i)
      placed.mesh.triangles.push_back(
          triangleAt(first_triangle + i * gltf::triangle_bytes, placed.mesh));
    return {node.at("name").get<std::string>(), placed};
  }

  const Json&
  accessor(const Json& number) const
  {
    return document_.at("accessors").at(number.get<std::size_t>());
  }

  std::size_t
  offsetOf(const Json& accessor) const
  {
    const auto number = accessor.at("bufferView").get<std::size_t>();
    const Json& view = document_.at("bufferViews").at(number);
    return view.value("byteOffset", std::size_t{0}) +
           accessor.value("byteOffset", std::size_t{0});
  }

  template <typename Value>
  std::array<Value, 3>
  tripleAt(std::size_t offset) const
  {
    return {valueAt<Value>(binary_, offset),
            valueAt<Value>(binary_, offset + sizeof(Value)),
            valueAt<Value>(binary_, offset + 2 * sizeof(Value))};
  }

  std::array<std::uint32_t, 3>
  triangleAt(std::size_t offset, const TriangleMesh& mesh) const
  {
    const auto corners = tripleAt<std::uint32_t>(offset);
    for (const std::uint32_t corner : corners)
      require(corner < mesh.vertices.size(), "a triangle has a corner that is none");
    return corners;
  }

  Json document_;
  std::string binary_;
};

} // namespace

NamedMeshes
readMeshesOfGLTF(std::istream& stream)
{
  try {
    return GLTFReading(std::string(std::istreambuf_iterator<char>(stream), {}))
        .meshes();
  }
  catch (const Json::exception& error) {
    throw CIDException(std::string("it is no glTF as it was written: ") + error.what());
  }
}

} // namespace pcl_cid
