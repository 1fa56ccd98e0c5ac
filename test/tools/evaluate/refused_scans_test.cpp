/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_evaluate: what it refuses, and that it then leaves all files alone.
 */

#include "evaluate_tool.h"

#include <filesystem>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;

TEST_F(EvaluateTool, RefusesScansWithoutCounterpart)
{
  for (const char* const folder : {"prediction", "truth", "empty"})
    fs::create_directory(file(folder));
  writeChairsAndTable("prediction/a.pcd", "truth/a.pcd");
  writeChairsAndTable("prediction/b.pcd", "truth/c.pcd");
  expectRefused({file("prediction"), file("truth")}, {"truth: lacks scans", ": b"});
  fs::remove(file("prediction/b.pcd"));
  expectRefused({file("prediction"), file("truth")}, {": c", "--partial"});
  const nlohmann::json report =
      reportOf({file("prediction"), file("truth"), "--partial"});
  EXPECT_EQ(report["scans"].size(), 1u);
  fs::copy_file(file("truth/a.pcd"), file("truth/a.ply"));
  expectRefused({file("prediction"), file("truth")}, {"same name"});
  expectRefused({file("prediction"), file("empty")}, {"empty: holds no scan"});
  expectRefused({file("prediction"), scan_}, {"folder of scans", "scan.pcd"});
  expectRefused({file("nothing"), scan_}, {"nothing: there is no such file"});
}

TEST_F(EvaluateTool, RefusesScansOfWhichOnlySomeHaveClasses)
{
  for (const char* const folder : {"prediction", "truth"})
    fs::create_directory(file(folder));
  for (const char* const name : {"a", "b"})
    writeChairsAndTable("prediction/" + std::string(name) + ".pcd",
                        "truth/" + std::string(name) + ".pcd");
  fs::copy_file(file("prediction/b.pcd"),
                file("truth/b.pcd"),
                fs::copy_options::overwrite_existing);
  const ToolRun done = evaluate({file("prediction"), file("truth")});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("b.pcd: has no field 'semantic', unlike"), std::string::npos)
      << done.err;
}

TEST_F(EvaluateTool, RefusesOtherPoints)
{
  writeChairsAndTable("prediction.pcd", "truth.pcd");
  const Arguments arguments{file("prediction.pcd"), file("truth.pcd")};
  writeScan("prediction.pcd", "label", {"1", "1", "3"});
  expectRefused(arguments, {"prediction.pcd", "truth.pcd", "3 and 8 points"});

  writeChairsAndTable("prediction.pcd", "truth.pcd");
  std::string text = readText(file("prediction.pcd"));
  const auto replace = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find("\n" + from + " "), from.size() + 2, "\n" + to + " ");
    writeText(file("prediction.pcd"), changed);
  };
  replace("3 0.5 -2", "3 0.5 -2.125");
  expectRefused(arguments, {"point 3 of 8", "(3, 0.5, -2.125", "(3, 0.5, -2)"});
  replace("6 0.5 -2", "nan 0.5 -2");
  expectRefused(arguments, {"point 6 of 8"});
  replace("5 0.5 -2", "5.00001 0.499999 -2"); // as rounded by other programs
  EXPECT_EQ(evaluate(arguments).exit_code, 0);
}

TEST_F(EvaluateTool, RefusesAnotherOrderWhereverAndHoweverSmallTheScanIs)
{
  const auto write = [&](const char* name, const std::vector<std::string>& points) {
    std::string text = "VERSION 0.7\nFIELDS x y z label\nSIZE 8 8 8 4\nTYPE F F F U\n"
                       "COUNT 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
                       "POINTS 3\nDATA ascii\n";
    for (const std::string& point : points)
      text += point + " 1\n";
    writeText(file(name), text);
  };
  const std::vector<std::vector<std::string>> scans = {
      {"500000.25 4000000.5 0", "500000.75 4000000.5 0", "500001.5 4000000.5 0"},
      {"1e-6 2e-6 0", "2e-6 2e-6 0", "4e-6 2e-6 0"}};
  for (const std::vector<std::string>& points : scans) {
    write("truth.pcd", points);
    write("prediction.pcd", points);
    EXPECT_EQ(evaluate({file("prediction.pcd"), file("truth.pcd")}).exit_code, 0);
    write("prediction.pcd", {points[0], points[2], points[1]});
    expectRefused({file("prediction.pcd"), file("truth.pcd")}, {"point 1 of 3"});
  }
}

TEST_F(EvaluateTool, RefusesLabelsAndClassesItCannotScore)
{
  writeChairsAndTable("prediction.pcd", "truth.pcd");
  const Arguments arguments{file("prediction.pcd"), file("truth.pcd")};
  writeScan("prediction.pcd", "label", {"1", "1", "1", "1", "1", "1", "1", "77"});
  expectRefused(arguments, {"prediction.pcd", "77", "not one of the truth"});
  Arguments s3dis = arguments;
  s3dis.insert(s3dis.end(), {"--protocol", "s3dis"});
  EXPECT_EQ(reportOf(s3dis)["scans"][0]["class_rule"], "truth");

  writeScan("truth.pcd",
            "label semantic",
            {"1 9", "1 9", "1 9", "1 99", "2 41", "2 0", "3 8", "3 8"});
  expectRefused(arguments, {"truth.pcd", "'semantic'", "41, 99", "--classes"});
  writeScan("truth.pcd", "part", {"1", "1", "1", "1", "1", "1", "1", "1"});
  expectRefused(arguments, {"truth.pcd", "no field 'label'", "part"});
  expectRefused({file("truth.pcd"), file("prediction.pcd")}, {"no field 'label'"});
  writeScan("truth.pcd", "label", {"1", "1", "1", "1", "1", "1", "1", "77"});
  expectRefused({arguments[0], arguments[1], "--classes", "s3dis"},
                {"truth.pcd", "no field 'semantic'", "--classes"});
}

TEST_F(EvaluateTool, NeverWritesOverItsInputs)
{
  writeChairsAndTable("prediction.pcd", "truth.pcd");
  const Arguments arguments{file("prediction.pcd"), file("truth.pcd")};
  for (const std::string& output : {file("prediction.pcd"), file("truth.pcd")})
    for (const char* const option : {"--report", "--csv"})
      expectRefused({arguments[0], arguments[1], option, output},
                    {"never written over"});
  expectRefused({arguments[0], arguments[1], "--report", file("no/r.json")},
                {"does not exist"});
  expectRefused({arguments[0], arguments[1], "--report", file("r"), "--csv", file("r")},
                {"written twice"});
}

TEST_F(EvaluateTool, RefusesAWrongCommandLine)
{
  expectRefused({}, {"PREDICTION and TRUTH are needed", "given: 0"}, 2);
  expectRefused({scan_}, {"given: 1"}, 2);
  expectRefused({scan_, scan_, scan_}, {"given: 3"}, 2);
  expectRefused({scan_, scan_, "--protocol", "scanet"},
                {"'scanet'", "paper, scannet or s3dis"},
                2);
  expectRefused({scan_, scan_, "--nonsense"}, {"--nonsense"}, 2);
  expectRefused({scan_, scan_, "--report", ""}, {"--report"}, 2);
}

} // namespace
} // namespace pcl_cid::test
