/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --scale and --output-unit: in which unit files are read and written.
 */

#include "cloud_files.h"
#include "tool_process.h"

#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/mesh_formats.h>
#include <pcl_cid/io/seed_table.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

/** A scan whose coordinates are whole millimetres, of a type of its own. */
template <typename Value>
LabelledCloud
inMillimetres(const LabelledCloud& scan)
{
  LabelledCloud cloud;
  const FileCoordinates metres(scan);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Value> values;
    for (std::size_t i = 0; i < scan.size(); ++i)
      if (metres[i].allFinite()) // whole numbers have no NaN
        values.push_back(static_cast<Value>(std::round(1000.0 * metres[i][axis])));
    appendField(std::string(1, "xyz"[axis]), values, cloud.fields);
  }
  return cloud;
}

/** The rows of a table of seeds with a label filled in. */
std::string
labelled(const std::string& table)
{
  return std::regex_replace(table, std::regex(",\n"), ",7\n");
}

class OutputUnit : public ToolTest {
protected:
  OutputUnit()
  {
    const LabelledCloud scan = readCloud(scan_);
    save("float.pcd", inMillimetres<float>(scan));
    save("whole.pcd", inMillimetres<std::int32_t>(scan));
  }

  void
  save(const std::string& name, const LabelledCloud& cloud) const
  {
    std::ofstream stream(file(name), std::ios::binary);
    writeCloud(stream, cloud, layoutFor(name, cloud.layout));
  }

  /** The hulls of a scan of millimetres, verified, as they are in the file. */
  std::vector<TriangleMesh>
  hulls(const std::string& scan, const std::string& unit, const std::string& mesh) const
  {
    abstract({file(scan),
              file(mesh),
              "--parts",
              "6",
              "--scale",
              "0.001",
              "--output-unit",
              unit,
              "--verify",
              "--labels",
              file("labels.pcd"),
              "--urdf",
              file(unit + ".urdf"),
              "--report",
              file("report.json")});
    EXPECT_EQ(nlohmann::json::parse(
                  readText(file("report.json")))["parameters"]["output_unit"],
              unit);
    return meshFormatOf(mesh).read(file(mesh));
  }
};

TEST_F(OutputUnit, OfHullsIsThatOfTheFileUnlessTheMetreIsAskedFor)
{
  for (const std::string scan : {"float.pcd", "whole.pcd"})
    for (const std::string mesh : {"hulls.obj", "hulls.ply", "hulls.stl"}) {
      const std::vector<TriangleMesh> in_file = hulls(scan, "file", mesh);
      const std::vector<TriangleMesh> in_metres = hulls(scan, "metre", mesh);
      ASSERT_EQ(in_file.size(), in_metres.size());
      for (std::size_t k = 0; k < in_file.size(); ++k) {
        ASSERT_EQ(in_file[k].vertices.size(), in_metres[k].vertices.size());
        for (std::size_t v = 0; v < in_file[k].vertices.size(); ++v)
          EXPECT_TRUE(
              in_file[k].vertices[v].isApprox(1000.0 * in_metres[k].vertices[v], 1e-6));
      }
    }
}

TEST_F(OutputUnit, OfScenesIsTheMetre)
{
  const auto mesh = [this](const std::string& unit) {
    hulls("float.pcd", unit, "hulls.ply");
    return readText(file(unit + "_parts/float_part_000.obj"));
  };
  EXPECT_EQ(mesh("file"), mesh("metre"));
}

TEST_F(OutputUnit, OfCloudsKeepsEveryPointInItsPlace)
{
  for (const std::string name : {"float.pcd", "whole.pcd"}) {
    const LabelledCloud scan = readCloud(file(name));
    const FileCoordinates millimetres(scan);
    hulls(name, "file", "hulls.ply");
    const LabelledCloud in_file = readCloud(file("labels.pcd"));
    hulls(name, "metre", "hulls.ply");
    const LabelledCloud in_metres = readCloud(file("labels.pcd"));
    ASSERT_EQ(in_metres.size(), scan.size());
    for (std::size_t i = 0; i < scan.size(); ++i) {
      EXPECT_EQ(FileCoordinates(in_file)[i], millimetres[i]);
      EXPECT_TRUE(FileCoordinates(in_metres)[i].isApprox(0.001 * millimetres[i], 1e-6));
    }
  }
}

TEST_F(OutputUnit, OfSeedTablesIsThatOfTheCloudWritten)
{
  for (const std::string unit : {"file", "metre"}) {
    const std::vector<std::string> options{
        file("float.pcd"), file("out.pcd"), "--scale", "0.001", "--output-unit", unit};
    std::vector<std::string> propose = options;
    propose.insert(propose.end(), {"--propose", file("seeds.csv")});
    segment(propose);
    writeText(file("labelled.csv"), labelled(readText(file("seeds.csv"))));
    // A table is refused where its coordinates are not those of the cloud.
    const CloudPoints written = pointsOf(readCloud(file("out.pcd")));
    EXPECT_FALSE(readSeedTable(file("labelled.csv"), written).seeds.empty());
    std::vector<std::string> follow = options;
    follow.insert(follow.end(), {"--labels", file("labelled.csv")});
    EXPECT_EQ(run("pcl_cid_segment", follow).exit_code, 0);
  }
}

/** Viewpoints are in the unit of the file, too. */
TEST_F(OutputUnit, MakesNoDifferenceToTheWork)
{
  const auto partsOf = [&](const std::string& scan,
                           const std::string& viewpoint,
                           std::vector<std::string> more) {
    writeText(file("viewpoints.csv"), viewpoint);
    more.insert(more.begin(),
                {file(scan),
                 file("hulls.ply"),
                 "--parts",
                 "6",
                 "--merging",
                 "hull",
                 "--max-error",
                 "0.2",
                 "--viewpoints",
                 file("viewpoints.csv"),
                 "--labels",
                 file("parts.pcd")});
    abstract(more);
    return bytesOf(readCloud(file("parts.pcd")).fields, "label");
  };
  hulls("float.pcd", "metre", "hulls.ply");
  std::filesystem::rename(file("labels.pcd"), file("metres.pcd"));
  const std::vector<std::uint8_t> parts = partsOf("metres.pcd", "0.5,0.25,1.25\n", {});
  EXPECT_EQ(partsOf("float.pcd", "500,250,1250\n", {"--scale", "0.001"}), parts);
  EXPECT_EQ(partsOf("float.pcd",
                    "0.5,0.25,1.25\n",
                    {"--scale", "0.001", "--output-unit", "metre"}),
            parts);
}

TEST_F(OutputUnit, HasNoEffectWithoutAScale)
{
  const ToolRun ran =
      run("pcl_cid_abstract", {scan_, file("hulls.ply"), "--output-unit", "metre"});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_NE(ran.err.find("--scale"), std::string::npos) << ran.err;
}

} // namespace
} // namespace pcl_cid::test
