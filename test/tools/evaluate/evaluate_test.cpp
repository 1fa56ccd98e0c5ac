/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_evaluate: scores, pairs, fields, classes and reports.
 */

#include "dataset_folders.h"
#include "evaluate_tool.h"

#include <filesystem>
#include <set>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;

TEST_F(EvaluateTool, ScoresAnExampleWorkedByHand)
{
  // Chair 1: 3 common points, prediction 1 has 5, IoU 3 / (4 + 5 - 3) = 1/2. Chair 2
  // has no prediction of its own. The table: 2 common of 2 and 3, IoU 2/3.
  writeChairsAndTable("prediction.pcd", "truth.pcd");
  const nlohmann::json report =
      reportOf({file("prediction.pcd"), file("truth.pcd"), "--csv", file("t.csv")});
  EXPECT_EQ(report["protocol"], "paper");
  EXPECT_EQ(report["classes_from"], "s3dis");
  EXPECT_EQ(report["classes"].size(), 13u);
  const nlohmann::json chair = classIn(report, "chair");
  EXPECT_EQ(chair["truth_instances"], 2);
  EXPECT_EQ(chair["predictions"], 1);
  EXPECT_DOUBLE_EQ(chair["recall25"], 0.5);
  EXPECT_DOUBLE_EQ(chair["precision25"], 1.0);
  EXPECT_DOUBLE_EQ(chair["ap25"], 0.5); // 1/2 * (1 + 1) / 2
  EXPECT_DOUBLE_EQ(chair["ap50"], 0.0); // 1/2 is not above 1/2
  EXPECT_DOUBLE_EQ(classIn(report, "table")["ap50"], 1.0);
  EXPECT_DOUBLE_EQ(classIn(report, "table")["ap75"], 0.0);
  EXPECT_TRUE(classIn(report, "sofa")["ap25"].is_null());
  EXPECT_EQ(report["mean"]["classes"], 2);
  EXPECT_DOUBLE_EQ(report["mean"]["ap25"], 0.75);
  // Group 1: 3 of chair 1, 2 of chair 2. Group 3: 1 of chair 1, 2 of the table.
  EXPECT_DOUBLE_EQ(report["purity"], 5.0 / 8.0);
  EXPECT_DOUBLE_EQ(report["compactness"], 3.0 / 2.0);
  EXPECT_DOUBLE_EQ(report["mean_iou"], (1.0 / 2.0 + 2.0 / 5.0 + 2.0 / 3.0) / 3.0);
  EXPECT_EQ(report["scans"][0]["name"], "truth");
  EXPECT_EQ(report["scans"][0]["class_rule"], "same_label");
  EXPECT_EQ(report["scans"][0]["mean"], report["mean"]);

  const std::string table = readText(file("t.csv"));
  EXPECT_EQ(linesOf(table), 1u + 1u + 13u + 1u);
  EXPECT_NE(table.find("\nclass,sofa,,,0,0,,,,,,,,,,,,\n"), std::string::npos) << table;
  EXPECT_NE(table.find("\nclass,table,,,1,1,,,,1,1,1,1,1,1,0,0,0\n"), std::string::npos)
      << table;
}

TEST_F(EvaluateTool, PrintsATableUnlessItIsToBeQuiet)
{
  writeChairsAndTable("prediction.pcd", "truth.pcd");
  const Arguments arguments{file("prediction.pcd"), file("truth.pcd")};
  const ToolRun shown = evaluate(arguments);
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  for (const char* const part : {"Scoring truth [done, ",
                                 "AP25",
                                 "\nsofa ",
                                 "\nmean ",
                                 "0.750",
                                 "Purity: 0.625",
                                 "Compactness: 1.5",
                                 "whose label it carries"})
    EXPECT_NE(shown.out.find(part), std::string::npos) << part << "\n" << shown.out;
  Arguments quiet = arguments;
  quiet.push_back("--quiet");
  const ToolRun silent = evaluate(quiet);
  EXPECT_EQ(silent.exit_code, 0);
  EXPECT_EQ(silent.out + silent.err, "");
}

TEST_F(EvaluateTool, ScoresWhatTheSegmentToolWrites)
{
  LabelledCloud truth = deskScan();
  setLabels(deskLabels(), LabelType::U4, truth);
  saveCloud(file("truth.ply"), truth, ply_binary);
  segment({file("truth.ply"), file("labelled.pcd"), "--labels-from", "label"});
  const nlohmann::json report = reportOf({file("labelled.pcd"), file("truth.ply")});
  EXPECT_EQ(report["classes_from"], "none");
  EXPECT_EQ(report["classes"].size(), 1u);
  EXPECT_EQ(report["classes"][0]["name"], "instance");
  EXPECT_EQ(report["truth_instances"], 3);
  EXPECT_EQ(report["groups"], 3);
  EXPECT_EQ(report["points"], report["labelled_points"]);
  EXPECT_LT(report["points"], 1200); // some are not finite
  EXPECT_GT(report["mean"]["ap50"], 0.5);
  EXPECT_GT(report["purity"], 0.8);
  const nlohmann::json perfect = reportOf({file("truth.ply"), file("truth.ply")});
  EXPECT_EQ(perfect["mean"]["ap75"], 1.0);
  EXPECT_EQ(perfect["purity"], 1.0);
}

TEST_F(EvaluateTool, ReadsTheFieldsItIsTold)
{
  writeScan("truth.pcd", "label object kind", {"9 1 4", "9 1 4", "9 2 4", "9 2 4"});
  writeScan("prediction.pcd", "label seed kind", {"9 1 5", "9 1 5", "9 2 4", "9 2 4"});
  Arguments arguments{file("prediction.pcd"),
                      file("truth.pcd"),
                      "--prediction-field",
                      "seed",
                      "--truth-field",
                      "object",
                      "--semantic-field",
                      "kind",
                      "--protocol",
                      "s3dis"};
  const nlohmann::json report = reportOf(arguments);
  EXPECT_EQ(report["scans"][0]["class_rule"], "prediction");
  EXPECT_EQ(report["groups"], 2);
  // One of the two beams is taken for a column.
  EXPECT_DOUBLE_EQ(classIn(report, "beam")["recall"], 0.5);
  EXPECT_DOUBLE_EQ(classIn(report, "beam")["precision"], 1.0);
  EXPECT_EQ(classIn(report, "column")["predictions"], 1);
  EXPECT_TRUE(classIn(report, "column")["precision"].is_null());
  arguments.back() = "paper"; // where the class follows from the label
  EXPECT_DOUBLE_EQ(classIn(reportOf(arguments), "beam")["ap75"], 1.0);
}

TEST_F(EvaluateTool, ReadsClassesFromAFile)
{
  writeChairsAndTable("prediction.pcd", "truth.pcd");
  writeText(file("classes.txt"), "# mine\n9 office chair # blue\r\n\n 8\ttable\n");
  const Arguments arguments{
      file("prediction.pcd"), file("truth.pcd"), "--classes", file("classes.txt")};
  const nlohmann::json report = reportOf(arguments);
  ASSERT_EQ(report["classes"].size(), 2u);
  EXPECT_EQ(report["classes"][0]["name"], "table");
  EXPECT_EQ(report["classes"][1]["name"], "office chair");
  for (const auto& [text, complaint] :
       {std::pair("9 chair\nchair\n", "line 2: 'chair'"),
        std::pair("0 none\n", "line 1: '0 none'"),
        std::pair("9\n", "line 1: '9'"),
        std::pair("9chair\n", "line 1: '9chair'"),
        std::pair("9 chair\n9 table\n", "line 2"),
        std::pair("8 chair\n9 chair\n", "line 2"),
        std::pair("# 9 chair\n", "no class"),
        std::pair("8 table\n", "not known: 9")}) {
    writeText(file("classes.txt"), text);
    expectRefused(arguments, {complaint});
  }
  expectRefused({file("prediction.pcd"), file("truth.pcd"), "--classes", "s3diss"},
                {"'s3diss'", "s3dis, scannet or a file"});
}

TEST_F(EvaluateTool, PairsFoldersByNameAndPools)
{
  for (const char* const folder : {"prediction", "truth"})
    fs::create_directory(file(folder));
  writeChairsAndTable("prediction/b.pcd", "truth/b.pcd");
  writeChairsAndTable("prediction/a.pcd", "truth/a.pcd");
  writeText(file("truth/readme.txt"), "not a scan");
  // In this one the chair that was missed is found: 3 of 4 in all.
  writeScan("prediction/a.pcd", "label", {"1", "1", "1", "1", "2", "2", "3", "3"});
  const nlohmann::json report = reportOf({file("prediction"), file("truth")});
  ASSERT_EQ(report["scans"].size(), 2u);
  EXPECT_EQ(report["scans"][0]["name"], "a");
  EXPECT_EQ(report["scans"][1]["name"], "b");
  EXPECT_DOUBLE_EQ(report["scans"][0]["mean"]["ap25"], 1.0);
  EXPECT_DOUBLE_EQ(report["scans"][1]["mean"]["ap25"], 0.75);
  EXPECT_DOUBLE_EQ(classIn(report, "chair")["recall25"], 0.75);
  EXPECT_DOUBLE_EQ(report["purity"], 13.0 / 16.0);
  EXPECT_DOUBLE_EQ(report["median_purity"], (1.0 + 5.0 / 8.0) / 2.0);
  EXPECT_EQ(report["failed"].size(), 0u);
}

TEST_F(EvaluateTool, GoesOnAfterAScanThatFails)
{
  for (const char* const folder : {"prediction", "truth"})
    fs::create_directory(file(folder));
  for (const char* const name : {"a", "b", "c"})
    writeChairsAndTable("prediction/" + std::string(name) + ".pcd",
                        "truth/" + std::string(name) + ".pcd");
  writeText(file("prediction/a.pcd"), "rubbish\n");
  writeScan("prediction/c.pcd", "label", {"1", "2"});
  fs::copy_file(file("prediction/b.pcd"), file("prediction/d.pcd"));
  fs::create_directory(file("truth/d"));
  for (const char* const mesh : {"e_vh_clean_2.ply", "f_vh_clean_2.ply"})
    writeText(file("truth/d/" + std::string(mesh)), "two meshes");
  const ToolRun done = evaluate(
      {file("prediction"), file("truth"), "--report", file("r.json"), "--quiet"});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_EQ(linesOf(done.err), 4u) << done.err;
  EXPECT_NE(done.err.find("a.pcd: is neither"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("2 and 8 points"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("3 of 4 scans could not be scored: a, c, d\n"),
            std::string::npos)
      << done.err;
  const nlohmann::json report = nlohmann::json::parse(readText(file("r.json")));
  ASSERT_EQ(report["scans"].size(), 1u);
  EXPECT_EQ(report["scans"][0]["name"], "b");
  ASSERT_EQ(report["failed"].size(), 3u);
  EXPECT_EQ(report["failed"][1]["name"], "c");
  EXPECT_DOUBLE_EQ(report["mean"]["ap25"], 0.75);

  fs::remove(file("r.json"));
  writeText(file("prediction/b.pcd"), "rubbish\n");
  const ToolRun nothing = evaluate(
      {file("prediction"), file("truth"), "--report", file("r.json"), "--quiet"});
  EXPECT_EQ(nothing.exit_code, 1);
  EXPECT_NE(nothing.err.find("none of the 4 scans"), std::string::npos) << nothing.err;
  EXPECT_FALSE(fs::exists(file("r.json")));
}

TEST_F(EvaluateTool, TakesFoldersOfDatasetsAsTruth)
{
  const LabelledScan scan = smallRoomScan(8000);
  const std::set<std::uint32_t> instances(scan.instance.begin(), scan.instance.end());
  const std::string room = writeS3DISRoom(file("."), scan);
  const std::string scene = writeScannetScan(file("."), scan, 2);
  fs::create_directory(file("prediction"));
  segment({room, file("prediction/office_1.pcd"), "--labels-from", "label"});
  const nlohmann::json rooms = reportOf({file("prediction"), file("Area_1")});
  ASSERT_EQ(rooms["scans"].size(), 1u);
  EXPECT_EQ(rooms["scans"][0]["name"], "office_1");
  EXPECT_EQ(rooms["classes"].size(), 13u);
  EXPECT_EQ(rooms["points"], scan.points.size());
  EXPECT_EQ(rooms["truth_instances"], instances.size());
  EXPECT_LE(rooms["groups"], 12); // seeds
  EXPECT_LT(rooms["mean"]["recall25"], 1.0);
  EXPECT_EQ(reportOf({room, room})["mean"]["ap75"], 1.0);

  // Instance 2 is in no group of the annotation.
  const nlohmann::json scenes = reportOf({scene, scene, "--protocol", "scannet"});
  EXPECT_EQ(scenes["scans"][0]["name"], "scene0000_00");
  EXPECT_EQ(scenes["classes"].size(), 18u);
  EXPECT_EQ(scenes["truth_instances"], instances.size() - 1);
  EXPECT_LT(scenes["labelled_points"], scan.points.size());
  EXPECT_EQ(scenes["mean"]["ap"], 1.0);
  // The table is for the truth; a prediction that is a file has no use for it.
  const std::string table = file("elsewhere.tsv");
  fs::rename(file("scannetv2-labels.combined.tsv"), table);
  segment({scene, file("scene.pcd"), "--labels-from", "label", "--class-table", table});
  EXPECT_EQ(reportOf({file("scene.pcd"),
                      scene,
                      "--class-table",
                      table,
                      "--protocol",
                      "scannet"})["points"],
            scan.points.size());
  expectRefused({scene,
                 scene,
                 "--class-table",
                 table,
                 "--protocol",
                 "scannet",
                 "--report",
                 scene + "/scene0000_00.aggregation.json"},
                {"never written over"});
}

TEST_F(EvaluateTool, PrintsHelpAndVersion)
{
  const ToolRun help = evaluate({scan_, "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  for (const char* const part : {"Usage: pcl_cid_evaluate PREDICTION TRUTH",
                                 "--protocol",
                                 "--classes",
                                 "--class-table",
                                 "--partial",
                                 "--prediction-field",
                                 "--truth-field",
                                 "--semantic-field",
                                 "--report",
                                 "--csv",
                                 "--quiet"})
    EXPECT_NE(help.out.find(part), std::string::npos) << part;
  EXPECT_EQ(evaluate({"--version"}).out.rfind("pcl_cid_evaluate ", 0), 0u);
}

} // namespace
} // namespace pcl_cid::test
