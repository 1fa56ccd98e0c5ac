/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Several scans in one call: each as in a call of its own, whatever becomes of others.
 */

#include "many_scans_tool.h"

#include <csignal>

#include <unistd.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;

TEST_F(ManyScansTest, AreSegmentedAsEachAlone)
{
  const Arguments options{"--propose",
                          file("many/{}_seeds.csv"),
                          "--superpoints",
                          file("many/{}.segs.json"),
                          "--report",
                          file("many/{}_report.json")};
  runEach("pcl_cid_segment", "", options);
  const ToolRun done = runAll("pcl_cid_segment", options);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(linesOf(done.out), 3u) << done.out;
  EXPECT_NE(done.out.find("Segmenting " + file("scans/b.ply") + " (2 of 3) [done, "),
            std::string::npos)
      << done.out;
  EXPECT_NE(done.out.find("600 points, 7 groups]"), std::string::npos) << done.out;
  expectSameFiles();
  EXPECT_EQ(filesBelow("many").size(), 12u);

  // What was proposed, labelled, with a table for each scan.
  for (const std::string name : {"a", "b", "c"}) {
    const std::string table = readText(file("many/" + name + "_seeds.csv"));
    writeText(file("scans/" + name + ".csv"),
              std::regex_replace(table, std::regex(",\n"), ",5\n"));
  }
  for (const char* const folder : {"many", "single"}) {
    fs::remove_all(file(folder));
    fs::create_directory(file(folder));
  }
  const Arguments labels{
      "--output-dir", file("many"), "--labels", file("scans/{}.csv")};
  Arguments arguments{file("scans/a.pcd"), file("scans/b.ply"), file("scans/c.pcd")};
  arguments.insert(arguments.end(), labels.begin(), labels.end());
  EXPECT_EQ(run("pcl_cid_segment", arguments).exit_code, 0);
  segment({file("scans/b.ply"), file("single/b.ply"), "--labels", file("scans/b.csv")});
  EXPECT_EQ(readText(file("many/b.ply")), readText(file("single/b.ply")));
  // A table that is missing fails its scan alone, and at once.
  fs::remove(file("scans/a.csv"));
  const ToolRun missing = run("pcl_cid_segment", arguments);
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.err.find("1 of 3 scans could not be segmented:\n  " +
                             file("scans/a.pcd") + ": " + file("scans/a.csv")),
            std::string::npos)
      << missing.err;
}

TEST_F(ManyScansTest, AreAbstractedAsEachAlone)
{
  const Arguments options{"--labels",
                          file("many/{}_parts.pcd"),
                          "--tree",
                          file("many/{}_tree.json"),
                          "--urdf",
                          file("many/{}.urdf"),
                          "--report",
                          file("many/{}_report.json"),
                          "--parts",
                          "3",
                          "--verify"};
  runEach("pcl_cid_abstract", ".obj", options);
  const ToolRun done = runAll("pcl_cid_abstract", options);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(linesOf(done.out), 3u) << done.out;
  EXPECT_NE(done.out.find("600 points, 7 groups, 3 parts]"), std::string::npos);
  expectSameFiles();
  EXPECT_EQ(filesBelow("many").count("a_parts/a_part_000.obj"), 1u);
  EXPECT_EQ(filesBelow("many").count("c.mtl"), 1u);

  Arguments stl = options;
  stl.insert(stl.end(), {"--mesh-format", "stl"});
  runEach("pcl_cid_abstract", ".stl", options);
  EXPECT_EQ(runAll("pcl_cid_abstract", stl).exit_code, 0);
  expectSameFiles();
}

TEST_F(ManyScansTest, HaveTheSameBytesForEveryNumberOfThreads)
{
  EXPECT_EQ(runAll("pcl_cid_segment", {"--threads", "1"}).exit_code, 0);
  const auto one = filesBelow("many");
  for (const char* const threads : {"2", "8"}) {
    EXPECT_EQ(runAll("pcl_cid_segment", {"--threads", threads}).exit_code, 0);
    EXPECT_TRUE(filesBelow("many") == one) << threads;
  }
}

TEST_F(ManyScansTest, GoOnAfterThoseThatFail)
{
  const std::string whole = readText(file("scans/b.ply"));
  writeText(file("scans/b.ply"), whole.substr(0, whole.size() / 2));
  writeText(file("scans/d.doc"), "0 0 0\n");
  Arguments arguments = allScans({"--quiet"});
  arguments.insert(arguments.begin(), {file("scans/no.pcd"), file("scans/d.doc")});
  const Arguments scans(arguments.begin(), arguments.begin() + 5);
  for (const std::string summary : {"sum.csv", "sum.json"}) {
    Arguments with_summary = arguments;
    with_summary.insert(with_summary.end(), {"--summary", file(summary)});
    const ToolRun done = run("pcl_cid_segment", with_summary);
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(linesOf(done.err), 7u) << done.err; // three, and the list of them
    const std::string list =
        done.err.substr(done.err.find("3 of 5 scans could not be segmented:\n"));
    EXPECT_NE(list.find("\n  " + scans[0] + ": there is no such file\n"),
              std::string::npos)
        << list;
    EXPECT_NE(list.find("\n  " + scans[1] + ": is neither a PCD"), std::string::npos);
    EXPECT_NE(list.find("\n  " + scans[3] + ": is truncated"), std::string::npos);

    const nlohmann::json rows = readByPython(file(summary));
    ASSERT_EQ(rows.size(), 5u);
    const Arguments status{"failed", "failed", "done", "failed", "done"};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i]["scan"], scans[i]);
      EXPECT_EQ(rows[i]["status"], status[i]);
    }
    EXPECT_EQ(rows[0]["error"], scans[0] + ": there is no such file");
    EXPECT_EQ(rows[4]["name"], "c");
    if (summary == "sum.json") {
      EXPECT_EQ(rows[4]["points"], 600);
      EXPECT_EQ(rows[4]["seeds"], 7);
      EXPECT_EQ(rows[4]["groups"], 7);
      EXPECT_EQ(rows[4]["parts"], nullptr);
      EXPECT_EQ(rows[4]["error"], nullptr);
      EXPECT_GT(rows[4]["seconds"], 0.0);
      EXPECT_EQ(rows[3]["points"], nullptr);
    }
    else {
      EXPECT_EQ(rows[4]["points"], "600");
      EXPECT_EQ(rows[4]["parts"], "");
      EXPECT_EQ(rows[3]["seconds"], "");
    }
    std::map<std::string, std::string> files = filesBelow("many");
    EXPECT_EQ(files.size(), 2u);
    EXPECT_EQ(files.count("a.pcd") + files.count("c.pcd"), 2u);
  }
}

TEST_F(ManyScansTest, LeaveNoFolderBehindWhereAllFail)
{
  const ToolRun done =
      run("pcl_cid_abstract", {file("no.pcd"), "--output-dir", file("new")});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("1 of 1 scan could not be abstracted"), std::string::npos)
      << done.err;
  EXPECT_FALSE(fs::exists(file("new")));
}

TEST_F(ManyScansTest, MayBeListed)
{
  writeText(file("list.txt"),
            file("scans/b.ply") + "\r\n\n" + file("scans/c.pcd")); // no last line end
  const Arguments options{"--output-dir", file("many"), "--cloud-format", "ply"};
  Arguments arguments{scan_, "--scans-from", file("list.txt")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  EXPECT_EQ(run("pcl_cid_segment", arguments).exit_code, 0);
  std::map<std::string, std::string> files = filesBelow("many");
  EXPECT_EQ(files.size(), 3u);
  EXPECT_EQ(files.count("scan.ply") + files.count("b.ply") + files.count("c.ply"), 3u);
  const std::string piped = "cat " + file("list.txt") +
                            " | " PCL_CID_TOOL_DIR "/pcl_cid_segment --scans-from - "
                            "--cloud-format ply --output-dir " +
                            file("piped");
  EXPECT_EQ(run("/bin/sh", {"-c", piped}).exit_code, 0);
  EXPECT_EQ(readText(file("piped/b.ply")), readText(file("many/b.ply")));
  EXPECT_EQ(filesBelow("piped").size(), 2u);
  fs::remove_all(file("many"));
  fs::create_directory(file("many"));
  arguments[2] = file("no.txt");
  expectRefused(run("pcl_cid_segment", arguments), 1, {"no.txt: cannot be read"});
}

TEST_F(ManyScansTest, MayBeAHundred)
{
  Arguments arguments;
  for (int i = 0; i < 100; ++i) {
    arguments.push_back(file("scans/t" + std::to_string(i) + ".pcd"));
    saveCloud(arguments.back(), threePoints(), pcd_ascii);
  }
  arguments.insert(arguments.end(),
                   {"--output-dir",
                    file("many"),
                    "--seeds",
                    "2",
                    "--report",
                    file("many/{}_report.json"),
                    "--summary",
                    file("sum.json")});
  const ToolRun done = run("pcl_cid_segment", arguments);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(linesOf(done.out), 100u);
  EXPECT_EQ(filesBelow("many").size(), 200u); // and nothing hidden
  const nlohmann::json rows = readByPython(file("sum.json"));
  ASSERT_EQ(rows.size(), 100u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i]["name"], "t" + std::to_string(i));
    EXPECT_EQ(rows[i]["points"], 3);
    EXPECT_EQ(rows[i]["finite_points"], 2);
  }
}

TEST_F(ManyScansTest, StopAtAnInterruptAndKeepWhatIsDone)
{
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove_all(file("many"));
    ToolProcess process("pcl_cid_segment",
                        {file("scans/c.pcd"),
                         PCL_CID_DATA_DIR "/room.pcd",
                         file("scans/a.pcd"),
                         "--output-dir",
                         file("many"),
                         "--seeds",
                         "5000",
                         "--summary",
                         file("sum.json")},
                        printed_);
    for (int wait = 0; wait < 1000 && process.printedSoFar().empty(); ++wait)
      usleep(10000); // until the first is done
    usleep(50000);
    process.signal(signal);
    const ToolRun done = process.wait();
    EXPECT_EQ(done.exit_code, 128 + signal);
    EXPECT_NE(done.err.find("interrupted; done: 1 of 3 scans; nothing was written for "
                            "the others\n"),
              std::string::npos)
        << done.err;
    EXPECT_EQ(filesBelow("many").size(), 1u); // hidden ones are counted
    EXPECT_TRUE(fs::exists(file("many/c.pcd")));
    const nlohmann::json rows = readByPython(file("sum.json"));
    EXPECT_EQ(rows[0]["status"], "done");
    EXPECT_EQ(rows[1]["status"], "not done");
    EXPECT_EQ(rows[2]["status"], "not done");
  }
}

TEST_F(ManyScansTest, AreNamedInRemarks)
{
  std::string text =
      "FIELDS x y z\nPOINTS 24\nDATA ascii\n1 0 0\n0 1 0\n0 0 1\n1 1 0\n";
  for (int i = 0; i < 20; ++i)
    text += "0 0 0\n";
  const Arguments scans{file("scans/d.pcd"), file("scans/e.pcd")};
  for (const std::string& scan : scans)
    writeText(scan, text);
  const Arguments arguments{
      scans[0], scans[1], "--output-dir", file("many"), "--seeds", "2"};
  const ToolRun done = run("pcl_cid_segment", arguments);
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(linesOf(done.out), 2u) << done.out;
  EXPECT_EQ(linesOf(done.err), 2u) << done.err;
  for (const std::string& scan : scans)
    EXPECT_NE(done.err.find(scan + ": 20 points lie exactly at (0, 0, 0)"),
              std::string::npos)
        << done.err;
}

TEST_F(ManyScansTest, AreCompletedByBash)
{
  const auto offers = [&](const Arguments& words) {
    Arguments arguments{
        "-c",
        "eval \"$(" PCL_CID_TOOL_DIR "/pcl_cid_abstract --completion)\"; cd \"$1\"; "
        "shift; COMP_WORDS=(pcl_cid_abstract \"$@\"); COMP_CWORD=$#; "
        "_pcl_cid_abstract 2> /dev/null; printf '%s\\n' \"${COMPREPLY[@]}\" | sort",
        "bash",
        file("scans")};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return run("/bin/bash", arguments).out;
  };
  writeText(file("scans/d.gz"), "");
  writeText(file("scans/notes.md"), ""); // neither a scan nor a mesh
  EXPECT_EQ(offers({""}), "a.pcd\nb.ply\nc.pcd\nd.gz\n");
  EXPECT_EQ(offers({"a.pcd", ""}), "a.pcd\nb.ply\nc.pcd\nd.gz\n");
  EXPECT_EQ(offers({"a.pcd", "b.ply", ""}), "a.pcd\nb.ply\nc.pcd\nd.gz\n");
  EXPECT_EQ(offers({"--output-dir", "many", "a.pcd", ""}),
            "a.pcd\nb.ply\nc.pcd\nd.gz\n");
  EXPECT_EQ(offers({"--mesh-format", "s"}), "stl\n");
  const ToolRun page = run("pcl_cid_abstract", {"--man-page"});
  EXPECT_NE(page.out.find("SCAN... \\-\\-output\\-dir DIR"), std::string::npos);
}

} // namespace
} // namespace pcl_cid::test
