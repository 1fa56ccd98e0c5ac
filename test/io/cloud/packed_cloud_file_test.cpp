/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds packed by gzip, and files of points that are not read.
 */

#include "cloud_files.h"

#include <pcl_cid/io/scan_source.h>

#include <gtest/gtest.h>
#include <zlib.h>

namespace pcl_cid::test {
namespace {

void
writePacked(const std::string& path, const std::string& text, const char* mode = "wb")
{
  const gzFile file = gzopen(path.c_str(), mode);
  ASSERT_TRUE(file);
  EXPECT_EQ(gzwrite(file, text.data(), static_cast<unsigned int>(text.size())),
            static_cast<int>(text.size()));
  gzclose(file);
}

TEST(PackedCloudFile, IsReadAsTheFileInIt)
{
  const TemporaryFolder folder;
  for (const CloudLayout& layout :
       {pcd_ascii, pcd_binary, pcd_compressed, ply_ascii, ply_binary}) {
    saveCloud(folder.file("plain"), deskScan(), layout);
    writePacked(folder.file("desk.gz"), readText(folder.file("plain")));
    const LabelledCloud cloud = readCloud(folder.file("desk.gz"));
    EXPECT_EQ(cloud.fields.data, readCloud(folder.file("plain")).fields.data);
    EXPECT_EQ(cloud.layout, layout);
  }
  writePacked(folder.file("a.xyz.GZ"), "1 2 3\n");
  writePacked(folder.file("a.xyz.GZ"), "4 5 6\n", "ab"); // a second part
  EXPECT_EQ(readCloud(folder.file("a.xyz.GZ")).size(), 2u);
  writePacked(folder.file("renamed.xyz"), "1 2 3\n");
  EXPECT_EQ(readCloud(folder.file("renamed.xyz")).size(), 1u);
}

TEST(PackedCloudFile, IsAScanByTheNameInIt)
{
  const TemporaryFolder folder;
  for (const char* const name : {"a.pcd.gz", "a.txt.gz", "a.gz"})
    writePacked(folder.file(name), "1 2 3\n");
  EXPECT_TRUE(isScan(folder.file("a.pcd.gz")));
  EXPECT_FALSE(isScan(folder.file("a.txt.gz")));
  EXPECT_FALSE(isScan(folder.file("a.gz")));
  EXPECT_EQ(scanName(folder.file("a.pcd.gz")), "a");
}

TEST(PackedCloudFile, IsRefusedWhereverItIsCutOrDamaged)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("a.xyz.gz");
  writePacked(path, "1.25 2.5 3.75\n4 5 6\n");
  const std::string whole = readText(path);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    writeText(path, whole.substr(0, size));
    EXPECT_THROW(readCloud(path), CIDException) << size;
  }
  std::string damaged = whole;
  damaged[whole.size() - 6] ^= 1; // of the check sum
  writeText(path, damaged);
  EXPECT_NE(complaintAbout(path, [&] { readCloud(path); }).find("unpacked"),
            std::string::npos);
}

TEST(UnreadCloudFile, IsNamedWithTheCommandThatConvertsIt)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("scan.las");
  for (const auto& [begin, complaint] :
       {std::pair<std::string, std::string>{"LASF\1\4", "LAS or LAZ"},
        {"ASTM-E57\1", "E57"},
        {std::string("PK\3\4\0", 5), "NPZ"}}) {
    writeText(path, begin + std::string(400, '\1'));
    const std::string said = complaintAbout(path, [&] { readCloud(path); });
    EXPECT_NE(said.find(complaint), std::string::npos) << said;
    EXPECT_NE(said.find("convert it first: "), std::string::npos) << said;
    EXPECT_NE(said.find("'" + path + "'"), std::string::npos) << said;
  }
}

} // namespace
} // namespace pcl_cid::test
