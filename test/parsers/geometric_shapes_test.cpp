/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * MoveIt's text form, its meshes opened by geometric_shapes, which MoveIt uses.
 */

#include "exported_scene.h"
#include "simple_bodies.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_formats.h>

#include <fstream>
#include <limits>
#include <memory>

#include <geometric_shapes/bodies.h>
#include <geometric_shapes/body_operations.h>
#include <geometric_shapes/shape_operations.h>
#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** An object of a scene. */
struct SceneObject {
  std::string name;
  Eigen::Isometry3d pose;
  std::unique_ptr<shapes::Shape> shape;
  Eigen::Vector4d color;
};

Eigen::Isometry3d
readPose(std::istream& in)
{
  double x, y, z, qx, qy, qz, qw;
  in >> x >> y >> z >> qx >> qy >> qz >> qw;
  return Eigen::Translation3d(x, y, z) * Eigen::Quaterniond(qw, qx, qy, qz);
}

/** Reads a scene in the steps in which MoveIt does it: name, then objects, each of one
 * shape, up to a dot. */
std::vector<SceneObject>
readScene(const std::string& path, std::string& name)
{
  std::ifstream in(path);
  std::getline(in, name);
  std::vector<SceneObject> objects;
  for (std::string marker; in >> marker && marker == "*";) {
    SceneObject object;
    in >> object.name;
    const Eigen::Isometry3d object_pose = readPose(in);
    std::size_t shapes = 0;
    in >> shapes;
    EXPECT_EQ(shapes, 1u);
    object.shape.reset(shapes::constructShapeFromText(in));
    object.pose = object_pose * readPose(in);
    Eigen::Vector4d& c = object.color;
    in >> c[0] >> c[1] >> c[2] >> c[3];
    std::size_t subframes = 1;
    in >> subframes;
    EXPECT_EQ(subframes, 0u);
    EXPECT_TRUE(in.good());
    objects.push_back(std::move(object));
  }
  in.clear();
  in.seekg(-2, std::ios::end);
  std::string last;
  std::getline(in, last);
  EXPECT_EQ(last, ".");
  return objects;
}

TEST(GeometricShapes, FindsAnObjectForEachPart)
{
  forEachExportedScene([](const ExportedScene& exported) {
    std::string name;
    const auto objects = readScene(exported.file("scene.scene"), name);
    EXPECT_EQ(name, exported.description().name);
    ASSERT_EQ(objects.size(), exported.parts().size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const TriangleMesh& hull = exported.parts()[i].hull;
      EXPECT_EQ(objects[i].name, exported.partName(i));
      EXPECT_NEAR(objects[i].color[0], partColor(i).red / 255.0, 1e-6);
      EXPECT_EQ(objects[i].color[3], 1.0);
      ASSERT_TRUE(objects[i].shape);
      ASSERT_EQ(objects[i].shape->type, shapes::MESH);
      const auto& mesh = static_cast<const shapes::Mesh&>(*objects[i].shape);
      ASSERT_EQ(mesh.vertex_count, hull.vertices.size());
      ASSERT_EQ(mesh.triangle_count, hull.triangles.size());
      for (unsigned int t = 0; t < mesh.triangle_count; ++t)
        for (unsigned int corner = 0; corner < 3; ++corner)
          EXPECT_EQ(mesh.triangles[3 * t + corner], hull.triangles[t][corner]);
      for (unsigned int v = 0; v < mesh.vertex_count; ++v) {
        const Eigen::Map<const Eigen::Vector3d> vertex(mesh.vertices + 3 * v);
        EXPECT_LT((objects[i].pose * vertex - hull.vertices[v]).norm(), 1e-9);
      }
    }
  });
}

TEST(GeometricShapes, ContainsThePointsOfThePart)
{
  forEachExportedScene([](const ExportedScene& exported) {
    std::string name;
    const auto objects = readScene(exported.file("scene.scene"), name);
    ASSERT_EQ(objects.size(), exported.parts().size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const ConvexPart& part = exported.parts()[i];
      bodies::ConvexMesh body(objects[i].shape.get());
      body.setPose(objects[i].pose);
      // What a hull is guaranteed to contain its points to, and a rounding of its own.
      body.setPadding(1e-5 * boxOf(part.hull).diagonal().norm() + 1e-6);
      for (const pcl::index_t point : part.indices)
        EXPECT_TRUE(body.containsPoint(
            exported.content().points[static_cast<std::size_t>(point)]))
            << name << " " << partName(i) << " " << point;
      // And nothing beyond it: its corners, moved outward by half its size.
      for (const Eigen::Vector3d& vertex : part.hull.vertices)
        EXPECT_FALSE(body.containsPoint(vertex + 0.5 * (vertex - middleOf(part.hull))));
    }
  });
}

TEST(GeometricShapes, ReadsPrimitivesThatHoldThePointsOfTheirParts)
{
  for (const Eigen::Vector3d& offset :
       {Eigen::Vector3d(Eigen::Vector3d::Zero()), utmOffset()}) {
    const SimpleBodies simple =
        simpleBodies(findSceneFormat("MoveIt")->primitives, offset);
    const TemporaryFolder folder;
    writeText(folder.file("bodies.scene"), simple.textIn("MoveIt"));
    std::string name;
    const auto objects = readScene(folder.file("bodies.scene"), name);
    ASSERT_EQ(objects.size(), simple.content.parts.size());
    const shapes::ShapeType types[] = {
        shapes::BOX, shapes::SPHERE, shapes::CYLINDER, shapes::CYLINDER};
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const HullPrimitive* primitive = primitiveOf(i, simple.description);
      ASSERT_TRUE(objects[i].shape);
      if (!primitive) {
        EXPECT_EQ(objects[i].shape->type, shapes::MESH);
        continue;
      }
      EXPECT_EQ(objects[i].shape->type, types[i]);
      const std::unique_ptr<bodies::Body> body(
          bodies::createBodyFromShape(objects[i].shape.get()));
      body->setPose(objects[i].pose);
      for (const pcl::index_t point : simple.content.parts[i].indices)
        EXPECT_TRUE(
            body->containsPoint(simple.content.points[static_cast<std::size_t>(point)]))
            << partName(i);
      EXPECT_NEAR(body->computeVolume(), volumeOf(*primitive), 1e-6);
    }
    EXPECT_FALSE(primitiveOf(4, simple.description));
    EXPECT_TRUE(primitiveOf(2, simple.description));
  }
}

} // namespace
} // namespace pcl_cid::test
