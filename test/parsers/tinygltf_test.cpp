/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Binary glTF opened by tinygltf.
 */

#include "exported_scene.h"

#include <pcl_cid/io/mesh_export.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>
#include <tiny_gltf.h>

namespace pcl_cid::test {
namespace {

tinygltf::Model
loaded(const std::string& path)
{
  tinygltf::Model model;
  std::string error;
  std::string warning;
  tinygltf::TinyGLTF loader;
  if (!loader.LoadBinaryFromFile(&model, &error, &warning, path))
    throw std::runtime_error(path + ": " + error);
  EXPECT_EQ(error + warning, "");
  return model;
}

/** The values that an accessor names, as the specification says to find them. */
template <typename Value>
std::vector<Value>
valuesOf(const tinygltf::Model& model, const tinygltf::Accessor& accessor)
{
  const tinygltf::BufferView& view =
      model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const auto width = static_cast<std::size_t>(
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  const auto stride = static_cast<std::size_t>(accessor.ByteStride(view));
  EXPECT_EQ(stride, width * sizeof(Value));
  EXPECT_EQ((view.byteOffset + accessor.byteOffset) % sizeof(Value), 0u);
  EXPECT_LE(accessor.byteOffset + accessor.count * stride, view.byteLength);
  const auto& bytes = model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
  EXPECT_LE(view.byteOffset + view.byteLength, bytes.size());
  std::vector<Value> values(accessor.count * width);
  std::memcpy(values.data(),
              bytes.data() + view.byteOffset + accessor.byteOffset,
              values.size() * sizeof(Value));
  return values;
}

void
expectMesh(const tinygltf::Model& model,
           const tinygltf::Mesh& mesh,
           const TriangleMesh& expected)
{
  ASSERT_EQ(mesh.primitives.size(), 1u);
  const tinygltf::Primitive& primitive = mesh.primitives[0];
  EXPECT_TRUE(primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == -1);
  const tinygltf::Accessor& corners =
      model.accessors.at(static_cast<std::size_t>(primitive.attributes.at("POSITION")));
  ASSERT_EQ(corners.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT);
  ASSERT_EQ(corners.type, TINYGLTF_TYPE_VEC3);
  const std::vector<float> places = valuesOf<float>(model, corners);
  ASSERT_EQ(places.size(), 3 * expected.vertices.size());
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i < expected.vertices.size(); ++i) {
    const Eigen::Map<const Eigen::Vector3f> vertex(places.data() + 3 * i);
    EXPECT_EQ(vertex, expected.vertices[i].cast<float>());
    box.extend(Eigen::Vector3f(vertex));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    EXPECT_EQ(static_cast<float>(corners.minValues.at(i)), box.min()[axis]);
    EXPECT_EQ(static_cast<float>(corners.maxValues.at(i)), box.max()[axis]);
  }
  const tinygltf::Accessor& triangles =
      model.accessors.at(static_cast<std::size_t>(primitive.indices));
  ASSERT_EQ(triangles.componentType, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
  ASSERT_EQ(triangles.type, TINYGLTF_TYPE_SCALAR);
  const auto indices = valuesOf<std::uint32_t>(model, triangles);
  ASSERT_EQ(indices.size(), 3 * expected.triangles.size());
  for (std::size_t t = 0; t < expected.triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner)
      EXPECT_EQ(indices[3 * t + corner], expected.triangles[t][corner]);
}

/** What screens show of a color that is mixed as light. */
double
shown(double light)
{
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

void
expectColor(const std::vector<double>& factor, const PartColor& color)
{
  ASSERT_EQ(factor.size(), 4u);
  EXPECT_NEAR(shown(factor[0]), color.red / 255.0, 1e-4);
  EXPECT_NEAR(shown(factor[1]), color.green / 255.0, 1e-4);
  EXPECT_NEAR(shown(factor[2]), color.blue / 255.0, 1e-4);
  EXPECT_EQ(factor[3], 1.0);
}

TEST(TinyGLTF, FindsANodeAMeshAndAMaterialForEachPart)
{
  forEachExportedScene([](const ExportedScene& exported) {
    const tinygltf::Model model = loaded(exported.file("scene.glb"));
    EXPECT_EQ(model.asset.version, "2.0");
    const std::size_t count = exported.parts().size();
    ASSERT_EQ(model.meshes.size(), count);
    ASSERT_EQ(model.materials.size(), count);
    ASSERT_EQ(model.nodes.size(), count + 1);
    ASSERT_EQ(model.scenes.at(static_cast<std::size_t>(model.defaultScene)).nodes,
              std::vector<int>{0});
    const tinygltf::Node& root = model.nodes[0];
    EXPECT_EQ(root.name, exported.description().name);
    ASSERT_EQ(root.children.size(), count);
    // What is up in the scan, z, is up in glTF, y.
    const Eigen::Matrix4d turn = Eigen::Map<const Eigen::Matrix4d>(root.matrix.data());
    EXPECT_EQ((turn * Eigen::Vector4d(1, 2, 3, 1)), Eigen::Vector4d(1, 3, -2, 1));
    const Eigen::Vector3d& origin = exported.description().origin;
    for (std::size_t i = 0; i < count; ++i) {
      const tinygltf::Node& node =
          model.nodes.at(static_cast<std::size_t>(root.children[i]));
      EXPECT_EQ(node.name, exported.partName(i));
      EXPECT_EQ(node.translation,
                (std::vector<double>{origin.x(), origin.y(), origin.z()}));
      const tinygltf::Mesh& mesh = model.meshes.at(static_cast<std::size_t>(node.mesh));
      EXPECT_EQ(mesh.name, exported.partName(i));
      expectMesh(model, mesh, meshInScene(exported.parts()[i], exported.description()));
      const tinygltf::Material& material =
          model.materials.at(static_cast<std::size_t>(mesh.primitives[0].material));
      EXPECT_EQ(material.name, exported.partName(i));
      expectColor(material.pbrMetallicRoughness.baseColorFactor, partColor(i));
    }
  });
}

TEST(TinyGLTF, OpensASceneWithoutParts)
{
  const TemporaryFolder folder;
  std::ofstream stream(folder.file("empty.glb"), std::ios::binary);
  writeGLTF(stream, {}, {});
  stream.close();
  const tinygltf::Model model = loaded(folder.file("empty.glb"));
  EXPECT_EQ(model.nodes.size(), 1u);
  EXPECT_TRUE(model.meshes.empty());
}

} // namespace
} // namespace pcl_cid::test
