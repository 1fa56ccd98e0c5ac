/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The table of mesh formats: what follows from a row, and a format added from outside.
 */

#include "cloud_files.h"
#include "part_scenes.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>
#include <pcl_cid/io/scene_export.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

std::vector<ConvexPart>
someParts()
{
  return thinParts(Eigen::Vector3d::Zero()).parts;
}

/** What a writer prints. */
template <typename Writer>
std::string
printed(const Writer& writer)
{
  std::ostringstream stream;
  writer(stream);
  return stream.str();
}

std::string
meshNamed(const std::string& path)
{
  return printed([&](std::ostream& s) { writeMesh(s, someParts(), path); });
}

TEST(WriteMesh, ChoosesTheWriterByTheName)
{
  const std::vector<ConvexPart> parts = someParts();
  EXPECT_EQ(meshNamed("out/hulls.OBJ"),
            printed([&](std::ostream& s) { writeOBJ(s, parts, "hulls.mtl"); }));
  EXPECT_EQ(meshNamed("hulls.ply"),
            printed([&](std::ostream& s) { writePLY(s, parts); }));
  EXPECT_EQ(meshNamed("hulls.stl"),
            printed([&](std::ostream& s) { writeSTL(s, parts); }));
}

TEST(WriteMesh, NeverTakesOneFormatForAnother)
{
  for (const char* const path : {"hulls.off", "hulls", "hulls.obj.gz", ".stl", ""})
    try {
      meshNamed(path);
      FAIL() << path << " was written";
    }
    catch (const CIDException& error) {
      EXPECT_NE(std::string(error.what()).find("a mesh is written as .obj"),
                std::string::npos)
          << error.what();
    }
}

TEST(Materials, StandBesideAnOBJOnly)
{
  EXPECT_EQ(materialsBeside("out/hulls.obj"), "out/hulls.mtl");
  EXPECT_EQ(materialsBeside("my rooms/my hulls.v2.obj"), "my rooms/my_hulls.v2.mtl");
  EXPECT_EQ(materialsBeside("hulls.ply"), "");
  EXPECT_EQ(materialsBeside("hulls.stl"), "");
  EXPECT_THROW(materialsBeside("hulls.pcd"), CIDException);
  const std::vector<ConvexPart> parts = someParts();
  EXPECT_EQ(printed([&](std::ostream& s) { writeMaterials(s, parts, "hulls.obj"); }),
            printed([&](std::ostream& s) { writeMTL(s, parts); }));
  EXPECT_EQ(printed([&](std::ostream& s) { writeMaterials(s, parts, "hulls.ply"); }),
            "");
}

TEST(MeshFormats, SayWhatTheyKeep)
{
  for (const MeshFormat& format : meshFormats()) {
    std::ostringstream text;
    format.write(text, someParts(), "colors", "hall");
    EXPECT_EQ(text.str().find("hall_part_000") != std::string::npos, format.names_parts)
        << format.name;
  }
  EXPECT_FALSE(meshFormatOf("a.obj").is_float);
  EXPECT_TRUE(meshFormatOf("a.obj").has_parts);
  EXPECT_FALSE(meshFormatOf("a.ply").is_float);
  EXPECT_TRUE(meshFormatOf("a.ply").has_parts);
  EXPECT_TRUE(meshFormatOf("a.stl").is_float);
  EXPECT_FALSE(meshFormatOf("a.stl").has_parts);
  const std::vector<std::string> extensions = meshExtensions();
  EXPECT_EQ(std::count(extensions.begin(), extensions.end(), ".ply"), 1);
  const std::vector<std::string> for_scenes = partMeshExtensions();
  EXPECT_EQ(std::count(for_scenes.begin(), for_scenes.end(), ".ply"), 0);
}

TEST(MeshFormats, ReadWhatTheyWrite)
{
  const TemporaryFolder folder;
  for (const std::string extension : {".obj", ".ply", ".stl"}) {
    const std::string path = folder.file("hulls" + extension);
    writeText(path, meshNamed(path));
    EXPECT_EQ(meshFormatOf(path).read(path).size(),
              meshFormatOf(path).has_parts ? someParts().size() : 1u);
  }
}

/** A toy: the number of triangles of each mesh. */
MeshFormat
countsFormat()
{
  MeshFormat format;
  format.name = "COUNTS";
  format.extensions = {".counts"};
  format.materials_extension = ".colors";
  format.write = [](std::ostream& stream,
                    const std::vector<ConvexPart>& parts,
                    const std::string& materials,
                    const std::string&) {
    stream << materials;
    for (const ConvexPart& part : parts)
      stream << ' ' << part.hull.triangles.size();
  };
  format.write_materials = [](std::ostream& stream,
                              const std::vector<ConvexPart>&,
                              const std::string&) { stream << "gray"; };
  format.write_mesh =
      [](std::ostream& stream, const TriangleMesh& mesh, const std::string& name) {
        stream << name << ' ' << mesh.triangles.size();
      };
  return format;
}

TEST(RegisteredMeshFormat, IsKnownToScenesToo)
{
  const std::vector<std::string> known = meshExtensions();
  if (std::count(known.begin(), known.end(), ".counts") == 0) // tests may be repeated
    registerMeshFormat(countsFormat());
  const std::string triangles = std::to_string(someParts()[0].hull.triangles.size());
  EXPECT_EQ(meshNamed("x/hulls.counts").rfind("hulls.colors " + triangles, 0), 0u);
  EXPECT_EQ(materialsBeside("x/hulls.counts"), "x/hulls.colors");

  SceneDescription scene;
  scene.mesh_extension = ".counts";
  EXPECT_EQ(printed([&](std::ostream& s) { writePartMesh(s, someParts(), 0, scene); }),
            "convex_parts_part_000 " + triangles);
  EXPECT_NE(printed([&](std::ostream& s) {
              writeURDF(s, someParts(), scene);
            }).find("part_000.counts"),
            std::string::npos);
  EXPECT_TRUE(isPartFileName("part_007.counts", ""));

  EXPECT_THROW(registerMeshFormat(countsFormat()), CIDException);
  MeshFormat half = countsFormat();
  half.name = "HALF";
  half.extensions = {".half"};
  half.materials_extension = "";
  EXPECT_THROW(registerMeshFormat(half), CIDException);
  half.materials_extension = ".colors";
  half.write = nullptr;
  EXPECT_THROW(registerMeshFormat(half), CIDException);
}

} // namespace
} // namespace pcl_cid::test
