/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The table of scene formats: what follows from a row, and a format added from outside.
 */

#include "part_scenes.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>
#include <pcl_cid/io/scene_formats.h>

#include <iterator>
#include <ostream>
#include <sstream>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

std::string
written(const SceneFormat& format, const SceneDescription& scene)
{
  std::ostringstream stream;
  format.write(stream, thinParts(Eigen::Vector3d::Zero()).parts, scene);
  return stream.str();
}

TEST(SceneFormats, AreThoseOfTheWriters)
{
  const std::vector<SceneFormat> formats = sceneFormats();
  const char* const options[] = {"urdf", "sdf", "mjcf", "moveit", "gltf", "usd"};
  ASSERT_GE(formats.size(), std::size(options));
  for (std::size_t i = 0; i < std::size(options); ++i)
    EXPECT_EQ(formats[i].option, options[i]);
  std::ostringstream urdf;
  writeURDF(urdf, thinParts(Eigen::Vector3d::Zero()).parts, {});
  EXPECT_EQ(written(*findSceneFormat("URDF"), {}), urdf.str());
  EXPECT_EQ(findSceneFormat("urdf"), nullptr);
}

/** What a row says about a format is true of what it writes. */
TEST(SceneFormats, SayWhatTheyReferTo)
{
  SceneDescription scene;
  scene.frame = "survey";
  for (const SceneFormat& format : sceneFormats()) {
    SCOPED_TRACE(format.name);
    const std::string text = written(format, scene);
    EXPECT_EQ(text.find("part_000.obj") != std::string::npos, format.refers_to_meshes);
    EXPECT_EQ(text.find("survey") != std::string::npos, format.names_frame);
    EXPECT_FALSE(format.extensions.empty());
    EXPECT_FALSE(format.help.empty());
  }
}

/** Mesh by mesh, where it is. */
TEST(SceneFormats, ReadTheMeshesThatTheyHold)
{
  SceneDescription scene;
  scene.name = "hall";
  scene.origin = {524288.0, 4194305.0, 102.0};
  const std::vector<ConvexPart> parts = thinParts(utmOffset()).parts;
  std::size_t holding = 0;
  for (const SceneFormat& format : sceneFormats()) {
    if (!format.read_meshes)
      continue;
    ++holding;
    SCOPED_TRACE(format.name);
    EXPECT_FALSE(format.refers_to_meshes);
    std::stringstream stream;
    format.write(stream, parts, scene);
    const NamedMeshes meshes = format.read_meshes(stream);
    ASSERT_EQ(meshes.size(), parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const PlacedMesh& placed = meshes.at(partName(i, "hall"));
      EXPECT_EQ(placed.origin, scene.origin);
      TriangleMesh expected = meshInScene(parts[i], scene);
      if (format.is_float)
        for (Eigen::Vector3d& vertex : expected.vertices)
          vertex = vertex.cast<float>().cast<double>();
      EXPECT_EQ(placed.mesh.vertices, expected.vertices);
      EXPECT_EQ(placed.mesh.triangles, expected.triangles);
    }
    std::stringstream none;
    format.write(none, {}, scene);
    EXPECT_TRUE(format.read_meshes(none).empty());
  }
  EXPECT_EQ(holding, 3u); // MoveIt, glTF, USD
}

/** Whatever byte is lost: an error of ours, or meshes, but nothing worse. */
TEST(SceneFormats, RefuseMeshesThatAreCutOff)
{
  for (const SceneFormat& format : sceneFormats()) {
    if (!format.read_meshes)
      continue;
    SCOPED_TRACE(format.name);
    const std::string whole = written(format, {});
    for (std::size_t size = 0; size + 4 < whole.size(); size += 7) {
      std::istringstream cut(whole.substr(0, size));
      std::size_t read = 0;
      try {
        read = format.read_meshes(cut).size();
      }
      catch (const CIDException&) {
      }
      EXPECT_LT(read, 7u) << size;
    }
  }
}

TEST(SceneFormats, RefuseBeforeTheWorkWhatTheyCannotHold)
{
  SceneDescription scene;
  const SceneFormat& sdf = *findSceneFormat("SDF");
  ASSERT_TRUE(sdf.check);
  EXPECT_NO_THROW(sdf.check(scene));
  scene.frame = "world";
  EXPECT_THROW(sdf.check(scene), CIDException);
}

/** A toy: a line for each part. */
SceneFormat
listFormat()
{
  SceneFormat format;
  format.name = "LIST";
  format.option = "list";
  format.extensions = {".xml"}; // as MJCF
  format.help = "write a list of the parts";
  format.refers_to_meshes = true;
  format.write = [](std::ostream& stream,
                    const std::vector<ConvexPart>& parts,
                    const SceneDescription& scene) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      stream << partFileName(i, scene) << '\n';
  };
  return format;
}

TEST(RegisteredSceneFormat, IsOneOfAll)
{
  if (!findSceneFormat("LIST")) // when tests are repeated in one process
    registerSceneFormat(listFormat());
  EXPECT_EQ(sceneFormats().back().option, "list");
  SceneDescription scene;
  scene.mesh_extension = ".stl";
  EXPECT_EQ(
      written(*findSceneFormat("LIST"), scene).rfind("convex_parts_part_000.stl\n", 0),
      0u);
}

TEST(RegisteredSceneFormat, MustBeNewAndWhole)
{
  const std::size_t before = sceneFormats().size();
  SceneFormat format = listFormat();
  format.name = "URDF";
  EXPECT_THROW(registerSceneFormat(format), CIDException);
  format.name = "OTHER";
  format.option = "sdf";
  EXPECT_THROW(registerSceneFormat(format), CIDException);
  format.option = "";
  EXPECT_THROW(registerSceneFormat(format), CIDException);
  format.option = "other";
  format.primitives = {HullPrimitive::Kind::box};
  EXPECT_THROW(registerSceneFormat(format), CIDException); // nothing reads them
  format.primitives.clear();
  format.extensions = {"xml"};
  EXPECT_THROW(registerSceneFormat(format), CIDException);
  format.extensions = {".xml"};
  format.write = nullptr;
  EXPECT_THROW(registerSceneFormat(format), CIDException);
  EXPECT_EQ(sceneFormats().size(), before);
}

} // namespace
} // namespace pcl_cid::test
