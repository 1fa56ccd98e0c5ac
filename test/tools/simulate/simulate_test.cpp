/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_simulate as a process: its figures beside those of the other tools.
 */

#include "simulate_tool.h"

namespace pcl_cid::test {
namespace {

TEST_F(SimulateTool, ProposedClicksAreWorthWhatTheOtherToolsSay)
{
  const Arguments options{"--samples", "40", "--seeding", "soft", "--random-seed", "5"};
  Arguments arguments{truth_, "--clicks", "4,9"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Json scores = reportOf(arguments)["scans"][0]["scores"];
  ASSERT_EQ(scores.size(), 2u);
  for (const Json& row : scores) {
    const std::string labelled = file("labelled.pcd");
    Arguments segmenting{
        truth_, labelled, "--labels-from", "label", "--quiet", "--seeds"};
    segmenting.push_back(std::to_string(row["clicks"].get<int>()));
    segmenting.insert(segmenting.end(), options.begin(), options.end());
    ASSERT_EQ(run("pcl_cid_segment", segmenting).exit_code, 0);
    const std::string evaluated = file("evaluated.json");
    ASSERT_EQ(
        run("pcl_cid_evaluate", {labelled, truth_, "--quiet", "--report", evaluated})
            .exit_code,
        0);
    const Json evaluation = Json::parse(readText(evaluated));
    EXPECT_EQ(row["instances"], evaluation["truth_instances"]);
    EXPECT_EQ(row["ap50"], evaluation["mean"]["ap50"]);
    EXPECT_EQ(row["recall25"], evaluation["mean"]["recall25"]);
    EXPECT_EQ(row["recall50"], evaluation["mean"]["recall50"]);
    EXPECT_EQ(row["recall75"], evaluation["mean"]["recall75"]);
    // Each of the three surfaces is best met by its own label here.
    EXPECT_DOUBLE_EQ(row["mean_iou"].get<double>(),
                     evaluation["mean_iou"].get<double>());
  }
}

TEST_F(SimulateTool, CorrectiveClicksMakeAllRight)
{
  const Json report =
      reportOf({truth_, "--protocol", "corrective", "--clicks", "1,3,5,1000"});
  const Json& scores = report["scans"][0]["scores"];
  ASSERT_EQ(scores.size(), 4u);
  EXPECT_EQ(scores[0]["used"], 1);
  EXPECT_LT(scores[0]["mean_iou"], 0.5);
  EXPECT_LT(scores[3]["used"], 1000);
  EXPECT_EQ(scores[3]["mean_iou"], 1.0);
  EXPECT_EQ(scores[3]["ap50"], 1.0);
  EXPECT_EQ(report["all"], scores);
}

TEST_F(SimulateTool, ProposalsComeFirst)
{
  const Json proposed = reportOf({truth_, "--clicks", "2"});
  const Json corrected = reportOf(
      {truth_, "--protocol", "corrective", "--proposals", "2", "--clicks", "2,1000"});
  EXPECT_EQ(corrected["proposals"], 2);
  EXPECT_EQ(corrected["all"][0], proposed["all"][0]);
  EXPECT_GT(corrected["all"][1]["used"], 2);
  EXPECT_EQ(corrected["all"][1]["mean_iou"], 1.0);
}

TEST_F(SimulateTool, OfSeveralScansEachHasItsRowsAndAllHave)
{
  const std::string csv =
      writtenBy({truth_, truth_, "--clicks", "2,5"}, "--csv", "scores.csv");
  EXPECT_EQ(linesOf(csv), 1u + 2 + 2 + 2);
  EXPECT_EQ(csv.rfind("kind,name,instances,clicks,used,mean_iou,recall25,recall50,"
                      "recall75,ap50\nscan,truth,3,2,2,",
                      0),
            0u)
      << csv;
  EXPECT_NE(csv.find("\nall,,6,2,4,"), std::string::npos) << csv;
  const ToolRun printed = simulate({truth_, truth_, "--clicks", "2,5"});
  EXPECT_NE(printed.out.find("mIoU     R25     R50     R75    AP50\n"),
            std::string::npos)
      << printed.out;
  EXPECT_NE(printed.out.find("\nall                              6       2       4"),
            std::string::npos)
      << printed.out;
}

TEST_F(SimulateTool, VoxelsHaveTheFiguresOfAgile3d)
{
  const Json report = reportOf({truth_, "--protocol", "agile3d"});
  const Json& row = report["all"][0];
  EXPECT_EQ(row["clicks"], 60);
  EXPECT_LE(row["used"], 60);
  EXPECT_LE(row["iou5"], row["iou15"]);
  EXPECT_LE(row["noc80"], row["noc90"]);
}

TEST_F(SimulateTool, ThreadsChangeNothing)
{
  for (const char* const protocol : {"proposals", "corrective", "doubt", "agile3d"})
    EXPECT_EQ(
        writtenBy(
            {truth_, "--protocol", protocol, "--threads", "1"}, "--csv", "one.csv"),
        writtenBy(
            {truth_, "--protocol", protocol, "--threads", "3"}, "--csv", "three.csv"));
}

TEST_F(SimulateTool, RefusesAWrongCommandLine)
{
  expectRefused({}, {"SCAN", "at least 1"}, 2);
  expectRefused({truth_, "--protocol", "best"},
                {"--protocol", "'best'", "proposals, corrective, doubt or agile3d"},
                2);
  for (const char* const clicks :
       {"0", "5,5", "9,3", "3,", ",3", "x", "-1", "2 3", "1e3"})
    expectRefused({truth_, "--clicks", clicks},
                  {"--clicks is '" + std::string(clicks) + "'", "ascend"},
                  2);
  expectRefused({truth_, "--proposals", "4"}, {"--proposals", "corrective"}, 2);
  expectRefused({truth_, "--protocol", "agile3d", "--clicks", "4"}, {"--clicks"}, 2);
  expectRefused({truth_, "--seeds", "4"}, {"--seeds"}, 2);
}

TEST_F(SimulateTool, RefusesAScanWithoutTruth)
{
  expectRefused({scan_, "--truth-field", "instance"}, {"scan.pcd", "instance"}, 1);
  LabelledCloud cloud = deskScan();
  setLabels(std::vector<std::uint32_t>(cloud.size(), 0), LabelType::U4, cloud);
  saveCloud(file("none.pcd"), cloud, pcd_binary);
  expectRefused({file("none.pcd")}, {"none.pcd", "'label' is 0", "another label"}, 1);
  expectRefused({truth_, file("absent.pcd")}, {"absent.pcd"}, 1);
  expectRefused({truth_, "--csv", truth_}, {"truth.pcd"}, 1);
}

TEST_F(SimulateTool, PrintsHelpAndVersion)
{
  const ToolRun help = simulate({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("Usage: pcl_cid_simulate SCAN..."), std::string::npos);
  for (const char* const option :
       {"--protocol", "--clicks", "--truth-field", "--density", "--color", "--csv"})
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  EXPECT_EQ(help.out.find("--label-type"), std::string::npos);
  EXPECT_EQ(simulate({"--version"}).out.rfind("pcl_cid_simulate ", 0), 0u);
}

} // namespace
} // namespace pcl_cid::test
