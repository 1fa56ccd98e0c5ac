/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --html: the page holds what was made, whatever the scan and its name.
 */

#include "picture/page_template.h"
#include "picture_page.h"
#include "tool_process.h"

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/io/mesh_import.h>
#include <pcl_cid/io/session_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using Labels = std::vector<std::uint32_t>;

class PictureTool : public ToolTest {
protected:
  void
  SetUp() override
  {
    if (tools::pageTemplate().empty())
      GTEST_SKIP() << "this build has no page";
  }

  PicturePage
  page(const std::string& name = "page.html") const
  {
    return PicturePage(readText(file(name)));
  }

  /** One line that says so, before the work, and nothing written. */
  void
  expectRefused(Arguments arguments,
                int exit_code,
                const std::string& complaint,
                const std::string& scan = "scan.pcd") const
  {
    const Arguments before = folder_.names();
    arguments.insert(arguments.begin(), {file(scan), file("out.pcd")});
    const ToolRun done = run("pcl_cid_segment", arguments);
    EXPECT_EQ(done.exit_code, exit_code) << done.err;
    EXPECT_NE(done.err.find(complaint), std::string::npos) << done.err;
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
    EXPECT_EQ(done.out.find("Segmenting"), std::string::npos) << done.out;
    EXPECT_EQ(folder_.names(), before);
  }
};

Labels
labelsIn(const std::string& path)
{
  const LabelledCloud cloud = readCloud(path);
  return labelsOf(cloud, "label", pointsOf(cloud));
}

/** Each point of the desk scan has its row and its column as a color. */
std::size_t
deskPointOf(const PicturePage& page, std::size_t point)
{
  return 40 * std::size_t{page.colors[3 * point]} + page.colors[3 * point + 1];
}

/** All finite points of the desk scan are there once, where they are, and points have
 *  the same mark where they have the same label. */
void
expectDesk(const PicturePage& page, const Labels& labels)
{
  const LabelledCloud scan = deskScan();
  const FileCoordinates coordinates(scan);
  ASSERT_EQ(page.positions.size(), 3 * pointsOf(scan).finite);
  ASSERT_EQ(page.labels.size(), page.positions.size() / 3);
  ASSERT_EQ(page.colors.size(), page.positions.size());
  std::map<std::uint32_t, std::uint32_t> label_of;
  std::set<std::uint32_t> different;
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < page.labels.size(); ++i) {
    const std::size_t point = deskPointOf(page, i);
    EXPECT_TRUE(seen.insert(point).second) << point;
    EXPECT_LT((page.position(i) - coordinates[point]).norm(), 1e-6) << point;
    const auto known = label_of.emplace(page.labels[i], labels[point]).first;
    EXPECT_EQ(known->second, labels[point]) << point;
    EXPECT_EQ(page.labels[i] == 0, labels[point] == 0) << point;
    different.insert(labels[point]);
  }
  EXPECT_EQ(label_of.size(), different.size());
  for (const nlohmann::json& mark : page.facts["marks"])
    EXPECT_EQ(mark["points"],
              std::count(page.labels.begin(), page.labels.end(), mark["index"]));
}

/** The names in the list, but for what is in none. */
std::set<std::string>
namesIn(const PicturePage& page)
{
  std::set<std::string> names;
  for (const nlohmann::json& mark : page.facts["marks"])
    if (mark["index"] != 0)
      names.insert(mark["name"]);
  return names;
}

/** Finite points of the desk scan. */
std::vector<std::string>
deskPoints()
{
  std::vector<std::string> points;
  const Labels surfaces = deskLabels();
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i] != 0)
      points.push_back(std::to_string(i));
  return points;
}

TEST_F(PictureTool, ShowsGroups)
{
  segment({scan_, file("out.pcd"), "--html", file("page.html")});
  const PicturePage page = this->page();
  EXPECT_EQ(page.facts["kind"], "groups");
  EXPECT_EQ(page.facts["name"], "scan");
  EXPECT_EQ(page.facts["indices"], 12);
  EXPECT_EQ(page.facts["report"]["seeds"]["number"], 12);
  EXPECT_EQ(namesIn(page).size(), 12u);
  EXPECT_EQ(namesIn(page).count("Group 0"), 1u);
  EXPECT_TRUE(page.values.empty());
  expectDesk(page, labelsIn(file("out.pcd")));
}

TEST_F(PictureTool, ShowsLabelsWithTheirNames)
{
  const std::vector<std::string> points = deskPoints();
  writeText(file("seeds.csv"),
            "index,x,y,z,label\n" + points[0] + ",,,,4000000000\n" + points[400] +
                ",,,,lamp\n" + points[700] + ",,,,0\n");
  segment({scan_,
           file("out.pcd"),
           "--labels",
           file("seeds.csv"),
           "--html",
           file("page.html")});
  const PicturePage page = this->page();
  EXPECT_EQ(page.facts["kind"], "labels");
  EXPECT_EQ(page.facts["indices"], 2);
  EXPECT_EQ(namesIn(page), (std::set<std::string>{"lamp", "Label 4000000000"}));
  expectDesk(page, labelsIn(file("out.pcd")));
}

TEST_F(PictureTool, ShowsPartsAndTheirHulls)
{
  abstract({scan_,
            file("out.ply"),
            "--parts",
            "5",
            "--labels",
            file("labels.pcd"),
            "--report",
            file("report.json"),
            "--html",
            file("page.html")});
  const PicturePage page = this->page();
  EXPECT_EQ(page.facts["kind"], "parts");
  expectDesk(page, labelsIn(file("labels.pcd")));
  const std::vector<TriangleMesh> hulls = readPLY(file("out.ply"));
  ASSERT_EQ(page.facts["hulls"].size(), hulls.size());
  std::size_t vertex = 0;
  std::size_t corner = 0;
  for (const nlohmann::json& facts : page.facts["hulls"]) {
    const TriangleMesh& hull = hulls.at(facts["part"].get<std::size_t>() - 1);
    ASSERT_EQ(facts["vertices"], hull.vertices.size());
    ASSERT_EQ(facts["triangles"], hull.triangles.size());
    for (const Eigen::Vector3d& expected : hull.vertices)
      EXPECT_LT((page.hullVertex(vertex++) - expected).norm(), 1e-6);
    for (const auto& triangle : hull.triangles)
      for (const std::uint32_t expected : triangle)
        EXPECT_EQ(page.hull_triangles.at(corner++), expected);
  }
  EXPECT_EQ(page.hull_vertices.size(), 3 * vertex);
  EXPECT_EQ(page.hull_triangles.size(), corner);

  const auto report = nlohmann::json::parse(readText(file("report.json")));
  EXPECT_EQ(page.facts["report"]["tightness"], report["tightness"]);
  for (const nlohmann::json& mark : page.facts["marks"])
    if (mark["index"] > 0) {
      const auto& part = report["parts"][mark["index"].get<std::size_t>() - 1];
      EXPECT_EQ(mark["max_concavity"], part["max_concavity"]);
      EXPECT_EQ(mark["volume"], part["volume"]);
    }
}

TEST_F(PictureTool, ShowsAHeatMap)
{
  const std::string from = deskPoints()[300];
  ASSERT_EQ(
      run("pcl_cid_segment",
          {scan_, file("out.pcd"), "--cid-from", from, "--html", file("page.html")})
          .exit_code,
      0);
  const PicturePage page = this->page();
  EXPECT_EQ(page.facts["kind"], "values");
  EXPECT_EQ(page.facts["values"], "CID from point " + from);
  EXPECT_TRUE(page.labels.empty());
  ASSERT_EQ(page.values.size(), page.positions.size() / 3);
  const auto cids = valuesOf<float>(readCloud(file("out.pcd")).fields, "cid");
  for (std::size_t i = 0; i < page.values.size(); ++i)
    EXPECT_EQ(page.values[i], cids[deskPointOf(page, i)]);
}

TEST_F(PictureTool, ShowsWhatASessionHas)
{
  const LabelledCloud scan = readCloud(scan_);
  const std::string odd = "</script><script>alert(1)</script><!--";
  {
    SessionFile session(file("s.session"), identityOf(scan), {});
    const std::vector<std::string> points = deskPoints();
    session.append(LabelAction{
        action::Click{{std::stoi(points[0])}, action::NewInstance{"wall", ""}}});
    session.append(LabelAction{
        action::Click{{std::stoi(points[600])}, action::NewInstance{"box", odd}}});
    session.append(PartAction{part_action::Decompose{12}});
    session.append(PartAction{part_action::Cut{3}});
  }
  const Arguments more{"--session", file("s.session"), "--html", file("page.html")};
  Arguments arguments{scan_, file("out.pcd")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ToolRun labels = run("pcl_cid_segment", arguments);
  ASSERT_EQ(labels.exit_code, 0) << labels.err;
  EXPECT_EQ(namesIn(page()), (std::set<std::string>{"wall 1", odd}));
  expectDesk(page(), labelsIn(file("out.pcd")));

  arguments[1] = file("out.ply");
  arguments.insert(arguments.end(), {"--labels", file("labels.pcd")});
  const ToolRun parts = run("pcl_cid_abstract", arguments);
  ASSERT_EQ(parts.exit_code, 0) << parts.err;
  EXPECT_EQ(page().facts["hulls"].size(), 3u);
  EXPECT_TRUE(page().facts["marks"][0].contains("free_share"));
  expectDesk(page(), labelsIn(file("labels.pcd")));
}

TEST_F(PictureTool, HasTheSameBytesEachTimeAndForEveryNumberOfThreads)
{
  for (const char* const threads : {"1", "3", "1"}) {
    const bool is_first = !fs::exists(file("s.html"));
    segment({scan_,
             file("out.pcd"),
             "--threads",
             threads,
             "--html",
             file(is_first ? "s.html" : "s2.html")});
    abstract({scan_,
              file("out.obj"),
              "--threads",
              threads,
              "--html",
              file(is_first ? "a.html" : "a2.html")});
    if (is_first)
      continue;
    EXPECT_EQ(readText(file("s2.html")), readText(file("s.html")));
    EXPECT_EQ(readText(file("a2.html")), readText(file("a.html")));
  }
}

TEST_F(PictureTool, NeedsNothingFromOutside)
{
  segment({scan_, file("out.pcd"), "--html", file("page.html")});
  const std::string page = readText(file("page.html"));
  EXPECT_EQ(page.find("<!-- data -->"), std::string::npos);
  const std::size_t policy = page.find("http-equiv=\"Content-Security-Policy\"");
  ASSERT_NE(policy, std::string::npos);
  EXPECT_LT(policy, page.find("<script"));
  EXPECT_LT(policy, page.find("<style"));
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("unsafe-inline"), std::string::npos);
  EXPECT_EQ(timesIn(page, "<link"), 1u); // the icon
  EXPECT_EQ(timesIn(page, "<link rel=\"icon\" href=\"data:,\""), 1u);
  EXPECT_EQ(page.find(" src=\""), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
}

TEST_F(PictureTool, IsWholeWhateverTheNamesOfFiles)
{
  segment({scan_, file("out.pcd"), "--html", file("page.html")});
  const std::string plain = readText(file("page.html"));
  const std::string folder = "a <";
  fs::create_directory(file(folder));
  for (const std::string& odd : {std::string("script><img src=x onerror=alert(1)>.pcd"),
                                 std::string("\"'&amp; \xff\xfe <!-- data -->.pcd"),
                                 std::string("\u2028 \\u003c.pcd")}) {
    const std::string scan = file(folder + "/" + odd);
    fs::copy_file(scan_, scan);
    segment({scan, file("out.pcd"), "--html", file("odd's <b>.html")});
    const std::string page = readText(file("odd's <b>.html"));
    for (const char* const part : {"<script", "</script>", "<img", "<!--"})
      EXPECT_EQ(timesIn(page, part), timesIn(plain, part)) << odd;
    const nlohmann::json facts = PicturePage(page).facts;
    const std::string input = facts["report"]["input"];
    if (odd.find('\xff') == std::string::npos) {
      EXPECT_EQ(input, scan);
    }
    EXPECT_EQ(PicturePage(page).positions, PicturePage(plain).positions);
  }
}

TEST_F(PictureTool, TakesScansOfAnySize)
{
  saveCloud(file("three.pcd"), threePoints(), pcd_binary);
  segment({file("three.pcd"), file("out.pcd"), "--html", file("page.html")});
  EXPECT_EQ(page().positions.size(), 3 * pointsOf(threePoints()).finite);
  EXPECT_TRUE(page().colors.empty());
  abstract({file("three.pcd"), file("out.ply"), "--html", file("page.html")});
  EXPECT_FALSE(page().hull_vertices.empty());
  writeText(file("one.pcd"), "FIELDS x y z\nPOINTS 2\nDATA ascii\n1 2 3\nnan 0 0\n");
  segment({file("one.pcd"), file("out.pcd"), "--html", file("page.html")});
  EXPECT_EQ(page().position(0), Eigen::Vector3d(1.0, 2.0, 3.0));
}

TEST_F(PictureTool, KeepsMillimetresAtUTMCoordinates)
{
  LabelledCloud moved;
  std::vector<double> xyz[3];
  const LabelledCloud desk = deskScan();
  for (std::size_t i = 0; i < desk.size(); ++i) {
    const Eigen::Vector3d p =
        FileCoordinates(desk)[i] + Eigen::Vector3d(482000.25, 5470000.5, 110.0);
    for (int axis = 0; axis < 3; ++axis)
      xyz[axis].push_back(p[axis]);
  }
  for (int axis = 0; axis < 3; ++axis)
    appendField(std::string(1, "xyz"[axis]), xyz[axis], moved.fields);
  appendField("rgb", valuesOf<float>(desk.fields, "rgb"), moved.fields);
  saveCloud(file("utm.pcd"), moved, pcd_binary);
  segment({file("utm.pcd"), file("out.pcd"), "--html", file("page.html")});
  const PicturePage page = this->page();
  for (std::size_t i = 0; i < page.labels.size(); ++i) {
    const std::size_t point = deskPointOf(page, i);
    const Eigen::Vector3d p(xyz[0][point], xyz[1][point], xyz[2][point]);
    EXPECT_LT((page.position(i) - p).norm(), 1e-4);
  }
}

TEST_F(PictureTool, RefusesWhatItCannotWrite)
{
  expectRefused({"--html", file("page.htm")}, 2, ".html");
  expectRefused({"--html", file("missing/page.html")}, 1, "missing");
  fs::copy_file(scan_, file("scan.html"));
  expectRefused({"--html", file("scan.html")}, 1, "scan.html", "scan.html");
  fs::create_hard_link(scan_, file("link.html"));
  expectRefused({"--html", file("link.html")}, 1, "link.html");
  expectRefused({"--html", file("r.html"), "--report", file("r.html")}, 1, "r.html");
  fs::create_directory(file("folder.html"));
  expectRefused({"--html", file("folder.html")}, 1, "folder.html");
  expectRefused({"--html", file("a.html"), "--html", file("b.html")}, 2, "html");
}

TEST_F(PictureTool, RefusesColorsThatCannotBeRead)
{
  writeText(file("scan.pcd"),
            "FIELDS x y z red green blue\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\n"
            "POINTS 2\nDATA ascii\n0 0 0 1 2 -3\n1 0 0 1 2 3\n");
  expectRefused({"--html", file("page.html")}, 1, "blue");
}

/** A build that has no page says what it needs. */
TEST(PageTemplate, ThatIsMissingIsSaidBeforeTheWork)
{
  const std::string complaint =
      complaintAbout("", [] { tools::requirePageTemplate({}); });
  EXPECT_NE(complaint.find("--html"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("Debian: nodejs, npm"), std::string::npos) << complaint;
  EXPECT_NO_THROW(tools::requirePageTemplate("page"));
}

} // namespace
} // namespace pcl_cid::test
