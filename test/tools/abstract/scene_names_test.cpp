/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract: --name and --mesh-prefix, by which scenes go together.
 */

#include "scene_test.h"

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

class SceneNames : public SceneTest {};

/** The names of all that belongs to parts. */
std::vector<std::string>
namesOfParts(const std::string& xml)
{
  std::vector<std::string> names;
  for (const std::string& name : attributes(xml, "name"))
    if (name.find("part_") != std::string::npos)
      names.push_back(name);
  return names;
}

TEST_F(SceneNames, HaveTheNameOfTheScanOrTheOneAskedFor)
{
  std::filesystem::copy_file(scan_, file("2nd floor.pcd"));
  const auto written = [&](const std::string& scan, const std::string& name) {
    std::vector<std::string> arguments{scan,
                                       file("a.obj"),
                                       "--parts",
                                       "2",
                                       "--parts-dir",
                                       file("parts"),
                                       "--report",
                                       file("report.json")};
    for (const char* const format : {"urdf", "sdf", "mjcf", "moveit"}) {
      arguments.push_back(std::string("--") + format);
      const std::string extension = format == std::string("mjcf")     ? "xml"
                                    : format == std::string("moveit") ? "scene"
                                                                      : format;
      arguments.push_back(file("a." + extension));
    }
    if (!name.empty())
      arguments.insert(arguments.end(), {"--name", name});
    abstract(arguments);
  };
  const auto expectNamed = [&](const std::string& name) {
    for (const char* const scene : {"a.urdf", "a.sdf", "a.xml"}) {
      const std::string text = readText(file(scene));
      const std::vector<std::string> names = attributes(text, "name");
      for (const std::string& each : names)
        EXPECT_EQ(each.rfind(name, 0), 0u) << scene << ": " << each;
      EXPECT_GE(namesOfParts(text).size(), 4u) << scene;
      EXPECT_NE(text.find("parts/" + name + "_part_001.obj"), std::string::npos);
    }
    EXPECT_EQ(attributes(readText(file("a.xml")), "model")[0], name);
    EXPECT_EQ(readText(file("a.scene")).rfind(name + "\n* " + name + "_part_000\n", 0),
              0u);
    const nlohmann::json report = nlohmann::json::parse(readText(file("report.json")));
    EXPECT_EQ(report["parameters"]["name"], name);
    EXPECT_EQ(report["parameters"]["frame"], name);
  };
  written(scan_, "");
  expectNamed("scan");
  EXPECT_EQ(readText(file("a.obj")).find("scan_part"), std::string::npos);
  written(file("2nd floor.pcd"), "");
  expectNamed("scan_2nd_floor");
  written(scan_, "hall");
  expectNamed("hall");
  EXPECT_NE(readText(file("a.obj")).find("\no hall_part_001\n"), std::string::npos);
  EXPECT_NE(readText(file("a.mtl")).find("newmtl hall_part_001\n"), std::string::npos);
  // Each name has its own files in the one folder.
  EXPECT_EQ(namesIn("parts"),
            (std::vector<std::string>{"hall_part_000.obj",
                                      "hall_part_001.obj",
                                      "scan_2nd_floor_part_000.obj",
                                      "scan_2nd_floor_part_001.obj",
                                      "scan_part_000.obj",
                                      "scan_part_001.obj"}));
}

TEST_F(SceneNames, SayWhatIsAskedForBeforeTheNamesOfMeshes)
{
  const auto files = [&](const std::string& prefix) {
    abstract({scan_,
              file("a.ply"),
              "--parts",
              "2",
              "--urdf",
              file("a.urdf"),
              "--sdf",
              file("a.sdf"),
              "--mesh-prefix",
              prefix});
    EXPECT_EQ(namesIn("a_parts").size(), 2u);
    const std::string sdf = readText(file("a.sdf"));
    const std::string first = attributes(readText(file("a.urdf")), "filename").at(0);
    EXPECT_NE(sdf.find("<uri>" + first + "</uri>"), std::string::npos);
    return first;
  };
  EXPECT_EQ(files("package://my_robot/meshes"),
            "package://my_robot/meshes/scan_part_000.obj");
  EXPECT_EQ(files("package://my_robot/meshes/"),
            "package://my_robot/meshes/scan_part_000.obj");
  EXPECT_EQ(files("file:///data"), "file:///data/scan_part_000.obj");
  EXPECT_EQ(files("../meshes"), "../meshes/scan_part_000.obj");
  EXPECT_EQ(files("/data"), "/data/scan_part_000.obj");
}

TEST_F(SceneNames, RefuseANameThatWouldStandNowhere)
{
  const std::string said =
      run("pcl_cid_abstract", {scan_, file("a.ply"), "--name", "hall"}).err;
  EXPECT_NE(said.find("--name has no effect"), std::string::npos) << said;
  EXPECT_NE(said.find("PLY"), std::string::npos) << said;
  abstract({scan_, file("a.ply"), "--name", "hall", "--parts-dir", file("p")});
  EXPECT_EQ(namesIn("p").at(0), "hall_part_000.obj");
}

} // namespace
} // namespace pcl_cid::test
