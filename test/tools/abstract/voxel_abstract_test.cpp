/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls of scans of which one point of each voxel is worked on: all points are inside.
 */

#include "abstract/hull_verification.h"
#include "abstract/voxel_parts.h"
#include "clouds.h"
#include "hulls.h"
#include "tool_process.h"
#include "voxel_choice.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

using Arguments = std::vector<std::string>;
using PartLabels = std::vector<std::uint32_t>;

Arguments
joined(Arguments first, const Arguments& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

class VoxelAbstract : public ToolTest {
protected:
  VoxelAbstract() { saveCloud(rows_, deskScan(), pcd_binary); }

  PartLabels
  labelsIn(const std::string& path) const
  {
    return valuesOf<std::uint32_t>(readCloud(path).fields, "label");
  }

  std::vector<TriangleMesh>
  hullsIn(const std::string& path) const
  {
    return meshFormatOf(path).read(path);
  }

  nlohmann::json
  report() const
  {
    return nlohmann::json::parse(readText(file("report.json")));
  }

  std::string
  complaintOf(const Arguments& arguments, int exit_code) const
  {
    const ToolRun done = run("pcl_cid_abstract", arguments);
    EXPECT_EQ(done.exit_code, exit_code) << done.err;
    return done.err;
  }

  /** How much more, at most, points are outside of the hull of their part than a hull
   *  may miss, in metres of the file; 0 or less when all is well.
   *  \param[in] labels of the points, from 1; 0 for those in no part */
  static double
  worstExcess(const std::string& scan,
              const PartLabels& labels,
              const std::vector<TriangleMesh>& hulls,
              double padding = 0.0)
  {
    constexpr double rounded = 5e-5; // by float, at most
    const LabelledCloud cloud = readCloud(scan);
    const FileCoordinates at(cloud);
    double worst = -1.0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] == 0)
        continue;
      const TriangleMesh& hull = hulls.at(labels[i] - 1);
      worst = std::max(worst,
                       excess(hull, at[i]) + padding - rounded -
                           hull_tolerance * diagonalOf(hull.vertices));
    }
    return worst;
  }

  /** Parts are those that points of voxels have by themselves, others are in that of
   * the nearest, and hulls contain all. \return how far points are outside of the hulls
   * of the points of voxels alone */
  double
  expectAsByHand(const std::string& scan,
                 double size,
                 const Arguments& more,
                 double padding = 0.0,
                 std::size_t stride = 1)
  {
    SCOPED_TRACE(scan + " " + more.back());
    const pcl::Indices source = chooseFrom(scan, size, file("chosen.pcd"));
    abstract(joined(
        {file("chosen.pcd"), file("by_hand.obj"), "--labels", file("by_hand.pcd")},
        more));
    abstract(joined({scan,
                     file("out.obj"),
                     "--voxel",
                     std::to_string(size),
                     "--verify",
                     "--labels",
                     file("out.pcd"),
                     "--report",
                     file("report.json")},
                    more));
    const PartLabels labels = labelsIn(file("out.pcd"));
    PartLabels expected = labels;
    findByBruteForce(scan, source, labelsIn(file("by_hand.pcd")), stride, expected);
    EXPECT_EQ(labels, expected);
    expectInputWith(labels, scan);
    expectCounts(labels, pointsOf(readCloud(scan)).finite);
    EXPECT_LE(worstExcess(scan, labels, hullsIn(file("out.obj")), padding), 0.0);
    return worstExcess(scan, labels, hullsIn(file("by_hand.obj")), padding);
  }

  /** The cloud of labels is the input in its order, with all fields. */
  void
  expectInputWith(const PartLabels& labels, const std::string& scan) const
  {
    LabelledCloud whole = readCloud(scan);
    setLabels(labels, LabelType::U4, whole);
    saveCloud(file("expected.pcd"), whole, readCloud(file("out.pcd")).layout);
    EXPECT_EQ(readText(file("out.pcd")), readText(file("expected.pcd")));
  }

  /** The report counts points of the file. */
  void
  expectCounts(const PartLabels& labels, std::size_t finite) const
  {
    const auto json = report();
    std::size_t covered = 0;
    std::size_t trimmed = 0;
    for (std::size_t k = 0; k < json["parts"].size(); ++k) {
      const auto& part = json["parts"][k];
      EXPECT_EQ(part["points"], std::count(labels.begin(), labels.end(), k + 1));
      EXPECT_LE(part["voxels"], part["points"]);
      covered += part["points"].get<std::size_t>();
      trimmed += part["trimmed_points"].get<std::size_t>();
    }
    EXPECT_EQ(covered + trimmed + json["points"]["dropped"].get<std::size_t>(), finite);
    EXPECT_EQ(json["points"]["in"], labels.size());
    EXPECT_EQ(json["points"]["finite"], finite);
    EXPECT_EQ(json["points"]["grouped"], finite);
  }

  /** A scan of the shared folder as a binary file; empty when it is absent. */
  std::string
  binaryCopyOf(const std::string& name) const
  {
    const std::string scan = PCL_CID_SHARED_DIR "/data/" + name;
    if (!std::filesystem::exists(scan))
      return "";
    saveCloud(file("copy.pcd"), readCloud(scan), pcd_binary);
    return file("copy.pcd");
  }

  const std::string rows_ = file("rows.pcd");
};

TEST_F(VoxelAbstract, HullsContainAllPointsOfTheFile)
{
  const double missed =
      expectAsByHand(rows_, 0.15, {"--parts", "5", "--merging", "cid"});
  EXPECT_GT(missed, 0.001); // those of the voxels' points do not
  for (const Arguments& more : std::vector<Arguments>{
           {"--parts", "4", "--merging", "hull"},
           {"--parts", "4", "--max-vertices", "auto", "--merging", "hull"},
           {"--parts", "4", "--max-vertices", "8"},
           {"--parts", "3", "--groups", "patches"},
           {"--threshold", "0.05", "--min-points", "9"},
           {"--parts", "2", "--trim-distance", "0.2"}})
    expectAsByHand(rows_, 0.15, more);
  expectAsByHand(rows_, 0.15, {"--parts", "4", "--padding", "0.03"}, 0.03);
}

/** The fit keeps a bound that is less by the diagonal of a voxel, and so the hulls of
 * all points keep the one that was asked for. */
TEST_F(VoxelAbstract, KeepsTheBoundOnTheError)
{
  constexpr double bound = 0.55;
  const auto labels = [&](const Arguments& more) {
    abstract(joined(more, {"--merging", "hull", "--labels", file("labels.pcd")}));
    return labelsIn(file("labels.pcd"));
  };
  const pcl::Indices source = chooseFrom(rows_, 0.1, file("chosen.pcd"));
  const PartLabels by_hand =
      labels({file("chosen.pcd"),
              file("by_hand.obj"),
              "--max-error",
              nlohmann::json(bound - std::sqrt(3.0) * 0.1).dump()});
  const PartLabels of_all = labels(
      {rows_, file("out.obj"), "--voxel", "0.1", "--max-error", "0.55", "--verify"});
  for (std::size_t k = 0; k < source.size(); ++k)
    EXPECT_EQ(of_all[static_cast<std::size_t>(source[k])], by_hand[k]);
  EXPECT_GT(*std::max_element(by_hand.begin(), by_hand.end()), 1u);
  const LabelledCloud cloud = readCloud(rows_);
  const FileCoordinates at(cloud);
  for (const TriangleMesh& hull : hullsIn(file("out.obj")))
    for (const Eigen::Vector3d& corner : hull.vertices) {
      double nearest = bound * 2.0;
      for (std::size_t i = 0; i < of_all.size(); ++i)
        if (of_all[i] > 0)
          nearest = std::min(nearest, (at[i] - corner).norm());
      EXPECT_LE(nearest, bound);
    }
}

/** Coordinates of UTM, in double. */
TEST_F(VoxelAbstract, DoesSoWithARealScan)
{
  const std::string terrain = binaryCopyOf("terrain_csite3_utm.pcd");
  if (terrain.empty())
    GTEST_SKIP() << "the shared scans are absent";
  expectAsByHand(terrain, 15.0, {"--parts", "6"}, 0.0, 1009);
}

TEST_F(VoxelAbstract, DoesSoWithWhatIsHardlyAScan)
{
  const Eigen::Vector3f once(1.0f, 2.0f, 3.0f);
  Points floor;
  Points rod;
  for (int i = 0; i < 400; ++i) {
    floor.emplace_back(
        0.05f * static_cast<float>(i % 20), 0.05f * static_cast<float>(i / 20), 0.0f);
    rod.push_back(0.01f * static_cast<float>(i) * Eigen::Vector3f(1.0f, 1.0f, 0.5f));
  }
  for (const Points& points : {Points{once}, Points(50, once), floor, rod}) {
    saveCloud(file("tiny.pcd"), toLabelledCloud(*toCloud(points)), pcd_binary);
    for (const std::string size : {"0.17", "100"}) {
      abstract({file("tiny.pcd"),
                file("tiny.obj"),
                "--voxel",
                size,
                "--verify",
                "--parts",
                "1",
                "--labels",
                file("labels.pcd")});
      EXPECT_EQ(labelsIn(file("labels.pcd")), PartLabels(points.size(), 1));
      EXPECT_LE(worstExcess(file("tiny.pcd"),
                            PartLabels(points.size(), 1),
                            hullsIn(file("tiny.obj"))),
                0.0);
    }
  }
}

/** Voxels are of metres, hulls and clouds of the unit that is asked for. */
TEST_F(VoxelAbstract, WritesTheUnitThatIsAskedFor)
{
  LabelledCloud scan = readCloud(rows_);
  scan.scale = 1000.0;
  convertToMetres(scan); // what were metres are taken for kilometres
  saveCloud(file("millimetres.pcd"), scan, pcd_binary);
  for (const std::string unit : {"file", "metre"}) {
    abstract({file("millimetres.pcd"),
              file("hulls.obj"),
              "--voxel",
              "0.15",
              "--scale",
              "0.001",
              "--output-unit",
              unit,
              "--parts",
              "5",
              "--verify",
              "--labels",
              file("labels.pcd")});
    const std::vector<TriangleMesh> hulls = hullsIn(file("hulls.obj"));
    ASSERT_EQ(hulls.size(), 5u);
    EXPECT_LE(worstExcess(file("labels.pcd"), labelsIn(file("labels.pcd")), hulls),
              0.0);
    EXPECT_LT(diagonalOf(hulls[0].vertices), unit == "file" ? 20000.0 : 20.0);
    EXPECT_GT(diagonalOf(hulls[0].vertices), unit == "file" ? 20.0 : 0.02);
  }
}

TEST_F(VoxelAbstract, WritesTheSameBytesOnEveryNumberOfThreads)
{
  std::set<std::string> outputs;
  for (const std::string threads : {"1", "2", "3", "8"}) {
    abstract({rows_,
              file("hulls.obj"),
              "--voxel",
              "0.1",
              "--parts",
              "4",
              "--labels",
              file("labels.pcd"),
              "--threads",
              threads,
              "--report",
              file("report.json")});
    auto json = report();
    for (const char* const other : {"seconds", "peak_memory_bytes"})
      json.erase(other);
    json["parameters"].erase("threads");
    outputs.insert(readText(file("hulls.obj")) + readText(file("labels.pcd")) +
                   json.dump());
  }
  EXPECT_EQ(outputs.size(), 1u);
}

TEST_F(VoxelAbstract, TellsWhatWasTrimmedAndDroppedByTheFile)
{
  Points points = randomCube(3000, 3);
  const std::size_t far_off = points.size();
  for (int i = 0; i < 5; ++i) // a stray cluster of one voxel
    points.emplace_back(1.6f + 0.001f * static_cast<float>(i), 0.51f, 0.51f);
  saveCloud(file("cube.pcd"), toLabelledCloud(*toCloud(points)), pcd_binary);
  const ToolRun done = abstract({file("cube.pcd"),
                                 file("cube.obj"),
                                 "--voxel",
                                 "0.1",
                                 "--parts",
                                 "1",
                                 "--trim-distance",
                                 "0.3",
                                 "--verify",
                                 "--report",
                                 file("report.json")});
  EXPECT_NE(done.out.find("Stray points trimmed: 5"), std::string::npos) << done.out;
  const auto part = report()["parts"][0];
  EXPECT_EQ(part["points"], 3000);
  EXPECT_EQ(part["trimmed_points"], 5);
  ASSERT_EQ(part["trimmed"].size(), 1u);
  EXPECT_EQ(part["trimmed"][0], far_off + 2); // nearest to the mean of its voxel
}

/** All points of the file are shown to --verify, not those of the voxels alone. */
TEST_F(VoxelAbstract, VerifiesAllPointsOfTheFile)
{
  tools::AbstractSettings settings;
  settings.input = rows_;
  settings.voxel = 0.15;
  tools::Run run(tools::abstract_tool, true, {});
  tools::VoxelScan voxels(settings, "", {}, run);
  const tools::LoadedScan& scan = voxels.scan();
  tools::AbstractedScan of_voxels;
  of_voxels.parts = makeConvexParts(finitePoints(*scan.points.points),
                                    std::vector<int>(scan.cloud.size(), 0),
                                    {},
                                    {});
  tools::AbstractedScan of_all = of_voxels;
  tools::VoxelParts parts(settings, voxels, run);
  parts.cover({}, of_all);
  EXPECT_EQ(of_all.followed[0].points, voxels.finite());
  OutputFiles outputs({});
  outputs.announce(file("hulls.ply"));
  const auto complaint = [&](const tools::AbstractedScan& abstracted) -> std::string {
    outputs.write(file("hulls.ply"), [&](std::ostream& stream) {
      writeMesh(stream, abstracted.parts, "hulls.ply");
    });
    try {
      tools::verifyMesh(file("hulls.ply"),
                        {abstracted, scan.points.frame, parts.show(), 1.0, nullptr},
                        outputs);
    }
    catch (const CIDException& exception) {
      return exception.what();
    }
    return "";
  };
  EXPECT_EQ(complaint(of_all), "");
  EXPECT_NE(complaint(of_voxels).find("is not contained"), std::string::npos);
}

/** What is held depends on the voxels, however many points they have. */
TEST_F(VoxelAbstract, MemoryIsThatOfTheVoxels)
{
  const auto peak = [&](std::size_t points) {
    saveCloud(
        file("cube.pcd"), toLabelledCloud(*toCloud(randomCube(points, 3))), pcd_binary);
    const ToolRun done = runFromSmallProcess("pcl_cid_abstract",
                                             {file("cube.pcd"),
                                              file("out.obj"),
                                              "--voxel",
                                              "0.25",
                                              "--parts",
                                              "2",
                                              "--merging",
                                              "cid",
                                              "--verify",
                                              "--labels",
                                              file("out.pcd"),
                                              "--threads",
                                              "1",
                                              "--report",
                                              file("report.json")});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(report()["points"]["voxels"], 64);
    return report()["peak_memory_bytes"].get<double>();
  };
  const double of_few = peak(100000);
  EXPECT_LT(peak(800000), of_few + 5e6); // the file has 10 MB
}

TEST_F(VoxelAbstract, RefusesWhatItCannotKeep)
{
  const std::string out = file("o.obj");
  for (const Arguments& more : std::vector<Arguments>{{"--curve", "c.csv"},
                                                      {"--session", "s.jsonl"},
                                                      {"--mesh-spacing", "0.1"},
                                                      {"--class-table", "t.tsv"}})
    EXPECT_NE(complaintOf(joined({rows_, out, "--voxel", "0.1"}, more), 2)
                  .find("needs all points"),
              std::string::npos)
        << more.front();
  EXPECT_NE(
      complaintOf({"-", out, "--voxel", "0.1", "--parts", "2"}, 2).find("several"),
      std::string::npos);
  EXPECT_NE(complaintOf({rows_, out, "--voxel", "0.1", "--max-error", "0.17"}, 2)
                .find("0.1782 m"),
            std::string::npos);
  EXPECT_NE(complaintOf({scan_, out, "--voxel", "0.1", "--parts", "2"}, 1)
                .find("cannot be read block by block"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out));
}

} // namespace
} // namespace pcl_cid::test
