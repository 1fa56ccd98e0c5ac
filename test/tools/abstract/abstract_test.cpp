/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract: parts, hulls, and the files they go into.
 */

#include "tool_process.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include <pcl/PolygonMesh.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/ply_io.h>

namespace pcl_cid::test {
namespace {

/** Vertices and faces of each object of an OBJ. */
struct ObjectSize {
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

std::map<std::string, ObjectSize>
objectsOf(const std::string& obj)
{
  std::map<std::string, ObjectSize> objects;
  std::istringstream lines(obj);
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("o ", 0) == 0)
      name = line.substr(2);
    objects[name].vertices += line.rfind("v ", 0) == 0 ? 1 : 0;
    objects[name].faces += line.rfind("f ", 0) == 0 ? 1 : 0;
  }
  objects.erase(""); // what stands before the first object
  return objects;
}

class AbstractTool : public ToolTest {
protected:
  nlohmann::json
  json(const std::string& name) const
  {
    return nlohmann::json::parse(readText(file(name)));
  }
};

TEST_F(AbstractTool, WritesAnObjectForEachPart)
{
  abstract({scan_, file("hulls.obj"), "--parts", "5", "--report", file("report.json")});
  EXPECT_EQ(
      folder_.names(),
      (std::vector<std::string>{"hulls.mtl", "hulls.obj", "report.json", "scan.pcd"}));
  const auto objects = objectsOf(readText(file("hulls.obj")));
  ASSERT_EQ(objects.size(), 5u);
  const nlohmann::json parts = json("report.json")["parts"];
  ASSERT_EQ(parts.size(), 5u);
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t points = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const ObjectSize size = objects.at("part_00" + std::to_string(i));
    EXPECT_EQ(parts[i]["vertices"], size.vertices);
    EXPECT_EQ(parts[i]["triangles"], size.faces);
    EXPECT_GT(parts[i]["volume"], 0.0);
    EXPECT_GE(parts[i]["thickness"], 0.00499);
    vertices += size.vertices;
    faces += size.faces;
    points += parts[i]["points"].get<std::size_t>();
  }
  EXPECT_EQ(json("report.json")["points"]["grouped"], points);
  pcl::PolygonMesh mesh;
  ASSERT_GE(pcl::OBJReader().read(file("hulls.obj"), mesh), 0);
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, vertices);
  EXPECT_EQ(mesh.polygons.size(), faces);
}

TEST_F(AbstractTool, WritesTheSameMeshInEveryFormat)
{
  abstract({scan_, file("hulls.obj"), "--parts", "5"});
  abstract({scan_, file("hulls.ply"), "--parts", "5"});
  abstract({scan_, file("hulls.stl"), "--parts", "5"});
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const auto& [name, size] : objectsOf(readText(file("hulls.obj")))) {
    vertices += size.vertices;
    faces += size.faces;
  }
  pcl::PolygonMesh mesh;
  ASSERT_GE(pcl::io::loadPLYFile(file("hulls.ply"), mesh), 0);
  EXPECT_EQ(mesh.cloud.width, vertices);
  EXPECT_EQ(mesh.polygons.size(), faces);
  EXPECT_EQ(readText(file("hulls.stl")).size(), 84 + 50 * faces);
}

TEST_F(AbstractTool, CutsByPartsThresholdAndMerges)
{
  abstract({scan_, file("all.obj"), "--merges", "0", "--tree", file("tree.json")});
  EXPECT_EQ(objectsOf(readText(file("all.obj"))).size(), 12u);
  const nlohmann::json steps = json("tree.json")["steps"];
  ASSERT_EQ(steps.size(), 11u);
  EXPECT_EQ(json("tree.json")["group_sizes"].size(), 12u);

  abstract({scan_, file("parts.obj"), "--parts", "4"});
  EXPECT_EQ(objectsOf(readText(file("parts.obj"))).size(), 4u);
  abstract({scan_, file("merges.obj"), "--merges", "8"});
  const double between =
      0.5 * (steps[7]["height"].get<double>() + steps[8]["height"].get<double>());
  abstract({scan_, file("threshold.obj"), "--threshold", std::to_string(between)});
  // The same four parts, but for the name of the library in the first line.
  const auto body = [](const std::string& obj) { return obj.substr(obj.find('\n')); };
  EXPECT_EQ(body(readText(file("merges.obj"))), body(readText(file("parts.obj"))));
  EXPECT_EQ(body(readText(file("threshold.obj"))), body(readText(file("parts.obj"))));
}

TEST_F(AbstractTool, MergesPatchesAndReportsThem)
{
  abstract({scan_,
            file("hulls.obj"),
            "--groups",
            "patches",
            "--parts",
            "5",
            "--tree",
            file("tree.json"),
            "--report",
            file("report.json")});
  const nlohmann::json report = json("report.json");
  EXPECT_EQ(report["parameters"]["groups"], "patches");
  EXPECT_EQ(report["parameters"]["merging"], "cid");
  EXPECT_TRUE(report["seeds"].empty());
  EXPECT_EQ(report["parts"].size(), 5u);
  ASSERT_EQ(report["patches"].size(), 12u);
  std::size_t points = 0;
  for (std::size_t k = 0; k < 12; ++k) {
    const nlohmann::json& patch = report["patches"][k];
    EXPECT_EQ(patch["points"], json("tree.json")["group_sizes"][k]);
    EXPECT_GE(patch["grown"], 1);
    EXPECT_LE(patch["grown"], patch["points"]);
    points += patch["points"].get<std::size_t>();
  }
  EXPECT_EQ(report["points"]["grouped"], points);
  abstract(
      {scan_, file("of_seeds.obj"), "--groups", "cid", "--report", file("2.json")});
  EXPECT_EQ(json("2.json")["parameters"]["groups"], "cid");
  EXPECT_EQ(json("2.json")["seeds"].size(), 12u);
  EXPECT_FALSE(json("2.json").contains("patches"));
}

TEST_F(AbstractTool, ChoosesThePartsItselfWhenNotTold)
{
  abstract(
      {scan_, file("a.ply"), "--tree", file("tree.json"), "--report", file("a.json")});
  const std::size_t groups = json("tree.json")["group_sizes"].size();
  const std::size_t parts = json("a.json")["parts"].size();
  EXPECT_GT(parts, 1u);
  EXPECT_LT(parts, groups);
}

TEST_F(AbstractTool, ReportsHowTightlyHullsFit)
{
  abstract({scan_, file("few.ply"), "--parts", "2", "--report", file("few.json")});
  abstract({scan_, file("many.ply"), "--parts", "12", "--report", file("many.json")});
  for (const char* name : {"few.json", "many.json"}) {
    const nlohmann::json report = json(name);
    const double largest = report["tightness"]["max_concavity"];
    double largest_of_parts = 0.0;
    for (const nlohmann::json& part : report["parts"]) {
      EXPECT_LE(part["mean_concavity"], part["max_concavity"]);
      EXPECT_GE(part["free_share"], 0.0);
      EXPECT_LE(part["free_share"], 1.0);
      largest_of_parts =
          std::max(largest_of_parts, part["max_concavity"].get<double>());
    }
    EXPECT_EQ(largest, largest_of_parts);
  }
  EXPECT_LT(json("many.json")["tightness"]["free_volume"],
            json("few.json")["tightness"]["free_volume"]);
}

TEST_F(AbstractTool, CurveTradesPartsForTightness)
{
  abstract({scan_, file("hulls.ply"), "--curve", file("curve.csv")});
  std::istringstream lines(readText(file("curve.csv")));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line,
            "parts,height,vertices,max_concavity,mean_concavity,free_share,"
            "free_volume,volume");
  std::size_t parts = 13; // one more than there are groups
  double height = -1.0;
  double volume = 0.0;
  while (std::getline(lines, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    std::size_t fewer_parts = 0, vertices = 0;
    double higher = 0, largest = 0, mean = 0, share = 0, free = 0, larger_volume = 0;
    numbers >> fewer_parts >> higher >> vertices >> largest >> mean >> share >> free >>
        larger_volume;
    ASSERT_FALSE(numbers.fail()) << line;
    EXPECT_LT(fewer_parts, parts);
    EXPECT_GE(higher, height);
    EXPECT_GE(larger_volume, volume);
    EXPECT_LE(free, larger_volume);
    parts = fewer_parts;
    height = higher;
    volume = larger_volume;
  }
  EXPECT_EQ(parts, 1u);
}

TEST_F(AbstractTool, DropsSmallPartsAndReportsTheirPoints)
{
  abstract({scan_, file("all.ply"), "--parts", "8", "--report", file("all.json")});
  const nlohmann::json all = json("all.json");
  std::vector<std::size_t> sizes;
  for (const nlohmann::json& part : all["parts"])
    sizes.push_back(part["points"]);
  std::sort(sizes.begin(), sizes.end());
  const std::size_t least = sizes[3] + 1; // the four smallest go, and who is as small
  const auto first_kept = std::lower_bound(sizes.begin(), sizes.end(), least);
  const std::size_t dropped =
      std::accumulate(sizes.begin(), first_kept, std::size_t{0});

  abstract({scan_,
            file("large.ply"),
            "--parts",
            "8",
            "--min-points",
            std::to_string(least),
            "--report",
            file("large.json")});
  const nlohmann::json report = json("large.json");
  EXPECT_EQ(report["parts"].size(), std::size_t(sizes.end() - first_kept));
  EXPECT_EQ(report["points"]["dropped"], dropped);
}

TEST_F(AbstractTool, VerifiesWhatItWrote)
{
  for (const char* name : {"hulls.obj", "hulls.ply", "hulls.stl"})
    for (const char* format : {"obj", "stl"})
      abstract({scan_,
                file(name),
                "--parts",
                "12",
                "--verify",
                "--padding",
                "0.01",
                "--max-vertices",
                "24",
                "--parts-dir",
                file("parts"),
                "--parts-format",
                format});
}

TEST_F(AbstractTool, LabelsPointsByPart)
{
  abstract({scan_,
            file("hulls.ply"),
            "--parts",
            "5",
            "--labels",
            file("parts.pcd"),
            "--report",
            file("report.json")});
  const LabelledCloud labelled = readCloud(file("parts.pcd"));
  EXPECT_EQ(labelled.fields.width, 40u);
  EXPECT_EQ(bytesOf(labelled.fields, "rgb"), bytesOf(deskScan().fields, "rgb"));
  const auto labels = valuesOf<std::uint32_t>(labelled.fields, "label");
  std::vector<std::size_t> sizes(6, 0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ASSERT_LE(labels[i], 5u);
    EXPECT_EQ(labels[i] == 0, deskLabels()[i] == 0);
    ++sizes[labels[i]];
  }
  for (std::size_t part = 0; part < 5; ++part)
    EXPECT_EQ(json("report.json")["parts"][part]["points"], sizes[part + 1]);
}

TEST_F(AbstractTool, GivesTheSameBytesForEveryNumberOfThreads)
{
  abstract({scan_, file("1.ply"), "--threads", "1", "--parts", "5"});
  for (const char* const threads : {"2", "3", "8"}) {
    const std::string out = file(std::string(threads) + ".ply");
    abstract({scan_, out, "--threads", threads, "--parts", "5"});
    EXPECT_EQ(readText(out), readText(file("1.ply"))) << threads << " threads";
  }
}

TEST_F(AbstractTool, PutsHullsWhereTheScanIs)
{
  const Eigen::Vector3d utm(524288.0, 4194304.0, 100.0);
  const CloudPoints points = pointsOf(deskScan());
  std::vector<double> coordinates[3];
  Eigen::AlignedBox3d box;
  for (const pcl::PointXYZ& point : *points.points) {
    const Eigen::Vector3d p = point.getVector3fMap().cast<double>() + utm;
    if (p.allFinite())
      box.extend(p);
    for (int axis = 0; axis < 3; ++axis)
      coordinates[axis].push_back(p[axis]);
  }
  LabelledCloud scan;
  appendField("x", coordinates[0], scan.fields);
  appendField("y", coordinates[1], scan.fields);
  appendField("z", coordinates[2], scan.fields);
  saveCloud(file("utm.pcd"), scan, pcd_binary);
  abstract({file("utm.pcd"), file("hulls.ply"), "--parts", "5"});
  pcl::PolygonMesh mesh;
  ASSERT_GE(pcl::io::loadPLYFile(file("hulls.ply"), mesh), 0);
  Eigen::AlignedBox3d hulls;
  const auto x = valuesOf<double>(mesh.cloud, "x");
  const auto y = valuesOf<double>(mesh.cloud, "y");
  const auto z = valuesOf<double>(mesh.cloud, "z");
  for (std::size_t i = 0; i < x.size(); ++i)
    hulls.extend(Eigen::Vector3d(x[i], y[i], z[i]));
  // Thin parts were thickened by up to 5 mm.
  EXPECT_LT((hulls.min() - box.min()).cwiseAbs().maxCoeff(), 0.006);
  EXPECT_LT((hulls.max() - box.max()).cwiseAbs().maxCoeff(), 0.006);

  const ToolRun flat =
      run("pcl_cid_abstract", {file("utm.pcd"), file("hulls.stl"), "--parts", "5"});
  EXPECT_EQ(flat.exit_code, 1);
  EXPECT_NE(flat.err.find("STL"), std::string::npos) << flat.err;
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"hulls.ply", "scan.pcd", "utm.pcd"}));
}

TEST_F(AbstractTool, ThickensThinParts)
{
  abstract({scan_,
            file("a.ply"),
            "--parts",
            "5",
            "--min-thickness",
            "0.2",
            "--report",
            file("report.json")});
  const nlohmann::json parts = json("report.json")["parts"];
  ASSERT_EQ(parts.size(), 5u);
  for (const nlohmann::json& part : parts)
    EXPECT_GE(part["thickness"], 0.1999);
}

} // namespace
} // namespace pcl_cid::test
