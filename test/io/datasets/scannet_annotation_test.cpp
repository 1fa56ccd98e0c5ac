/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labelled scans written as annotations and predictions of ScanNet, and read again.
 */

#include "cloud_files.h"
#include "dataset_folders.h"
#include "python_reader.h"

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/scannet.h>
#include <pcl_cid/io/scannet_annotation.h>

#include <filesystem>
#include <map>
#include <random>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;
using Labels = std::vector<std::uint32_t>;
using Json = nlohmann::json;

constexpr const char* scan_id = "scene0042_01";

class ScannetAnnotation : public testing::Test {
protected:
  ScannetAnnotation()
  {
    writeText(
        table_,
        "id\traw_category\tnyu40id\n1\toffice chair\t5\n2\twall\t1\n3\tsofa\t6\n");
  }

  void
  write(const LabelledInstances& scan,
        const pcl::Indices& group = {},
        const std::string& table = "")
  {
    OutputFiles outputs({});
    writeScannetAnnotation(scan, group, {folder_.file("."), scan_id, table}, outputs);
    outputs.commit();
  }

  Json
  writeAndRead(const LabelledInstances& scan, const pcl::Indices& group = {})
  {
    write(scan, group);
    return readByPython({"scannet", folder_.file("."), scan_id});
  }

  std::string
  complaint(const LabelledInstances& scan, const std::string& table = "")
  {
    return complaintAbout("", [&] { write(scan, {}, table); });
  }

  TemporaryFolder folder_;
  std::string table_ = folder_.file("scannetv2-labels.combined.tsv");
};

TEST(SegmentsOfLabels, AreGroupsCutWhereLabelsPart)
{
  EXPECT_EQ(segmentsOfLabels({4, 4, 1, -1, 4, -1}, {7, 0, 7, 0, 7, 7}),
            (Labels{0, 1, 2, 3, 0, 4}));
  EXPECT_EQ(segmentsOfLabels({}, {5, 0, 5}), (Labels{0, 1, 0}));
  EXPECT_EQ(segmentsOfLabels({}, {}), Labels{});
  EXPECT_THROW(segmentsOfLabels({1}, {1, 2}), CIDException);
}

TEST_F(ScannetAnnotation, HasTheSegmentsAndTheClassOfEachInstance)
{
  const Json read = writeAndRead(
      {{9, 9, 0, 3, 9}, {{9, "chair", ""}, {5, "bed", ""}, {3, "floor mat", ""}}},
      {1, 0, 0, 0, 1});
  EXPECT_EQ(read["segment"], (Labels{0, 1, 2, 3, 0}));
  EXPECT_EQ(read["instance"], (Labels{2, 2, 0, 1, 2}));
  EXPECT_EQ(read["classes"], (Strings{"floor mat", "chair"}));
}

TEST_F(ScannetAnnotation, IsReadBackPointByPoint)
{
  std::mt19937 random(3);
  LabelledInstances scan;
  const Strings classes = {"office chair", "wall", "sofa"};
  for (std::uint32_t i = 0; i < 20; ++i)
    scan.instances.push_back({3 * i + 2, classes[random() % 3], ""});
  pcl::Indices group;
  std::vector<float> coordinates;
  for (std::size_t i = 0; i < 500; ++i) {
    const std::size_t instance = random() % 21;
    scan.label.push_back(instance == 20 ? 0 : scan.instances[instance].label);
    group.push_back(static_cast<pcl::index_t>(random() % 8) - 1);
    coordinates.push_back(static_cast<float>(i));
  }
  write(scan, group, table_);
  LabelledCloud mesh;
  for (const char* const axis : {"x", "y", "z"})
    appendField(axis, coordinates, mesh.fields);
  saveCloud(folder_.file(scan_id + std::string("_vh_clean_2.ply")), mesh, ply_binary);

  Strings remarks;
  const LabelledCloud back =
      readScannetScan(folder_.file("."), table_, [&](const std::string& remark) {
        remarks.push_back(remark);
      });
  EXPECT_EQ(remarks, Strings{});
  const Labels label = valuesOf<std::uint32_t>(back.fields, "label");
  const Labels semantic = valuesOf<std::uint32_t>(back.fields, "semantic");
  const std::map<std::string, std::uint32_t> number = {
      {"office chair", 5}, {"wall", 1}, {"sofa", 6}};
  ASSERT_EQ(label.size(), scan.label.size());
  for (std::size_t i = 0; i < label.size(); ++i) {
    const std::uint32_t place = scan.label[i] == 0 ? 0 : scan.label[i] / 3 + 1;
    EXPECT_EQ(label[i], place);
    EXPECT_EQ(semantic[i],
              place == 0 ? 0 : number.at(scan.instances[place - 1].class_name));
  }
  EXPECT_EQ(readByPython({"scannet", folder_.file("."), scan_id})["instance"], label);
}

TEST_F(ScannetAnnotation, MayHaveNoPointAndNoInstance)
{
  EXPECT_EQ(writeAndRead({})["segment"], Json::array());
  const Json read = writeAndRead({{0, 0}, {}}, {1, -1});
  EXPECT_EQ(read["segment"], (Labels{0, 1}));
  EXPECT_EQ(read["instance"], (Labels{0, 0}));
  EXPECT_EQ(read["classes"], Json::array());
}

TEST_F(ScannetAnnotation, RefusesClassesThatScannetDoesNotHave)
{
  const LabelledInstances scan = {{1, 2, 3, 4, 5},
                                  {{1, "Sofa", ""},
                                   {2, "chair", ""},
                                   {3, "zebra", ""},
                                   {4, "", ""},
                                   {5, "wall", ""}}};
  EXPECT_EQ(
      complaint(scan),
      "ScanNet has no class '', 'Sofa' (near it: 'sofa') or 'zebra'; the class of "
      "every instance must be one of the 40 of NYUv2, such as 'wall'");
  EXPECT_EQ(complaint(scan, table_),
            table_ +
                ": has no class '', 'Sofa' (near it: 'sofa'), 'chair' (near it: "
                "'office chair') or 'zebra'; the class of every instance must be a "
                "raw_category");
  // Nobody waits for a class of which there is no point.
  EXPECT_EQ(complaint({{0}, {{3, "zebra", ""}}}), "none");
}

TEST_F(ScannetAnnotation, IsNotWrittenOverTheScan)
{
  const std::string scan = writeScannetScan(folder_.file("."), smallRoomScan(300), 0);
  OutputFiles outputs(findScannetFiles(scan).all());
  EXPECT_THROW(
      writeScannetAnnotation({{0}, {}}, {}, {scan, "scene0000_00", ""}, outputs),
      CIDException);
  EXPECT_THROW(write({{1}, {{1, "wall", ""}}}, {1, 2}), CIDException);
}

TEST_F(ScannetAnnotation, IsAPredictionToo)
{
  const LabelledInstances scan = {{9, 9, 0, 3, 4},
                                  {{9, "chair", ""}, {3, "wall", ""}, {4, "sofa", ""}}};
  const auto all = scannetInstances(scan);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].semantic, 1u);
  EXPECT_EQ(all[2].points, 2u);
  EXPECT_THROW(scannetInstances(scan, table_), CIDException);

  const std::string results = folder_.file("results");
  OutputFiles outputs({});
  announceScannetSubmission(results, scan_id, outputs);
  writeText(results + "/pred_mask/scene0042_01_007.txt", "of an earlier run");
  writeText(results + "/pred_mask/scene0001_01_007.txt", "of another scan");
  writeScannetSubmission(
      results, scan_id, scan.label, ofBenchmarkClasses(all), outputs);
  outputs.commit();
  EXPECT_EQ(readText(results + "/scene0042_01.txt"),
            "pred_mask/scene0042_01_000.txt 6 1\npred_mask/scene0042_01_001.txt 5 1\n");
  EXPECT_EQ(readText(results + "/pred_mask/scene0042_01_001.txt"), "1\n1\n0\n0\n0\n");
  EXPECT_FALSE(fs::exists(results + "/pred_mask/scene0042_01_007.txt"));
  EXPECT_TRUE(fs::exists(results + "/pred_mask/scene0001_01_007.txt"));
}

} // namespace
} // namespace pcl_cid::test
