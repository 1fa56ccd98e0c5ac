/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * MJCF compiled and simulated by MuJoCo.
 */

#include "composed_scenes.h"
#include "exported_scene.h"
#include "simple_bodies.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_formats.h>

#include <array>
#include <fstream>
#include <memory>
#include <set>

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

namespace pcl_cid::test {
namespace {

struct Free {
  void
  operator()(mjModel* model) const
  {
    mj_deleteModel(model);
  }

  void
  operator()(mjData* data) const
  {
    mj_deleteData(data);
  }
};

/** A model and its state. */
class Simulation {
public:
  explicit Simulation(const std::string& path)
  {
    std::array<char, 1000> error{};
    model.reset(mj_loadXML(path.c_str(), nullptr, error.data(), error.size()));
    if (!model)
      throw std::runtime_error(path + ": " + error.data());
    data.reset(mj_makeData(model.get()));
  }

  void
  runTo(double seconds)
  {
    while (data->time < seconds)
      mj_step(model.get(), data.get());
  }

  std::string
  nameOf(int type, int id) const
  {
    const char* const name = mj_id2name(model.get(), type, id);
    return name == nullptr ? "" : name;
  }

  std::unique_ptr<mjModel, Free> model;
  std::unique_ptr<mjData, Free> data;
};

/** Box around a mesh geom in the world. */
Eigen::AlignedBox3d
boxOfGeom(const Simulation& simulation, int geom)
{
  const mjModel& model = *simulation.model;
  const int mesh = model.geom_dataid[geom];
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(
      simulation.data->geom_xmat + 9 * geom);
  const Eigen::Map<const Eigen::Vector3d> position(simulation.data->geom_xpos +
                                                   3 * geom);
  Eigen::AlignedBox3d box;
  for (int i = 0; i < model.mesh_vertnum[mesh]; ++i) {
    const Eigen::Map<const Eigen::Vector3f> vertex(model.mesh_vert +
                                                   3 * (model.mesh_vertadr[mesh] + i));
    box.extend((rotation * vertex.cast<double>() + position).eval());
  }
  return box;
}

TEST(MuJoCo, CompilesAGeomForEachPartAndSteps)
{
  forEachExportedScene([](const ExportedScene& exported) {
    Simulation simulation(exported.file("scene.xml"));
    const auto parts = static_cast<int>(exported.parts().size());
    ASSERT_EQ(simulation.model->nmesh, parts);
    ASSERT_EQ(simulation.model->ngeom, parts);
    mj_step(simulation.model.get(), simulation.data.get());
    EXPECT_GT(simulation.data->time, 0.0);
    for (int i = 0; i < parts; ++i) {
      EXPECT_EQ(simulation.nameOf(mjOBJ_GEOM, i), exported.partName(i));
      const Eigen::AlignedBox3d expected = boxOf(exported.parts()[i].hull);
      const Eigen::AlignedBox3d box = boxOfGeom(simulation, i);
      EXPECT_LT((box.min() - expected.min()).norm(), 1e-5) << partName(i);
      EXPECT_LT((box.max() - expected.max()).norm(), 1e-5) << partName(i);
    }
  });
}

/** MuJoCo keeps a vertex for each corner of an OBJ's triangles. */
std::size_t
distinctVertices(const mjModel& model, int mesh)
{
  std::set<std::array<float, 3>> vertices;
  for (int i = 0; i < model.mesh_vertnum[mesh]; ++i) {
    const float* const v = model.mesh_vert + 3 * (model.mesh_vertadr[mesh] + i);
    vertices.insert({v[0], v[1], v[2]});
  }
  return vertices.size();
}

/** A model that includes both scenes.
 *  \param[in] compiler of its own */
std::string
including(const ComposedScenes& scenes, const std::string& compiler = "")
{
  std::string text = "<mujoco>" + compiler;
  for (const ComposedScenes::Member& member : scenes.members())
    text += "<include file=\"scenes/" + member.description.name + ".xml\"/>";
  const std::string path = scenes.file("both.xml");
  writeText(path, text + "</mujoco>");
  return path;
}

/** Each part once, where it is, in its color, with all its vertices. */
void
expectAllParts(const Simulation& simulation, const ComposedScenes& scenes)
{
  const mjModel& model = *simulation.model;
  ASSERT_EQ(model.ngeom, static_cast<int>(scenes.numberOfParts()));
  ASSERT_EQ(model.nmesh, model.ngeom);
  for (const ComposedScenes::Member& member : scenes.members())
    for (std::size_t i = 0; i < member.parts().size(); ++i) {
      const std::string name = member.partName(i);
      const int geom = mj_name2id(&model, mjOBJ_GEOM, name.c_str());
      ASSERT_GE(geom, 0) << name;
      const int mesh = model.geom_dataid[geom];
      EXPECT_EQ(simulation.nameOf(mjOBJ_MESH, mesh), name);
      const TriangleMesh& hull = member.parts()[i].hull;
      EXPECT_EQ(distinctVertices(model, mesh), hull.vertices.size()) << name;
      EXPECT_EQ(model.mesh_facenum[mesh], static_cast<int>(hull.triangles.size()));
      EXPECT_NEAR(model.geom_rgba[4 * geom], partColor(i).red / 255.0, 1e-6);
      const Eigen::AlignedBox3d expected = boxOf(hull);
      const Eigen::AlignedBox3d box = boxOfGeom(simulation, geom);
      EXPECT_LT((box.min() - expected.min()).norm(), 1e-5) << name;
      EXPECT_LT((box.max() - expected.max()).norm(), 1e-5) << name;
    }
}

TEST(MuJoCo, IncludesTwoScenesWhoseMeshesAreFoundFromTheModel)
{
  for (const std::string folder : {"", "meshes"}) // an absolute path, one as seen there
    forEachComposition(folder, [](const ComposedScenes& scenes) {
      Simulation simulation(including(scenes));
      mj_step(simulation.model.get(), simulation.data.get());
      expectAllParts(simulation, scenes);
    });
  // What is relative counts from the model's own meshdir.
  forEachComposition(".", [](const ComposedScenes& scenes) {
    Simulation simulation(including(scenes, "<compiler meshdir=\"meshes\"/>"));
    mj_step(simulation.model.get(), simulation.data.get());
    expectAllParts(simulation, scenes);
  });
}

/** As the comment in the file says, and the documentation. */
TEST(MuJoCo, DoesNotFindMeshesFromTheIncludedScene)
{
  const PartScene parts = thinParts(Eigen::Vector3d::Zero());
  const ComposedScenes scenes(parts, parts, "../meshes");
  EXPECT_NO_THROW(Simulation{scenes.file("scenes/hall.xml")});
  EXPECT_THROW(Simulation{including(scenes)}, std::runtime_error);
}

TEST(MuJoCo, RefusesTwoScenesOfOneName)
{
  const PartScene parts = thinParts(Eigen::Vector3d::Zero());
  const ComposedScenes scenes(parts, parts, "", ".obj", {"hall", "hall"});
  writeText(scenes.file("scenes/copy.xml"), readText(scenes.file("scenes/hall.xml")));
  const std::string both = scenes.file("both.xml");
  writeText(both,
            "<mujoco><include file=\"scenes/hall.xml\"/>"
            "<include file=\"scenes/copy.xml\"/></mujoco>");
  try {
    const Simulation simulation(both);
    FAIL() << "names may be repeated";
  }
  catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("repeated name"), std::string::npos)
        << error.what();
  }
}

constexpr double ball_radius = 0.05;

/** The scene's MJCF with a ball in it. */
std::string
withBall(const ExportedScene& exported, const Eigen::Vector3d& place)
{
  std::ostringstream text;
  text.precision(17);
  text << "<mujoco><include file=\"scene.xml\"/><worldbody><body pos=\"" << place.x()
       << ' ' << place.y() << ' ' << place.z()
       << "\"><freejoint/><geom name=\"ball\" type=\"sphere\" size=\"" << ball_radius
       << "\" density=\"1000\"/></body></worldbody></mujoco>";
  const std::string path = exported.file("with_ball.xml");
  writeText(path, text.str());
  return path;
}

TEST(MuJoCo, LetsABallRestOnATableTop)
{
  constexpr std::size_t table = 1; // of the thin parts
  constexpr double drop = 0.3;
  for (const Eigen::Vector3d& offset :
       {Eigen::Vector3d(Eigen::Vector3d::Zero()), utmOffset()})
    for (const std::string format : {".obj", ".stl"}) {
      const ExportedScene exported(thinParts(offset), format);
      SCOPED_TRACE(exported.name());
      const Eigen::AlignedBox3d top = boxOf(exported.parts()[table].hull);
      const Eigen::Vector3d start(top.center().x() + 0.1,
                                  top.center().y() - 0.05,
                                  top.max().z() + ball_radius + drop);
      Simulation simulation(withBall(exported, start));
      simulation.runTo(0.1);
      EXPECT_EQ(simulation.data->ncon, 0) << "the ball is still in the air";
      EXPECT_LT(simulation.data->qpos[2], start.z());
      simulation.runTo(5.0);
      const Eigen::Map<const Eigen::Vector3d> ball(simulation.data->qpos);
      // Contacts are soft: the ball sinks in by less than a millimetre.
      EXPECT_NEAR(ball.z(), top.max().z() + ball_radius, 1e-3);
      EXPECT_LT((ball - start).head<2>().norm(), 0.02);
      const Eigen::Map<const Eigen::Vector3d> velocity(simulation.data->qvel);
      EXPECT_LT(velocity.norm(), 0.01);
      ASSERT_GE(simulation.data->ncon, 1);
      for (int i = 0; i < simulation.data->ncon; ++i) {
        const mjContact& contact = simulation.data->contact[i];
        const std::set<std::string> touching{
            simulation.nameOf(mjOBJ_GEOM, contact.geom1),
            simulation.nameOf(mjOBJ_GEOM, contact.geom2)};
        EXPECT_EQ(touching, (std::set<std::string>{"ball", exported.partName(table)}));
        EXPECT_NEAR(contact.pos[2], top.max().z(), 1e-3);
      }
    }
}

TEST(MuJoCo, LetsABallFallPastTheTableTop)
{
  constexpr std::size_t table = 1;
  const ExportedScene exported(thinParts(Eigen::Vector3d::Zero()), ".obj");
  const Eigen::AlignedBox3d top = boxOf(exported.parts()[table].hull);
  const Eigen::Vector3d start(
      top.center().x(), top.max().y() + 2.0 * ball_radius, top.max().z() + 0.3);
  Simulation simulation(withBall(exported, start));
  simulation.runTo(2.0);
  const double floor = boxOf(exported.parts()[0].hull).max().z();
  EXPECT_NEAR(simulation.data->qpos[2], floor + ball_radius, 1e-3);
}

HullPrimitive
readShape(const Simulation& simulation, int geom)
{
  const mjModel& model = *simulation.model;
  HullPrimitive read;
  read.center =
      Eigen::Map<const Eigen::Vector3d>(simulation.data->geom_xpos + 3 * geom);
  read.axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
      simulation.data->geom_xmat + 9 * geom);
  const Eigen::Map<const Eigen::Vector3d> size(model.geom_size + 3 * geom);
  const double width = 2.0 * size[0];
  switch (model.geom_type[geom]) {
  case mjGEOM_BOX:
    read.extents = 2.0 * size;
    break;
  case mjGEOM_SPHERE:
    read.kind = HullPrimitive::Kind::sphere;
    read.extents.setConstant(width);
    break;
  case mjGEOM_CYLINDER:
    read.kind = HullPrimitive::Kind::cylinder;
    read.extents = {width, width, 2.0 * size[1]};
    break;
  default:
    read.kind = HullPrimitive::Kind::capsule;
    read.extents = {width, width, 2.0 * size[1] + width};
  }
  return read;
}

TEST(MuJoCo, ReadsPrimitivesThatHoldThePointsOfTheirParts)
{
  for (const Eigen::Vector3d& offset :
       {Eigen::Vector3d(Eigen::Vector3d::Zero()), utmOffset()}) {
    const SimpleBodies bodies =
        simpleBodies(findSceneFormat("MJCF")->primitives, offset);
    const TemporaryFolder folder;
    writeText(folder.file("scene.xml"), bodies.textIn("MJCF"));
    std::ofstream mesh(folder.file(partFileName(4, bodies.description)));
    writePartMesh(mesh, bodies.content.parts, 4, bodies.description);
    mesh.close();
    Simulation simulation(folder.file("scene.xml"));
    ASSERT_EQ(simulation.model->ngeom, 5);
    EXPECT_EQ(simulation.model->nmesh, 1);
    mj_forward(simulation.model.get(), simulation.data.get());
    for (int i = 0; i < 4; ++i)
      expectHolds(readShape(simulation, i), bodies, static_cast<std::size_t>(i));
    EXPECT_EQ(simulation.model->geom_type[4], mjGEOM_MESH);
  }
}

} // namespace
} // namespace pcl_cid::test
