/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract: scenes for robot software, all of a run or none.
 */

#include "scene_test.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_import.h>
#include <pcl_cid/io/scene_export.h>

#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;

/** Lets this process and those that it starts write files up to a size only. */
class FileSizeLimit {
public:
  explicit FileSizeLimit(std::uintmax_t bytes)
  {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit&
  operator=(const FileSizeLimit&) = delete;

private:
  rlimit before_{};
};

class SceneOutputs : public SceneTest {
protected:
  /** The content of every file, hidden ones and those in folders, too. */
  std::map<std::string, std::string>
  everything() const
  {
    std::map<std::string, std::string> contents;
    for (const auto& entry : fs::recursive_directory_iterator(file("")))
      contents[entry.path().lexically_relative(file(""))] =
          entry.is_regular_file() ? readText(entry.path()) : "";
    return contents;
  }

  /** The arguments of a run with every kind of output. */
  std::vector<std::string>
  allOutputs(const std::string& parts) const
  {
    return {scan_,      file("hulls.obj"),   "--parts",  parts,
            "--urdf",   file("hulls.urdf"),  "--sdf",    file("hulls.sdf"),
            "--mjcf",   file("hulls.xml"),   "--moveit", file("hulls.scene"),
            "--gltf",   file("hulls.glb"),   "--usd",    file("hulls.usda"),
            "--report", file("report.json"), "--seeds",  "12"};
  }
};

TEST_F(SceneOutputs, NameTheMeshOfEachPart)
{
  ASSERT_EQ(run("pcl_cid_abstract", allOutputs("5")).exit_code, 0);
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"hulls.glb",
                                      "hulls.mtl",
                                      "hulls.obj",
                                      "hulls.scene",
                                      "hulls.sdf",
                                      "hulls.urdf",
                                      "hulls.usda",
                                      "hulls.xml",
                                      "hulls_parts",
                                      "report.json",
                                      "scan.pcd"}));
  const std::vector<TriangleMesh> hulls = readOBJ(file("hulls.obj"));
  ASSERT_EQ(hulls.size(), 5u);
  EXPECT_EQ(namesIn("hulls_parts").size(), 5u);
  const std::vector<std::string> files =
      attributes(readText(file("hulls.xml")), "file");
  ASSERT_EQ(files.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const std::vector<TriangleMesh> part = readOBJ(file(files[i]));
    ASSERT_EQ(part.size(), 1u);
    EXPECT_EQ(part[0].vertices, hulls[i].vertices);
    EXPECT_EQ(part[0].triangles, hulls[i].triangles);
  }
  EXPECT_EQ(attributes(readText(file("hulls.urdf")), "filename").size(), 10u);
}

TEST_F(SceneOutputs, FindTheirMeshesFromOtherFolders)
{
  fs::create_directories(file("a b/robots"));
  abstract({scan_,
            file("hulls.ply"),
            "--parts",
            "3",
            "--urdf",
            file("a b/robots/scene.urdf"),
            "--mjcf",
            file("a b/inside/scene.xml"),
            "--parts-dir",
            file("a b/inside"),
            "--parts-format",
            "stl",
            "--frame",
            "k\xC3\xBC"
            "che"});
  for (const std::string& mesh :
       attributes(readText(file("a b/robots/scene.urdf")), "filename"))
    EXPECT_FALSE(readSTL(file("a b/robots/" + mesh)).triangles.empty());
  for (const std::string& mesh :
       attributes(readText(file("a b/inside/scene.xml")), "file"))
    EXPECT_FALSE(readSTL(file("a b/inside/" + mesh)).triangles.empty());
  EXPECT_EQ(attributes(readText(file("a b/robots/scene.urdf")), "name")[1],
            "k\xC3\xBC"
            "che");
}

TEST_F(SceneOutputs, NeedNoMeshesForMoveIt)
{
  abstract({scan_, file("a.ply"), "--parts", "3", "--moveit", file("a.scene")});
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"a.ply", "a.scene", "scan.pcd"}));
}

TEST_F(SceneOutputs, LeaveNoPartsOfAnEarlierRun)
{
  const std::vector<std::string> arguments{
      scan_, file("a.ply"), "--parts-dir", file("parts")};
  const auto runWith = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), more.begin(), more.end());
    abstract(all);
  };
  runWith({"--parts", "6"});
  EXPECT_EQ(namesIn("parts").size(), 6u);
  for (const char* const mine : {"part_7.obj", "notes.txt", "part_007.ply"})
    writeText(file("parts/") + mine, "mine");
  runWith({"--parts", "2"});
  EXPECT_EQ(
      namesIn("parts"),
      (std::vector<std::string>{
          "notes.txt", "part_000.obj", "part_001.obj", "part_007.ply", "part_7.obj"}));
  runWith({"--parts", "1", "--parts-format", "stl"});
  EXPECT_EQ(namesIn("parts"),
            (std::vector<std::string>{
                "notes.txt", "part_000.stl", "part_007.ply", "part_7.obj"}));
}

TEST_F(SceneOutputs, TakeHugeCoordinatesOutOfTheMeshes)
{
  const Eigen::Vector3d utm(524288.0, 4194304.0, 100.0);
  const CloudPoints points = pointsOf(deskScan());
  LabelledCloud scan;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> coordinates;
    for (const pcl::PointXYZ& point : *points.points)
      coordinates.push_back(static_cast<double>(point.getVector3fMap()[axis]) +
                            utm[axis]);
    appendField(std::string(1, "xyz"[axis]), coordinates, scan.fields);
  }
  saveCloud(file("scan.pcd"), scan, pcd_binary);
  std::vector<std::string> arguments = allOutputs("5");
  arguments.insert(arguments.end(), {"--parts-format", "stl"});
  const ToolRun done = run("pcl_cid_abstract", arguments);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const std::string text = attributes(readText(file("hulls.urdf")), "xyz").at(0);
  Eigen::Vector3d origin;
  std::istringstream(text) >> origin.x() >> origin.y() >> origin.z();
  EXPECT_LT((origin - utm).norm(), 5.0);
  EXPECT_NE(done.out.find(text + " metres"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(
                readText(file("report.json")))["parameters"]["meshes_origin"],
            text);
  const std::vector<TriangleMesh> hulls = readOBJ(file("hulls.obj"));
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    const TriangleMesh part = readSTL(file("hulls_parts/scan_" + partName(i) + ".stl"));
    ASSERT_EQ(part.triangles.size(), hulls[i].triangles.size());
    for (std::size_t t = 0; t < part.triangles.size(); ++t)
      EXPECT_LT((part.vertices[part.triangles[t][0]] + origin -
                 hulls[i].vertices[hulls[i].triangles[t][0]])
                    .norm(),
                1e-6);
  }
}

TEST_F(SceneOutputs, RefuseAWrongCommandLine)
{
  const auto before = everything();
  using Words = std::vector<std::string>;
  for (const Words& words :
       {Words{"--urdf", file("a.xml")},
        Words{"--sdf", file("a.urdf")},
        Words{"--mjcf", file("a.urdf")},
        Words{"--moveit", file("a")},
        Words{"--parts-dir", ""},
        Words{"--parts-format", "ply"},
        Words{"--frame", ""},
        Words{"--frame", "world", "--sdf", file("a.sdf")},
        Words{"--name", "my room"},
        Words{"--name", ""},
        Words{"--urdf", file("a.urdf"), "--mesh-prefix", ""},
        Words{"--mesh-prefix", "package://robot", "--mjcf", file("a.xml")},
        Words{"--mesh-prefix", "ftp://a", "--sdf", file("a.sdf")}}) {
    Words arguments{scan_, file("a.obj")};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const ToolRun done = run("pcl_cid_abstract", arguments);
    EXPECT_EQ(done.exit_code, 2) << words[0];
    EXPECT_NE(done.err.find(words[words.size() - 2]), std::string::npos) << done.err;
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
  }
  EXPECT_EQ(everything(), before);
}

TEST_F(SceneOutputs, RefuseOptionsThatHaveNoEffect)
{
  const auto before = everything();
  using Words = std::vector<std::string>;
  for (const auto& [words, missing] :
       {std::pair(Words{"--frame", "map"}, "--urdf or --sdf"),
        std::pair(Words{"--frame", "map", "--mjcf", file("a.xml")}, "--urdf or --sdf"),
        std::pair(Words{"--frame", "map", "--moveit", file("a.scene")},
                  "--urdf or --sdf"),
        std::pair(Words{"--mesh-prefix", "a"}, "--urdf, --sdf or --mjcf"),
        std::pair(Words{"--mesh-prefix", "a", "--parts-dir", file("parts")},
                  "--urdf, --sdf or --mjcf"),
        std::pair(Words{"--parts-format", "obj"}, "--mjcf"),
        std::pair(Words{"--primitives", "--gltf", file("a.glb")},
                  "--urdf, --sdf, --mjcf or --moveit"),
        std::pair(Words{"--parts-format", "stl", "--moveit", file("a.scene")},
                  "--parts-dir")}) {
    Words arguments{scan_, file("a.obj")};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const ToolRun done = run("pcl_cid_abstract", arguments);
    EXPECT_EQ(done.exit_code, 2) << done.out << done.err;
    EXPECT_NE(done.err.find(words[0] + " has no effect without"), std::string::npos)
        << done.err;
    EXPECT_NE(done.err.find(missing), std::string::npos) << done.err;
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
  }
  EXPECT_EQ(everything(), before);
}

TEST_F(SceneOutputs, LeaveNothingWhenOneCannotBeWritten)
{
  fs::create_symlink("/dev/full", file("full.scene"));
  writeText(file("file"), "mine");
  const auto before = everything();
  using Words = std::vector<std::string>;
  for (const Words& words : {Words{"--moveit", file("full.scene")},
                             Words{"--moveit", "/proc/read_only.scene"},
                             Words{"--moveit", file("nowhere/a.scene")},
                             Words{"--parts-dir", file("file")},
                             Words{"--parts-dir", "/proc/read_only"},
                             Words{"--parts-dir", file("nowhere/parts")}}) {
    Words arguments{scan_, file("a.obj"), "--urdf", file("a.urdf"), "--seeds", "12"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const ToolRun done = run("pcl_cid_abstract", arguments);
    EXPECT_EQ(done.exit_code, 1) << words[1];
    EXPECT_NE(done.err.find(words[1]), std::string::npos) << done.err;
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
    EXPECT_EQ(everything(), before) << words[1];
  }
}

TEST_F(SceneOutputs, LeaveNothingOnAFullDisk)
{
  ASSERT_EQ(run("pcl_cid_abstract", allOutputs("5")).exit_code, 0);
  std::uintmax_t largest = 0;
  for (const auto& entry : fs::recursive_directory_iterator(file("")))
    if (entry.is_regular_file() && entry.path() != scan_)
      largest = std::max(largest, entry.file_size());
  const auto earlier = everything();
  // Whatever file it is that does not fit, an earlier run stays as it is: more parts
  // here, so that files of the same names would differ.
  std::size_t failures = 0;
  for (std::uintmax_t limit = largest; limit > 500; limit /= 4) {
    const FileSizeLimit full_disk(limit - 1);
    const ToolRun done = run("pcl_cid_abstract", allOutputs("6"));
    if (done.exit_code == 0)
      break; // six small parts can take less than five large ones
    ++failures;
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_NE(done.err.find("could not be written in full"), std::string::npos);
    EXPECT_EQ(everything(), earlier) << limit;
  }
  EXPECT_GT(failures, 0u);
  for (const auto& [name, content] : earlier)
    if (name != "scan.pcd")
      fs::remove_all(file(name));
  const auto before = everything();
  for (std::uintmax_t limit = largest / 2; limit > 500; limit /= 4) {
    const FileSizeLimit full_disk(limit);
    EXPECT_EQ(run("pcl_cid_abstract", allOutputs("5")).exit_code, 1);
    EXPECT_EQ(everything(), before) << limit;
  }
}

} // namespace
} // namespace pcl_cid::test
