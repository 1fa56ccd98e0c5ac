/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract --max-vertices auto and --primitives.
 */

#include "tool_process.h"

#include <pcl_cid/io/scene_formats.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

class SimplerBodies : public ToolTest {
protected:
  /** Run it with --verify. */
  nlohmann::json
  reportOf(const std::vector<std::string>& options) const
  {
    std::vector<std::string> all = {
        scan_, file("hulls.obj"), "--verify", "--report", file("report.json")};
    all.insert(all.end(), options.begin(), options.end());
    abstract(all);
    return nlohmann::json::parse(readText(file("report.json")));
  }

  void
  expectRefused(const std::vector<std::string>& options, const std::string& said) const
  {
    std::vector<std::string> all = {scan_, file("hulls.obj")};
    all.insert(all.end(), options.begin(), options.end());
    const ToolRun ran = run("pcl_cid_abstract", all);
    EXPECT_EQ(ran.exit_code, 2) << options.front();
    EXPECT_NE(ran.err.find(said), std::string::npos) << ran.err;
  }
};

std::size_t
verticesOf(const nlohmann::json& report)
{
  std::size_t vertices = 0;
  for (const nlohmann::json& part : report["parts"])
    vertices += part["vertices"].get<std::size_t>();
  return vertices;
}

TEST_F(SimplerBodies, FewestVerticesAreFewerAndVerified)
{
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
           {"--parts", "6"},
           {"--parts", "6", "--merging", "hull", "--max-error", "1"},
           {"--parts", "6", "--padding", "0.02"}}) {
    const nlohmann::json exact = reportOf(options);
    std::vector<std::string> simpler = options;
    simpler.insert(simpler.end(), {"--max-vertices", "auto"});
    const nlohmann::json report = reportOf(simpler);
    EXPECT_EQ(report["parameters"]["max_vertices"], "auto");
    EXPECT_EQ(report["exact_vertices"], verticesOf(exact));
    EXPECT_LT(verticesOf(report), verticesOf(exact));
    EXPECT_EQ(report["parts"].size(), exact["parts"].size());
    EXPECT_FALSE(exact.contains("exact_vertices"));
  }
}

TEST_F(SimplerBodies, RefusesOtherWords)
{
  for (const char* const word : {"Auto", "few", "", "auto4", "3", "0", "-1"})
    expectRefused({"--parts", "6", "--max-vertices", word}, "at least 4, or 'auto'");
}

TEST_F(SimplerBodies, PrimitivesNeedASceneThatHasThem)
{
  expectRefused({"--parts", "6", "--primitives"}, "--primitives");
}

TEST_F(SimplerBodies, PrimitivesAreVerifiedAndHaveNoMesh)
{
  const nlohmann::json report = reportOf({"--parts",
                                          "12",
                                          "--padding",
                                          "0.3", // makes hulls rather like boxes
                                          "--primitives",
                                          "--urdf",
                                          file("scene.urdf"),
                                          "--sdf",
                                          file("scene.sdf"),
                                          "--mjcf",
                                          file("scene.xml"),
                                          "--moveit",
                                          file("scene.scene")});
  ASSERT_EQ(report["parts"].size(), 12u);
  std::size_t primitives = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const nlohmann::json& primitive = report["parts"][i]["primitive"];
    EXPECT_NE(primitive, "capsule"); // URDF and MoveIt have none
    const std::string name =
        "scan_part_0" + std::string(i < 10 ? "0" : "") + std::to_string(i);
    EXPECT_EQ(std::filesystem::exists(file("scene_parts/" + name + ".obj")),
              primitive.is_null());
    primitives += primitive.is_null() ? 0 : 1;
  }
  EXPECT_GT(primitives, 0u);
}

TEST_F(SimplerBodies, HullsStandInScenesWithoutPrimitives)
{
  const nlohmann::json report = reportOf({"--parts",
                                          "12",
                                          "--padding",
                                          "0.3",
                                          "--primitives",
                                          "--urdf",
                                          file("scene.urdf"),
                                          "--gltf",
                                          file("scene.glb"),
                                          "--usd",
                                          file("scene.usda")});
  std::size_t primitives = 0;
  for (const nlohmann::json& part : report["parts"])
    primitives += part["primitive"].is_null() ? 0 : 1;
  EXPECT_GT(primitives, 0u);
  for (const auto& [format, name] :
       {std::pair("glTF", "scene.glb"), std::pair("USD", "scene.usda")}) {
    std::ifstream stream(file(name), std::ios::binary);
    EXPECT_EQ(findSceneFormat(format)->read_meshes(stream).size(), 12u);
  }
}

TEST_F(SimplerBodies, PrimitivesKeepTheBoundAndThePadding)
{
  reportOf({"--merging",
            "hull",
            "--max-error",
            "1",
            "--padding",
            "0.02",
            "--primitives",
            "--max-vertices",
            "auto",
            "--sdf",
            file("scene.sdf")});
}

TEST_F(SimplerBodies, GiveTheSameBytesForEveryNumberOfThreads)
{
  std::vector<std::string> texts;
  for (const char* const threads : {"1", "5"}) {
    reportOf({"--parts",
              "6",
              "--threads",
              threads,
              "--primitives",
              "--max-vertices",
              "auto",
              "--mjcf",
              file("scene.xml")});
    texts.push_back(readText(file("scene.xml")) + readText(file("hulls.obj")));
  }
  EXPECT_EQ(texts[0], texts[1]);
}

} // namespace
} // namespace pcl_cid::test
