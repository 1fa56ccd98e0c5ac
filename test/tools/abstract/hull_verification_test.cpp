/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What --verify says of files that do not hold what hulls guarantee.
 */

#include "abstract/hull_verification.h"

#include "cloud_files.h"
#include "clouds.h"
#include "part_scenes.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_formats.h>

#include <functional>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Change = std::function<void(TriangleMesh&)>;

Eigen::Vector3d
centroidOf(const TriangleMesh& hull)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : hull.vertices)
    sum += vertex;
  return sum / static_cast<double>(hull.vertices.size());
}

void
leaveAsItIs(TriangleMesh&)
{
}

void
loseATriangle(TriangleMesh& hull)
{
  hull.triangles.pop_back();
}

void
turnInsideOut(TriangleMesh& hull)
{
  for (auto& triangle : hull.triangles)
    std::swap(triangle[0], triangle[1]);
}

void
dent(TriangleMesh& hull)
{
  hull.vertices[0] = 0.5 * (hull.vertices[0] + centroidOf(hull));
}

void
shrink(TriangleMesh& hull)
{
  const Eigen::Vector3d centroid = centroidOf(hull);
  for (Eigen::Vector3d& vertex : hull.vertices)
    vertex = 0.9 * vertex + 0.1 * centroid;
}

/** A way to spoil a hull, and what must be said of it. */
struct Tampering {
  Change change;
  std::string complaint;
};

const std::vector<Tampering> tamperings{{turnInsideOut, "not oriented outward"},
                                        {dent, "not convex"},
                                        {shrink, "is not contained"}};

/** Two boxes of points and their hulls, of which the second is tampered with. */
class HullVerification : public testing::Test {
protected:
  HullVerification()
  {
    Points second = randomCube(50, 2);
    for (Eigen::Vector3f& point : second)
      point.x() += 3.0f;
    scene_ = partsOf("boxes", {randomCube(50, 1), second}, Eigen::Vector3d::Zero());
    abstracted_.parts = scene_.parts;
    Points all;
    for (const Eigen::Vector3d& point : scene_.points)
      all.push_back(point.cast<float>());
    points_.points = toCloud(all);
    cloud_ = toLabelledCloud(*points_.points);
    description_.origin = Eigen::Vector3d(1.0, 2.0, 3.0);
  }

  std::vector<ConvexPart>
  tamperedWith(const Change& change) const
  {
    std::vector<ConvexPart> parts = scene_.parts;
    change(parts[1].hull);
    return parts;
  }

  std::string
  file(const std::string& name) const
  {
    return folder_.file(name);
  }

  /** What is said of a mesh with these parts; nothing when all is well. */
  std::string
  complaintAbout(const std::vector<ConvexPart>& parts, const std::string& name) const
  {
    OutputFiles outputs({});
    outputs.announce(file(name));
    outputs.write(file(name),
                  [&](std::ostream& stream) { writeMesh(stream, parts, name); });
    return complaint([&] { verifyMesh(file(name), verification(), outputs); });
  }

  /** The same for a folder with a mesh for each part. */
  std::string
  complaintAboutFolder(const std::vector<ConvexPart>& parts, const std::string& format)
  {
    description_.mesh_extension = format;
    OutputFiles outputs({});
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string path = file(partFileName(i, description_));
      outputs.announce(path);
      outputs.write(path, [&](std::ostream& stream) {
        writePartMesh(stream, parts, i, description_);
      });
    }
    return complaint(
        [&] { verifyParts(file(""), description_, verification(), outputs); });
  }

  /** The same for a scene that holds its meshes. */
  std::string
  complaintAboutScene(const std::vector<ConvexPart>& parts, const SceneFormat& format)
  {
    const tools::SceneFile scene = {format, file("hulls" + format.extensions.front())};
    OutputFiles outputs({});
    outputs.announce(scene.path);
    outputs.write(scene.path, [&](std::ostream& stream) {
      format.write(stream, parts, description_);
    });
    return complaint(
        [&] { verifyMeshesOf(scene, description_, verification(), outputs); });
  }

  tools::Verification
  verification() const
  {
    return {abstracted_,
            points_.frame,
            tools::pointsOfParts(cloud_, abstracted_.parts),
            1.0,
            nullptr};
  }

  static std::string
  complaint(const std::function<void()>& verify)
  {
    try {
      verify();
    }
    catch (const CIDException& error) {
      return error.what();
    }
    return "";
  }

  /** File, part and guarantee. */
  void
  expectBroken(const std::string& said,
               const std::string& name,
               const std::string& guarantee) const
  {
    EXPECT_EQ(said.rfind(file(name) + ": verification: the hull of part_001 breaks a "
                                      "guarantee: ",
                         0),
              0u)
        << said;
    EXPECT_NE(said.find(guarantee), std::string::npos) << said;
  }

  TemporaryFolder folder_;
  PartScene scene_;
  CloudPoints points_;
  LabelledCloud cloud_;
  SceneDescription description_;
  tools::AbstractedScan abstracted_; ///< what the files are said to be of
};

TEST_F(HullVerification, PassesFilesAsTheyWereWritten)
{
  for (const char* const name : {"hulls.obj", "hulls.ply", "hulls.stl"})
    EXPECT_EQ(complaintAbout(tamperedWith(leaveAsItIs), name), "");
  for (const std::string format : {".obj", ".stl"})
    EXPECT_EQ(complaintAboutFolder(tamperedWith(leaveAsItIs), format), "");
}

TEST_F(HullVerification, NamesFilePartAndGuarantee)
{
  for (const auto& [change, guarantee] : tamperings)
    for (const char* const name : {"hulls.obj", "hulls.ply", "hulls.stl"})
      expectBroken(complaintAbout(tamperedWith(change), name), name, guarantee);
}

TEST_F(HullVerification, ChecksTheMeshesThatScenesHold)
{
  for (const char* const name : {"MoveIt", "glTF", "USD"}) {
    const SceneFormat& format = *findSceneFormat(name);
    const std::string file_name = "hulls" + format.extensions.front();
    EXPECT_EQ(complaintAboutScene(tamperedWith(leaveAsItIs), format), "");
    for (const auto& [change, guarantee] : tamperings)
      expectBroken(
          complaintAboutScene(tamperedWith(change), format), file_name, guarantee);
    EXPECT_EQ(complaintAboutScene({scene_.parts[0]}, format),
              file(file_name) + ": verification: the mesh of part_001 is missing");
    std::vector<ConvexPart> one_more = scene_.parts;
    one_more.push_back(scene_.parts[0]);
    EXPECT_EQ(complaintAboutScene(one_more, format),
              file(file_name) + ": verification: it has 3 meshes; it must have 2");
  }
}

TEST_F(HullVerification, NamesTheFileOfThePart)
{
  for (const auto& [change, guarantee] : tamperings)
    for (const std::string format : {".obj", ".stl"})
      expectBroken(complaintAboutFolder(tamperedWith(change), format),
                   "convex_parts_part_001" + format,
                   guarantee);
}

TEST_F(HullVerification, FindsAHoleInTheSurface)
{
  const std::vector<ConvexPart> parts = tamperedWith(loseATriangle);
  for (const char* const name : {"hulls.obj", "hulls.ply"})
    expectBroken(complaintAbout(parts, name), name, "not closed");
  // An STL has nothing but triangles.
  const std::string said = complaintAbout(parts, "hulls.stl");
  EXPECT_NE(said.find(file("hulls.stl")), std::string::npos) << said;
  EXPECT_NE(said.find("triangles; the parts have"), std::string::npos) << said;
}

TEST_F(HullVerification, FindsThatAHullIsMissing)
{
  for (const char* const name : {"hulls.obj", "hulls.ply"}) {
    const std::string said = complaintAbout({scene_.parts[0]}, name);
    EXPECT_EQ(said, file(name) + ": verification: it has 1 hulls; it must have 2");
  }
}

TEST_F(HullVerification, HoldsHullsToTheOptions)
{
  abstracted_.hull_options.max_vertices = 4;
  EXPECT_NE(complaintAbout(scene_.parts, "hulls.ply").find("too many vertices"),
            std::string::npos);
  abstracted_.hull_options = {};
  abstracted_.hull_options.min_thickness = 2.0; // the boxes are 1 m wide
  EXPECT_NE(complaintAbout(scene_.parts, "hulls.ply").find("too thin"),
            std::string::npos);
  abstracted_.hull_options = {};
  abstracted_.hull_options.padding = 0.1;
  EXPECT_NE(complaintAbout(scene_.parts, "hulls.ply").find("is not contained"),
            std::string::npos);
}

} // namespace
} // namespace pcl_cid::test
