/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * URDF opened by urdfdom, ROS's parser, and by its tool check_urdf.
 */

#include "composed_scenes.h"
#include "exported_scene.h"
#include "simple_bodies.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_formats.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

namespace pcl_cid::test {
namespace {

/** What a command prints, and how it ends. */
std::pair<std::string, int>
outputOf(const std::string& command)
{
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), count);
  return {output, pclose(pipe)};
}

Eigen::Vector3d
positionOf(const urdf::Pose& pose)
{
  return {pose.position.x, pose.position.y, pose.position.z};
}

/** A shape of the link: which file, where. */
void
expectMesh(const urdf::Geometry& geometry,
           const urdf::Pose& pose,
           std::size_t part,
           const ExportedScene& exported)
{
  ASSERT_EQ(geometry.type, urdf::Geometry::MESH);
  const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
  EXPECT_TRUE(std::filesystem::equivalent(exported.referred(mesh.filename),
                                          exported.mesh(part)))
      << mesh.filename;
  EXPECT_EQ(positionOf(pose), exported.description().origin);
  EXPECT_EQ(mesh.scale.x, 1.0);
}

TEST(Urdfdom, FindsACollisionAndAVisualForEachPart)
{
  forEachExportedScene([](const ExportedScene& exported) {
    const auto model = urdf::parseURDFFile(exported.file("scene.urdf"));
    ASSERT_TRUE(model);
    EXPECT_EQ(model->getName(), exported.description().name);
    ASSERT_EQ(model->links_.size(), 1u);
    ASSERT_TRUE(model->getRoot());
    const urdf::Link& link = *model->getRoot();
    EXPECT_EQ(link.name, exported.description().frame);
    ASSERT_EQ(link.collision_array.size(), exported.parts().size());
    ASSERT_EQ(link.visual_array.size(), exported.parts().size());
    for (std::size_t i = 0; i < exported.parts().size(); ++i) {
      const urdf::Collision& collision = *link.collision_array[i];
      EXPECT_EQ(collision.name, exported.partName(i));
      expectMesh(*collision.geometry, collision.origin, i, exported);
      const urdf::Visual& visual = *link.visual_array[i];
      expectMesh(*visual.geometry, visual.origin, i, exported);
      ASSERT_TRUE(visual.material);
      EXPECT_NEAR(visual.material->color.g, partColor(i).green / 255.0, 1e-6);
      EXPECT_EQ(visual.material->color.a, 1.0f);
    }
  });
}

TEST(Urdfdom, HasNothingAgainstTheFileInItsTool)
{
  forEachExportedScene([](const ExportedScene& exported) {
    const auto [output, status] =
        outputOf(PCL_CID_CHECK_URDF " \"" + exported.file("scene.urdf") + "\"");
    EXPECT_EQ(status, 0) << output;
    EXPECT_NE(output.find("Successfully Parsed XML"), std::string::npos) << output;
    EXPECT_NE(output.find("root Link: survey"), std::string::npos) << output;
    EXPECT_EQ(output.find("Error"), std::string::npos) << output;
    EXPECT_EQ(output.find("Warning"), std::string::npos) << output;
  });
}

/** What is between the robot's tags. */
std::string
linkIn(const std::string& urdf)
{
  const std::size_t first = urdf.find("  <link");
  return urdf.substr(first, urdf.rfind("</robot>") - first);
}

/** As xacro puts them together: both links, held by joints to one more. */
TEST(Urdfdom, TakesTwoScenesInOneRobot)
{
  const std::string uri = "package://my_robot/meshes";
  forEachComposition(uri, [&](const ComposedScenes& scenes) {
    std::string text = "<robot name=\"both\"><link name=\"map\"/>";
    for (const ComposedScenes::Member& member : scenes.members()) {
      const std::string& name = member.description.name;
      text += linkIn(readText(scenes.file("scenes/" + name + ".urdf"))) +
              "<joint name=\"to_" + name +
              "\" type=\"fixed\"><parent link=\"map\"/><child link=\"" + name +
              "\"/></joint>";
    }
    writeText(scenes.file("both.urdf"), text + "</robot>");
    const auto [output, status] =
        outputOf(PCL_CID_CHECK_URDF " " + scenes.file("both.urdf"));
    EXPECT_EQ(status, 0) << output;
    EXPECT_EQ(output.find("Error"), std::string::npos) << output;
    const auto model = urdf::parseURDFFile(scenes.file("both.urdf"));
    ASSERT_TRUE(model);
    ASSERT_EQ(model->links_.size(), 3u);
    // Materials belong to the robot: each part has its own.
    EXPECT_EQ(model->materials_.size(), scenes.numberOfParts());
    for (const ComposedScenes::Member& member : scenes.members()) {
      const urdf::Link& link = *model->getLink(member.description.name);
      ASSERT_EQ(link.collision_array.size(), member.parts().size());
      for (std::size_t i = 0; i < member.parts().size(); ++i) {
        EXPECT_EQ(link.collision_array[i]->name, member.partName(i));
        const auto& mesh =
            static_cast<const urdf::Mesh&>(*link.collision_array[i]->geometry);
        EXPECT_EQ(mesh.filename, uri + "/" + partFileName(i, member.description));
        EXPECT_NEAR(
            link.visual_array[i]->material->color.r, partColor(i).red / 255.0, 1e-6);
      }
    }
  });
}

HullPrimitive
readShape(const urdf::Collision& collision)
{
  HullPrimitive read;
  read.center = positionOf(collision.origin);
  const urdf::Rotation& turn = collision.origin.rotation;
  read.axes = Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z).toRotationMatrix();
  if (collision.geometry->type == urdf::Geometry::BOX) {
    const urdf::Vector3& size = static_cast<const urdf::Box&>(*collision.geometry).dim;
    read.extents = {size.x, size.y, size.z};
  }
  else if (collision.geometry->type == urdf::Geometry::SPHERE) {
    read.kind = HullPrimitive::Kind::sphere;
    read.extents.setConstant(
        2.0 * static_cast<const urdf::Sphere&>(*collision.geometry).radius);
  }
  else {
    const auto& rod = static_cast<const urdf::Cylinder&>(*collision.geometry);
    read.kind = HullPrimitive::Kind::cylinder;
    read.extents = {2.0 * rod.radius, 2.0 * rod.radius, rod.length};
  }
  return read;
}

TEST(Urdfdom, ReadsPrimitivesThatHoldThePointsOfTheirParts)
{
  for (const Eigen::Vector3d& offset :
       {Eigen::Vector3d(Eigen::Vector3d::Zero()), utmOffset()}) {
    const SimpleBodies bodies =
        simpleBodies(findSceneFormat("URDF")->primitives, offset);
    const auto model = urdf::parseURDF(bodies.textIn("URDF"));
    ASSERT_TRUE(model);
    const auto& collisions = model->getRoot()->collision_array;
    ASSERT_EQ(collisions.size(), bodies.content.parts.size());
    for (std::size_t i = 0; i < 3; ++i)
      expectHolds(readShape(*collisions[i]), bodies, i);
    EXPECT_EQ(collisions[4]->geometry->type, urdf::Geometry::MESH);
  }
}

} // namespace
} // namespace pcl_cid::test
