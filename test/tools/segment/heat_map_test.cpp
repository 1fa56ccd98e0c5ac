/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_segment --cid-from: CID from a point as a field, and nothing else.
 */

#include "tool_process.h"

#include <pcl_cid/core/concavity.h>

#include <cmath>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

class HeatMapTool : public ToolTest {
protected:
  ToolRun
  heat(const std::vector<std::string>& more) const
  {
    std::vector<std::string> arguments{scan_, file("out.pcd")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run("pcl_cid_segment", arguments);
  }

  void
  expectRefused(const std::vector<std::string>& arguments,
                int exit_code,
                const std::string& part) const
  {
    const ToolRun refused = heat(arguments);
    EXPECT_EQ(refused.exit_code, exit_code);
    EXPECT_NE(refused.err.find(part), std::string::npos) << refused.err;
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scan.pcd"});
  }

  /// Indices of points of the scan that are finite, or not.
  std::vector<int>
  indices(bool finite) const
  {
    const CloudPoints points = pointsOf(deskScan());
    std::vector<int> result;
    for (std::size_t i = 0; i < points.points->size(); ++i)
      if ((*points.points)[i].getVector3fMap().allFinite() == finite)
        result.push_back(static_cast<int>(i));
    return result;
  }
};

TEST_F(HeatMapTool, WritesCIDFromThePointToEach)
{
  const int from = indices(true).at(400);
  const ToolRun run = heat({"--cid-from",
                            std::to_string(from),
                            "--samples",
                            "50",
                            "--report",
                            file("report.json")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const LabelledCloud before = readCloud(scan_);
  const LabelledCloud after = readCloud(file("out.pcd"));
  ASSERT_EQ(after.fields.fields.size(), before.fields.fields.size() + 1);
  EXPECT_EQ(after.fields.fields.back().name, "cid");
  EXPECT_EQ(after.fields.width, before.fields.width);
  for (const pcl::PCLPointField& field : before.fields.fields)
    EXPECT_EQ(bytesOf(after.fields, field.name), bytesOf(before.fields, field.name));

  const CloudPoints cloud = pointsOf(before);
  Points surface;
  for (const int i : indices(true))
    surface.push_back((*cloud.points)[static_cast<std::size_t>(i)].getVector3fMap());
  const DistanceField field(surface);
  const Eigen::Vector3f p =
      (*cloud.points)[static_cast<std::size_t>(from)].getVector3fMap();
  const std::vector<float> cids = valuesOf<float>(after.fields, "cid");
  for (std::size_t i = 0; i < cids.size(); ++i) {
    const Eigen::Vector3f q = (*cloud.points)[i].getVector3fMap();
    if (q.allFinite())
      EXPECT_EQ(cids[i], pointCID(field, p, q, 50)) << i;
    else
      EXPECT_TRUE(std::isnan(cids[i])) << i;
  }
  EXPECT_EQ(cids[static_cast<std::size_t>(from)], 0.0f);

  const nlohmann::json report = nlohmann::json::parse(readText(file("report.json")));
  EXPECT_EQ(report["parameters"]["cid_from"], from);
  EXPECT_EQ(report["parameters"]["samples"], 50);
  EXPECT_EQ(report["points"]["finite"], surface.size());
}

TEST_F(HeatMapTool, RefusesAPointThatIsNotThereOrNotFinite)
{
  expectRefused({"--cid-from", "1200"}, 1, "0 to 1200 - 1");
  expectRefused({"--cid-from", std::to_string(indices(false).at(0))}, 1, "not finite");
  expectRefused({"--cid-from", "-1"}, 2, "0 or more");
}

TEST_F(HeatMapTool, RefusesWhatConcernsSeedsAndLabels)
{
  for (const char* const option : {"seeds", "subsample", "start-index"})
    expectRefused({"--cid-from", "0", "--" + std::string(option), "5"}, 2, option);
  expectRefused({"--cid-from", "0", "--propose", "s.csv"}, 2, "propose");
}

} // namespace
} // namespace pcl_cid::test
