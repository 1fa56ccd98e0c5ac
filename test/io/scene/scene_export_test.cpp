/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scenes for robot software: the local origin, names, layout. Other people's parsers
 * open them in test/parsers/.
 */

#include "cloud_files.h"
#include "part_scenes.h"

#include <pcl_cid/io/mesh_import.h>
#include <pcl_cid/io/scene_export.h>

#include <sstream>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Writer = void (*)(std::ostream&,
                        const std::vector<ConvexPart>&,
                        const SceneDescription&);

std::string
written(Writer write,
        const std::vector<ConvexPart>& parts,
        const SceneDescription& scene)
{
  std::ostringstream stream;
  write(stream, parts, scene);
  return stream.str();
}

TEST(SceneOrigin, IsZeroNearby)
{
  EXPECT_EQ(sceneOrigin({}), Eigen::Vector3d::Zero());
  for (const double x : {0.0, 990.0, -990.0})
    EXPECT_EQ(sceneOrigin(thinParts({x, 0.0, 0.0}).parts), Eigen::Vector3d::Zero());
}

TEST(SceneOrigin, IsTheRoundedCenterOfFarParts)
{
  for (const Eigen::Vector3d& offset :
       {utmOffset(), Eigen::Vector3d(0.0, 0.0, -1001.0), Eigen::Vector3d(1e7, 0, 0)}) {
    const PartScene scene = thinParts(offset);
    const Eigen::Vector3d origin = sceneOrigin(scene.parts);
    EXPECT_EQ(origin, origin.array().round().matrix());
    // The parts are 5 x 4 x 3 m: within 4 m of the center of their box.
    for (const ConvexPart& part : scene.parts)
      for (const Eigen::Vector3d& vertex : part.hull.vertices)
        EXPECT_LT((vertex - origin).norm(), 4.0);
  }
}

TEST(PartMesh, KeepsMillimetersFarAway)
{
  const TemporaryFolder folder;
  const PartScene far = thinParts(utmOffset());
  for (const std::string format : {".obj", ".stl"}) {
    SceneDescription scene;
    scene.origin = sceneOrigin(far.parts);
    scene.mesh_extension = format;
    for (std::size_t i = 0; i < far.parts.size(); ++i) {
      const std::string path = folder.file(partFileName(i, scene));
      std::ostringstream stream;
      writePartMesh(stream, far.parts, i, scene);
      writeText(path, stream.str());
      const TriangleMesh mesh = format == ".obj" ? readOBJ(path).at(0) : readSTL(path);
      const TriangleMesh& hull = far.parts[i].hull;
      ASSERT_EQ(mesh.triangles.size(), hull.triangles.size());
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner)
          EXPECT_LT((mesh.vertices[mesh.triangles[t][corner]] + scene.origin -
                     hull.vertices[hull.triangles[t][corner]])
                        .norm(),
                    1e-6);
    }
  }
}

TEST(PartFileName, IsKnownAgain)
{
  SceneDescription scene;
  for (const std::string name : {"", "hall", "part", "hall_2", "hall_part"})
    for (const std::size_t part : {0u, 7u, 999u, 1000u, 123456u})
      for (const std::string format : {".obj", ".stl"}) {
        scene.name = name;
        scene.mesh_extension = format;
        const std::string file = partFileName(part, scene);
        for (const std::string other : {"", "hall", "part", "hall_2", "hall_part"})
          EXPECT_EQ(isPartFileName(file, other), other == name) << file << other;
      }
  scene.name = "hall";
  scene.mesh_extension = ".obj";
  EXPECT_EQ(partFileName(7, scene), "hall_part_007.obj");
  scene.name.clear();
  EXPECT_EQ(partFileName(7, scene), "part_007.obj");
  scene.mesh_extension = ".ply";
  EXPECT_THROW(partFileName(7, scene), CIDException);
  for (const char* const name : {"part_7.obj",
                                 "part_0007.obj",
                                 "part_007.OBJ",
                                 "part_007",
                                 "part_007.ply",
                                 "part_007.obj~",
                                 "part_+07.obj",
                                 "part_-07.obj",
                                 "part_.obj",
                                 "my_part_007.obj",
                                 "7.obj",
                                 "",
                                 "."})
    EXPECT_FALSE(isPartFileName(name, "")) << name;
  for (const char* const name : {"part_007.obj", "hall_part_7.obj", "hall_part_.obj"})
    EXPECT_FALSE(isPartFileName(name, "hall")) << name;
}

TEST(SceneFiles, NameTheFrameTheMeshesAndThePose)
{
  const PartScene far = thinParts(utmOffset());
  SceneDescription scene;
  scene.name = "hall";
  scene.frame = "survey";
  scene.origin = {524288.0, 4194305.0, 102.0};
  scene.mesh_folder = "scan_parts";
  scene.mesh_extension = ".stl";
  for (const Writer write : {writeURDF, writeSDF, writeMJCF}) {
    const std::string text = written(write, far.parts, scene);
    for (std::size_t i = 0; i < far.parts.size(); ++i)
      EXPECT_NE(text.find("scan_parts/" + partFileName(i, scene)), std::string::npos);
    EXPECT_NE(text.find("524288 4194305 102"), std::string::npos);
    EXPECT_EQ(text.find("scan_parts/hall_part_007"), std::string::npos);
  }
  EXPECT_NE(written(writeURDF, far.parts, scene).find("<link name=\"survey\">"),
            std::string::npos);
  EXPECT_NE(written(writeSDF, far.parts, scene).find("<link name=\"survey\">"),
            std::string::npos);
  scene.mesh_folder.clear();
  EXPECT_NE(written(writeURDF, far.parts, scene).find("\"hall_part_000.stl\""),
            std::string::npos);
  scene.frame.clear();
  for (const Writer write : {writeURDF, writeSDF})
    EXPECT_NE(written(write, far.parts, scene).find("<link name=\"hall\">"),
              std::string::npos);
  for (const char* const folder : {"package://robot/meshes", "package://robot/meshes/"})
    for (const Writer write : {writeURDF, writeSDF}) {
      scene.mesh_folder = folder;
      EXPECT_NE(written(write, far.parts, scene)
                    .find("package://robot/meshes/hall_part_000.stl"),
                std::string::npos);
    }
  scene.mesh_folder = "/";
  EXPECT_NE(written(writeMJCF, far.parts, scene).find("\"/hall_part_000.stl\""),
            std::string::npos);
}

TEST(SceneFiles, RefuseNamesThatTheFormatsCannotHold)
{
  const std::vector<ConvexPart> parts = thinParts(Eigen::Vector3d::Zero()).parts;
  SceneDescription line_break;
  line_break.name = "two\nlines";
  SceneDescription blank;
  blank.name = "a room";
  SceneDescription empty;
  empty.name = "";
  SceneDescription bad_folder;
  bad_folder.mesh_folder = "a\x01z";
  for (const Writer write : {writeURDF, writeSDF, writeMJCF, writeMoveItScene}) {
    EXPECT_THROW(written(write, parts, line_break), CIDException);
    EXPECT_THROW(written(write, parts, blank), CIDException);
    EXPECT_THROW(written(write, parts, empty), CIDException);
  }
  for (const Writer write : {writeURDF, writeSDF, writeMJCF})
    EXPECT_THROW(written(write, parts, bad_folder), CIDException);
  SceneDescription world;
  world.frame = "world";
  EXPECT_NO_THROW(written(writeURDF, parts, world));
  EXPECT_THROW(written(writeSDF, parts, world), CIDException);
  for (const char* const frame : {"", "world", "__map__", "a::b", "a\tb"})
    EXPECT_THROW(requireFrameForSDF(frame), CIDException) << frame;
  for (const char* const frame : {"map",
                                  "the world",
                                  "__map",
                                  "k\xC3\xBC"
                                  "che/1"})
    EXPECT_NO_THROW(requireFrameForSDF(frame)) << frame;
}

TEST(SceneFiles, RefuseFoldersThatTheirReadersDoNotFind)
{
  const std::vector<ConvexPart> parts = thinParts(Eigen::Vector3d::Zero()).parts;
  SceneDescription scene;
  for (const char* const uri : {"package://robot/meshes",
                                "model://kitchen",
                                "file:///data/my meshes",
                                "file:///",
                                "http://host/meshes",
                                "https://host/meshes"}) {
    scene.mesh_folder = uri;
    EXPECT_NO_THROW(written(writeURDF, parts, scene)) << uri;
    EXPECT_NO_THROW(written(writeSDF, parts, scene)) << uri;
    EXPECT_THROW(written(writeMJCF, parts, scene), CIDException) << uri;
  }
  for (const char* const uri :
       {"package://", "model://", "file://data", "https://", "ftp://host/a", "://a"}) {
    scene.mesh_folder = uri;
    for (const Writer write : {writeURDF, writeSDF, writeMJCF})
      EXPECT_THROW(written(write, parts, scene), CIDException) << uri;
  }
  for (const char* const path : {"", ".", "/", "../meshes", "/data/a b", "a:b"}) {
    scene.mesh_folder = path;
    for (const Writer write : {writeURDF, writeSDF, writeMJCF})
      EXPECT_NO_THROW(written(write, parts, scene)) << path;
  }
}

TEST(SceneFiles, HaveTheLayoutOfMoveItsText)
{
  ConvexPart part;
  part.hull.vertices = {{1, 2, 3}, {2, 2, 3}, {1, 3, 3}, {1, 2, 4.5}};
  part.hull.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  SceneDescription scene;
  scene.name = "kitchen";
  scene.origin = {1.0, 2.0, 0.0};
  std::string text = written(writeMoveItScene, {part}, scene);
  const std::size_t color = text.find("0 0 0 1\n", text.find("0 3 2\n")) + 8;
  text.erase(color, text.find('\n', color) - color); // whatever color it is
  EXPECT_EQ(text,
            "kitchen\n"
            "* kitchen_part_000\n"
            "1 2 0\n"
            "0 0 0 1\n"
            "1\n"
            "mesh\n"
            "4 4\n"
            "0 0 3\n"
            "1 0 3\n"
            "0 1 3\n"
            "0 0 4.5\n"
            "0 2 1\n"
            "0 1 3\n"
            "1 2 3\n"
            "0 3 2\n"
            "0 0 0\n"
            "0 0 0 1\n"
            "\n"
            "0\n"
            ".\n");
}

} // namespace
} // namespace pcl_cid::test
