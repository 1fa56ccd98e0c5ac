/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What --verify says of scenes whose primitives do not hold what they promise.
 */

#include "abstract/primitive_verification.h"

#include "cloud_files.h"
#include "clouds.h"
#include "simple_bodies.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/scene_formats.h>

#include <functional>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using PrimitiveChange = std::function<void(HullPrimitive&)>;

/** Simple bodies, of which one is tampered with before they are written. */
class PrimitiveVerification : public testing::Test {
protected:
  PrimitiveVerification() : bodies_(simpleBodies({}, Eigen::Vector3d::Zero()))
  {
    abstracted_.parts = bodies_.content.parts;
    Points all;
    for (const Eigen::Vector3d& point : bodies_.content.points)
      all.push_back(point.cast<float>());
    points_.points = toCloud(all);
    cloud_ = toLabelledCloud(*points_.points);
  }

  /** What is said of a scene in which a part was changed; nothing when all is well. */
  std::string
  complaintAbout(const SceneFormat& format,
                 std::size_t part,
                 const PrimitiveChange& change,
                 const tools::ErrorVerification* error = nullptr)
  {
    const SimpleBodies bodies =
        simpleBodies(format.primitives, Eigen::Vector3d::Zero());
    SceneDescription changed = bodies.description;
    change(*changed.primitives[part]);
    const tools::SceneFile file = {format, folder_.file("scene")};
    OutputFiles outputs({});
    outputs.announce(file.path);
    outputs.write(file.path, [&](std::ostream& stream) {
      format.write(stream, bodies.content.parts, changed);
    });
    try {
      verifyPrimitives(file,
                       bodies.description,
                       {abstracted_,
                        points_.frame,
                        tools::pointsOfParts(cloud_, abstracted_.parts),
                        1.0,
                        error},
                       outputs);
    }
    catch (const CIDException& complaint) {
      return complaint.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  SimpleBodies bodies_;
  CloudPoints points_;
  LabelledCloud cloud_;
  tools::AbstractedScan abstracted_; ///< what the files are said to be of
};

std::vector<SceneFormat>
formatsWithPrimitives()
{
  std::vector<SceneFormat> formats;
  for (const SceneFormat& format : sceneFormats())
    if (!format.primitives.empty())
      formats.push_back(format);
  EXPECT_GE(formats.size(), 4u);
  return formats;
}

void
expectSaid(const std::string& said, const std::string& expected)
{
  EXPECT_NE(said.find(expected), std::string::npos) << said;
}

TEST_F(PrimitiveVerification, PassesScenesAsTheyWereWritten)
{
  for (const SceneFormat& format : formatsWithPrimitives())
    EXPECT_EQ(complaintAbout(format, 0, [](HullPrimitive&) {}), "") << format.name;
}

TEST_F(PrimitiveVerification, FindsPointsOutsideInEveryFormat)
{
  const std::vector<std::string> names = {"box", "sphere", "cylinder"};
  for (const SceneFormat& format : formatsWithPrimitives())
    for (std::size_t part = 0; part < names.size(); ++part) {
      const std::string expected = "verification: the " + names[part] + " of part_00" +
                                   std::to_string(part) + " breaks a guarantee: point ";
      expectSaid(complaintAbout(format, part, [](auto& p) { p.extents *= 0.99; }),
                 expected);
      expectSaid(complaintAbout(format, part, [](auto& p) { p.center.x() += 0.01; }),
                 expected);
    }
  for (const char* const name : {"SDF", "MJCF"})
    expectSaid(complaintAbout(
                   *findSceneFormat(name), 3, [](auto& p) { p.extents.z() -= 0.01; }),
               "the capsule of part_003 breaks a guarantee");
}

TEST_F(PrimitiveVerification, FindsABoxThatIsTurned)
{
  for (const SceneFormat& format : formatsWithPrimitives())
    expectSaid(complaintAbout(format,
                              0,
                              [](HullPrimitive& p) {
                                p.axes.col(0).swap(p.axes.col(1));
                                p.axes.col(2) *= -1.0;
                              }),
               "the box of part_000 breaks a guarantee");
}

TEST_F(PrimitiveVerification, HoldsThemToThePaddingAndTheBound)
{
  const SceneFormat& format = *findSceneFormat("SDF");
  const tools::ErrorVerification tight(points_, 0.2, {});
  expectSaid(complaintAbout(
                 format, 1, [](HullPrimitive&) {}, &tight),
             "of part_001 breaks a guarantee: it holds a place");
  abstracted_.hull_options.padding = 0.1;
  expectSaid(complaintAbout(format, 0, [](HullPrimitive&) {}), "is not contained");
}

} // namespace
} // namespace pcl_cid::test
