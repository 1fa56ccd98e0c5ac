/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files and both kinds of folders through one door.
 */

#include "cloud_files.h"
#include "dataset_folders.h"

#include <pcl_cid/io/s3dis.h>
#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/scannet.h>

#include <filesystem>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

class ScanSource : public testing::Test {
protected:
  std::string
  complaint(const std::string& path, const ScanOptions& options = {})
  {
    try {
      readScan(path, options);
    }
    catch (const CIDException& error) {
      return error.what();
    }
    return "none";
  }

  TemporaryFolder folder_;
  LabelledScan scan_ = smallRoomScan(300);
};

void
expectSame(const LabelledCloud& read, const LabelledCloud& expected)
{
  EXPECT_EQ(read.name, expected.name);
  EXPECT_EQ(read.layout, expected.layout);
  EXPECT_EQ(read.fields.data, expected.fields.data);
  EXPECT_EQ(read.fields.fields.size(), expected.fields.fields.size());
}

TEST_F(ScanSource, MayBeAFile)
{
  const std::string path = folder_.file("desk.of mine.pcd");
  saveCloud(path, deskScan(), pcd_binary);
  expectSame(readScan(path), readCloud(path));
  EXPECT_FALSE(isScanFolder(path));
  EXPECT_EQ(scanFiles(path), Strings{path});
  EXPECT_EQ(scanName(path), "desk.of mine");
}

TEST_F(ScanSource, MayBeARoomOfS3DIS)
{
  const std::string room = writeS3DISRoom(folder_.file("."), scan_);
  Strings remarks;
  writeText(room + "/Annotations/stairs_1.txt", "1 1 1 1 1 1\n");
  ScanOptions options;
  options.remark = [&](const std::string& remark) { remarks.push_back(remark); };
  expectSame(readScan(room, options), readS3DISRoom(room, {}));
  EXPECT_EQ(remarks.size(), 2u); // the class, and the point that the room has not
  EXPECT_TRUE(isScanFolder(room));
  EXPECT_EQ(scanFiles(room), s3disRoomFiles(room));
  for (const char* const end : {"", "/", "/."})
    EXPECT_EQ(scanName(room + end), "office_1");
}

TEST_F(ScanSource, MayBeAScanOfScanNet)
{
  const std::string scan = writeScannetScan(folder_.file("."), scan_, 0);
  expectSame(readScan(scan), readScannetScan(scan, "", {}));
  EXPECT_TRUE(isScanFolder(scan));
  EXPECT_EQ(scanFiles(scan).size(), 4u);
  EXPECT_EQ(scanName(scan + "/"), "scene0000_00");
  const std::string moved = folder_.file("mine");
  fs::rename(scan, moved);
  EXPECT_EQ(scanName(moved), "scene0000_00");

  ScanOptions options;
  options.class_table = folder_.file("table.tsv");
  fs::rename(folder_.file("scannetv2-labels.combined.tsv"), options.class_table);
  expectSame(readScan(moved, options), readScannetScan(moved, options.class_table, {}));
  EXPECT_EQ(scanFiles(moved, options.class_table).back(), options.class_table);
}

TEST_F(ScanSource, IsNoOtherFolder)
{
  const std::string area = folder_.file("Area_1");
  fs::create_directory(area);
  EXPECT_FALSE(isScanFolder(area));
  EXPECT_EQ(complaint(area),
            area + ": is a folder, but neither a room of S3DIS (with a folder "
                   "Annotations) nor a scan of ScanNet (with a file "
                   "<id>_vh_clean_2.ply)");
  EXPECT_EQ(complaint(folder_.file("nowhere")),
            folder_.file("nowhere") + ": there is no such file");
}

TEST_F(ScanSource, TakesAClassTableForScanNetOnly)
{
  ScanOptions options;
  options.class_table = "table.tsv";
  const std::string room = writeS3DISRoom(folder_.file("."), scan_);
  EXPECT_EQ(complaint(room, options),
            room + ": is no scan of ScanNet; only that has a use for the class table "
                   "table.tsv");
}

} // namespace
} // namespace pcl_cid::test
