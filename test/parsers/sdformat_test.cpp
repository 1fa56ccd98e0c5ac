/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * SDF opened by libsdformat, Gazebo's parser.
 */

#include "composed_scenes.h"
#include "exported_scene.h"
#include "simple_bodies.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_formats.h>

#include <filesystem>

#include <gtest/gtest.h>
#include <sdf/sdf.hh>

namespace pcl_cid::test {
namespace {

void
expectMesh(const sdf::Geometry& geometry,
           const ignition::math::Pose3d& pose,
           std::size_t part,
           const ExportedScene& exported)
{
  ASSERT_EQ(geometry.Type(), sdf::GeometryType::MESH);
  const std::string uri = geometry.MeshShape()->Uri();
  EXPECT_TRUE(std::filesystem::equivalent(exported.referred(uri), exported.mesh(part)))
      << uri;
  const Eigen::Vector3d& origin = exported.description().origin;
  EXPECT_EQ(pose, ignition::math::Pose3d(origin.x(), origin.y(), origin.z(), 0, 0, 0));
}

/** What is a warning otherwise is an error. */
sdf::ParserConfig
strict()
{
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::ERR);
  return config;
}

bool
isConvexForDrake(const sdf::ElementPtr& mesh)
{
  return mesh->HasElement("drake:declare_convex");
}

TEST(SDFormat, FindsACollisionAndAVisualForEachPart)
{
  forEachExportedScene([](const ExportedScene& exported) {
    sdf::Root root;
    for (const sdf::Error& error : root.Load(exported.file("scene.sdf"), strict()))
      ADD_FAILURE() << error.Message();
    EXPECT_EQ(root.Element()->OriginalVersion(), "1.9");
    ASSERT_NE(root.Model(), nullptr);
    const sdf::Model& model = *root.Model();
    EXPECT_EQ(model.Name(), exported.description().name);
    EXPECT_TRUE(model.Static());
    ASSERT_EQ(model.LinkCount(), 1u);
    const sdf::Link& link = *model.LinkByIndex(0);
    EXPECT_EQ(link.Name(), exported.description().frame);
    ASSERT_EQ(link.CollisionCount(), exported.parts().size());
    ASSERT_EQ(link.VisualCount(), exported.parts().size());
    for (std::size_t i = 0; i < exported.parts().size(); ++i) {
      const sdf::Collision& collision = *link.CollisionByIndex(i);
      EXPECT_EQ(collision.Name(), exported.partName(i));
      expectMesh(*collision.Geom(), collision.RawPose(), i, exported);
      EXPECT_TRUE(isConvexForDrake(collision.Geom()->MeshShape()->Element()));
      const sdf::Visual& visual = *link.VisualByIndex(i);
      expectMesh(*visual.Geom(), visual.RawPose(), i, exported);
      EXPECT_FALSE(isConvexForDrake(visual.Geom()->MeshShape()->Element()));
      ASSERT_NE(visual.Material(), nullptr);
      EXPECT_NEAR(visual.Material()->Diffuse().B(), partColor(i).blue / 255.0, 1e-6);
    }
  });
}

/** All parts of both scenes, in one model or in two.
 *  \param[in] links of the scenes, in their order */
void
expectParts(const std::vector<const sdf::Link*>& links, const ComposedScenes& scenes)
{
  for (std::size_t k = 0; k < links.size(); ++k) {
    const ComposedScenes::Member& member = scenes.members()[k];
    ASSERT_NE(links[k], nullptr);
    ASSERT_EQ(links[k]->CollisionCount(), member.parts().size());
    for (std::size_t i = 0; i < member.parts().size(); ++i) {
      const sdf::Collision* collision = links[k]->CollisionByName(member.partName(i));
      ASSERT_NE(collision, nullptr) << member.partName(i);
      EXPECT_EQ(collision->Geom()->MeshShape()->Uri(),
                "model://rooms/" + partFileName(i, member.description));
      const Eigen::Vector3d& origin = member.description.origin;
      EXPECT_EQ(collision->RawPose(),
                ignition::math::Pose3d(origin.x(), origin.y(), origin.z(), 0, 0, 0));
    }
  }
}

TEST(SDFormat, IncludesTwoScenesInOneWorldOrModel)
{
  forEachComposition("model://rooms", [](const ComposedScenes& scenes) {
    sdf::ParserConfig config = strict();
    config.SetFindCallback(
        [&](const std::string& uri) { return scenes.file("scenes/" + uri); });
    const auto including = [](const std::string& attribute) {
      return "<include" + attribute + "><uri>hall.sdf</uri></include><include" +
             attribute + "><uri>kitchen.sdf</uri></include>";
    };
    sdf::Root root;
    for (const sdf::Error& error :
         root.LoadSdfString("<sdf version=\"1.9\"><world name=\"all\">" +
                                including("") + "</world></sdf>",
                            config))
      ADD_FAILURE() << error.Message();
    const sdf::World& world = *root.WorldByIndex(0);
    ASSERT_EQ(world.ModelCount(), 2u);
    expectParts({world.ModelByName("hall")->LinkByName("hall"),
                 world.ModelByName("kitchen")->LinkByName("kitchen")},
                scenes);
    // Links and all else side by side in one model.
    sdf::Root merged;
    for (const sdf::Error& error :
         merged.LoadSdfString("<sdf version=\"1.9\"><model name=\"both\">" +
                                  including(" merge=\"true\"") + "</model></sdf>",
                              config))
      ADD_FAILURE() << error.Message();
    ASSERT_EQ(merged.Model()->LinkCount(), 2u);
    expectParts(
        {merged.Model()->LinkByName("hall"), merged.Model()->LinkByName("kitchen")},
        scenes);
  });
}

TEST(SDFormat, ReservesTheNamesThatWeRefuse)
{
  const std::vector<ConvexPart> parts = thinParts(Eigen::Vector3d::Zero()).parts;
  std::ostringstream text;
  writeSDF(text, parts, {});
  const auto has_errors = [&](const std::string& frame) {
    std::string renamed = text.str();
    const std::string link = "<link name=\"convex_parts\">";
    renamed.replace(renamed.find(link), link.size(), "<link name=\"" + frame + "\">");
    sdf::Root root;
    return !root.LoadSdfString(renamed).empty();
  };
  for (const char* const frame : {"world", "__map__", "a::b"}) {
    EXPECT_TRUE(has_errors(frame)) << frame;
    EXPECT_THROW(requireFrameForSDF(frame), CIDException) << frame;
  }
  for (const char* const frame : {"map",
                                  "worlds",
                                  "__map",
                                  "a:b",
                                  "k\xC3\xBC"
                                  "che/1"}) {
    EXPECT_FALSE(has_errors(frame)) << frame;
    EXPECT_NO_THROW(requireFrameForSDF(frame)) << frame;
  }
}

HullPrimitive
readShape(const sdf::Collision& collision)
{
  HullPrimitive read;
  const ignition::math::Pose3d& pose = collision.RawPose();
  read.center = {pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()};
  read.axes =
      Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z())
          .toRotationMatrix();
  const sdf::Geometry& shape = *collision.Geom();
  if (shape.Type() == sdf::GeometryType::BOX) {
    const auto size = shape.BoxShape()->Size();
    read.extents = {size.X(), size.Y(), size.Z()};
  }
  else if (shape.Type() == sdf::GeometryType::SPHERE) {
    read.kind = HullPrimitive::Kind::sphere;
    read.extents.setConstant(2.0 * shape.SphereShape()->Radius());
  }
  else if (shape.Type() == sdf::GeometryType::CYLINDER) {
    read.kind = HullPrimitive::Kind::cylinder;
    const double width = 2.0 * shape.CylinderShape()->Radius();
    read.extents = {width, width, shape.CylinderShape()->Length()};
  }
  else if (shape.Type() == sdf::GeometryType::CAPSULE) {
    read.kind = HullPrimitive::Kind::capsule;
    const double width = 2.0 * shape.CapsuleShape()->Radius();
    read.extents = {width, width, width + shape.CapsuleShape()->Length()};
  }
  return read;
}

TEST(SDFormat, ReadsPrimitivesThatHoldThePointsOfTheirParts)
{
  for (const Eigen::Vector3d& offset :
       {Eigen::Vector3d(Eigen::Vector3d::Zero()), utmOffset()}) {
    const SimpleBodies bodies =
        simpleBodies(findSceneFormat("SDF")->primitives, offset);
    sdf::Root root;
    for (const sdf::Error& error : root.LoadSdfString(bodies.textIn("SDF")))
      ADD_FAILURE() << error.Message();
    const sdf::Link& link = *root.Model()->LinkByIndex(0);
    ASSERT_EQ(link.CollisionCount(), bodies.content.parts.size());
    for (std::size_t i = 0; i < 4; ++i)
      expectHolds(readShape(*link.CollisionByIndex(i)), bodies, i);
    EXPECT_EQ(link.CollisionByIndex(4)->Geom()->Type(), sdf::GeometryType::MESH);
  }
}

} // namespace
} // namespace pcl_cid::test
