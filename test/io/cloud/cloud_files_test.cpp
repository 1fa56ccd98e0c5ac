/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds through files and back, to the last bit; PCL's own readers agree.
 */

#include "cloud_files.h"

#include <limits>

#include <gtest/gtest.h>

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

namespace pcl_cid::test {
namespace {

struct NamedLayout {
  const char* file;
  CloudLayout layout;
};

const NamedLayout all_layouts[] = {{"ascii.pcd", pcd_ascii},
                                   {"binary.pcd", pcd_binary},
                                   {"compressed.pcd", pcd_compressed},
                                   {"ascii.ply", ply_ascii},
                                   {"binary.ply", ply_binary}};

/** Extremes of every type that all formats have. */
LabelledCloud
extremes()
{
  using Float = std::numeric_limits<float>;
  using Double = std::numeric_limits<double>;
  LabelledCloud cloud;
  appendField<float>(
      "x", {0.1f, Float::max(), Float::denorm_min(), Float::quiet_NaN()}, cloud.fields);
  appendField<float>(
      "y", {-0.0f, Float::lowest(), -Float::infinity(), 1.0f / 3.0f}, cloud.fields);
  appendField<double>(
      "z", {0.1, Double::max(), Double::denorm_min(), -1e-300}, cloud.fields);
  appendField<std::int8_t>("i1", {-128, 127, 0, -1}, cloud.fields);
  appendField<std::uint8_t>("u1", {255, 0, 10, 32}, cloud.fields);
  appendField<std::int16_t>("i2", {-32768, 32767, 0, -1}, cloud.fields);
  appendField<std::uint16_t>("u2", {65535, 0, 10, 256}, cloud.fields);
  appendField<std::int32_t>("i4", {INT32_MIN, INT32_MAX, 0, -1}, cloud.fields);
  appendField<std::uint32_t>("u4", {UINT32_MAX, 0, 10, 16777217}, cloud.fields);
  appendField<float>("normal_x", {0.6f, 0.8f, 0.0f, 1.0f}, cloud.fields);
  appendField<std::uint32_t>(
      "rgba", {0xFF010203u, 0x00FFFFFFu, 0u, 0x80FE00A0u}, cloud.fields);
  return cloud;
}

void
expectSameFields(const pcl::PCLPointCloud2& actual, const pcl::PCLPointCloud2& expected)
{
  EXPECT_EQ(actual.width, expected.width);
  EXPECT_EQ(actual.height, expected.height);
  ASSERT_EQ(actual.fields.size(), expected.fields.size());
  for (std::size_t i = 0; i < actual.fields.size(); ++i) {
    const std::string& name = expected.fields[i].name;
    EXPECT_EQ(actual.fields[i].name, name);
    EXPECT_EQ(actual.fields[i].datatype, expected.fields[i].datatype) << name;
    EXPECT_EQ(actual.fields[i].count, expected.fields[i].count) << name;
    EXPECT_EQ(bytesOf(actual, name), bytesOf(expected, name)) << name;
  }
}

class EveryLayout : public testing::TestWithParam<NamedLayout> {
protected:
  std::string
  save(const LabelledCloud& cloud) const
  {
    const std::string path = folder_.file(GetParam().file);
    saveCloud(path, cloud, GetParam().layout);
    return path;
  }

  bool
  isPLY() const
  {
    return GetParam().layout.format == "PLY";
  }

  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Formats,
                         EveryLayout,
                         testing::ValuesIn(all_layouts),
                         [](const auto& info) {
                           std::string name = info.param.file;
                           name[name.find('.')] = '_';
                           return name;
                         });

TEST_P(EveryLayout, KeepsEveryBitOfEveryType)
{
  const LabelledCloud read = readCloud(save(extremes()));
  EXPECT_EQ(read.layout, GetParam().layout);
  expectSameFields(read.fields, extremes().fields);
}

TEST_P(EveryLayout, KeepsShapeAndPose)
{
  const LabelledCloud scan = deskScan();
  const LabelledCloud read = readCloud(save(scan));
  EXPECT_EQ(read.fields.width, 40u);
  EXPECT_EQ(read.fields.height, 30u);
  EXPECT_EQ(read.sensor_origin, scan.sensor_origin);
  EXPECT_NEAR(
      read.sensor_orientation.angularDistance(scan.sensor_orientation), 0, 1e-6);
  if (!isPLY()) {
    EXPECT_EQ(read.sensor_orientation.coeffs(), scan.sensor_orientation.coeffs());
  }
}

TEST_P(EveryLayout, IsReadByPCLWithTheSameBits)
{
  const LabelledCloud scan = deskScan();
  const LoadedByPCL loaded = loadWithPCL(save(scan));
  EXPECT_EQ(loaded.cloud.width, 40u);
  EXPECT_EQ(loaded.cloud.height, 30u);
  ASSERT_EQ(loaded.cloud.fields.size(), 4u);
  // NaN may come back with another sign, so coordinates are compared as numbers.
  for (const char* const name : {"x", "y", "z"}) {
    const auto actual = valuesOf<float>(loaded.cloud, name);
    const auto expected = valuesOf<float>(scan.fields, name);
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i)
      EXPECT_TRUE(actual[i] == expected[i] ||
                  (std::isnan(actual[i]) && std::isnan(expected[i])));
  }
  EXPECT_EQ(bytesOf(loaded.cloud, "rgb"), bytesOf(scan.fields, "rgb"));
  if (isPLY())
    return; // pcl::PLYReader passes over the pose
  EXPECT_EQ(loaded.origin, scan.sensor_origin);
  EXPECT_EQ(loaded.orientation.coeffs(), scan.sensor_orientation.coeffs());
}

TEST_P(EveryLayout, ReadsWhatPCLWrites)
{
  const LabelledCloud scan = deskScan();
  const std::string path = folder_.file(GetParam().file);
  pcl::PCDWriter pcd;
  pcl::PLYWriter ply;
  const auto& origin = scan.sensor_origin;
  const auto& turn = scan.sensor_orientation;
  const CloudLayout& layout = GetParam().layout;
  if (layout == pcd_ascii)
    pcd.writeASCII(path, scan.fields, origin, turn, 9);
  else if (layout == pcd_binary)
    pcd.writeBinary(path, scan.fields, origin, turn);
  else if (layout == pcd_compressed)
    pcd.writeBinaryCompressed(path, scan.fields, origin, turn);
  else if (layout == ply_ascii)
    ply.writeASCII(path, scan.fields, origin, turn, 9);
  else
    ply.writeBinary(path, scan.fields, origin, turn);
  const LabelledCloud read = readCloud(path);
  EXPECT_EQ(read.fields.width, 40u);
  EXPECT_EQ(read.fields.height, 30u);
  EXPECT_NEAR(read.sensor_orientation.angularDistance(turn), 0.0f, 1e-6f);
  EXPECT_FLOAT_EQ(read.sensor_origin.x(), origin.x());
  const CloudPoints actual = pointsOf(read);
  const CloudPoints expected = pointsOf(scan);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector3f p = (*expected.points)[i].getVector3fMap();
    if (p.allFinite()) {
      EXPECT_EQ((*actual.points)[i].getVector3fMap(), p);
    }
  }
  EXPECT_EQ(actual.finite, expected.finite);
  EXPECT_EQ(bytesOf(read.fields, "rgb"), bytesOf(scan.fields, "rgb"));
}

TEST(PCDFile, KeepsWideIntegersAndFieldsWithSeveralValues)
{
  LabelledCloud cloud = extremes();
  appendField<std::int64_t>("i8", {INT64_MIN, INT64_MAX, 0, -1}, cloud.fields);
  appendField<std::uint64_t>("u8", {UINT64_MAX, 0, 1, 2}, cloud.fields);
  appendField<float>("h", {1, 2, 3, 4}, cloud.fields);
  appendField<float>("h2", {5, 6, 7, 8}, cloud.fields);
  cloud.fields.fields.pop_back(); // the two in one field
  cloud.fields.fields.back().count = 2;
  const TemporaryFolder folder;
  for (const CloudLayout& layout : {pcd_ascii, pcd_binary, pcd_compressed}) {
    saveCloud(folder.file("wide.pcd"), cloud, layout);
    expectSameFields(readCloud(folder.file("wide.pcd")).fields, cloud.fields);
  }
}

TEST(PCDFile, DropsPaddingOnly)
{
  pcl::PointCloud<pcl::PointNormal> padded(3, 1);
  for (std::size_t i = 0; i < padded.size(); ++i) {
    padded[i].getVector3fMap() << static_cast<float>(i), 2.0f, 3.0f;
    padded[i].getNormalVector3fMap() << 0.0f, 0.6f, 0.8f;
    padded[i].curvature = 0.25f * static_cast<float>(i);
  }
  const TemporaryFolder folder;
  const std::string path = folder.file("padded.pcd");
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2(padded, blob);
  pcl::PCDWriter().writeBinary(path, blob);
  ASSERT_NE(readText(path).find(" _ "), std::string::npos);
  const LabelledCloud read = readCloud(path);
  ASSERT_EQ(read.fields.fields.size(), 7u);
  for (const pcl::PCLPointField& field : read.fields.fields)
    EXPECT_EQ(bytesOf(read.fields, field.name), bytesOf(blob, field.name))
        << field.name;
}

TEST(PCDFile, ReadsOldHeaders)
{
  const TemporaryFolder folder;
  writeText(folder.file("old.pcd"),
            "# .PCD v.5\nVERSION .5\nCOLUMNS x y z\nPOINTS 2\nDATA ascii\n"
            "1 2 3\r\n\n  +4\t5 nan\n");
  const LabelledCloud read = readCloud(folder.file("old.pcd"));
  EXPECT_EQ(read.fields.width, 2u);
  EXPECT_EQ(read.fields.height, 1u);
  EXPECT_EQ(valuesOf<float>(read.fields, "x"), (std::vector<float>{1, 4}));
  EXPECT_EQ(pointsOf(read).finite, 1u);
}

TEST(PLYFile, ReadsMeshesOfAllEncodings)
{
  const TemporaryFolder folder;
  const std::string header =
      "element face 1\nproperty list uchar int vertex_indices\n"
      "element vertex 2\nproperty double x\nproperty double y\nproperty double z\n"
      "property uint8 blue\nproperty uint8 green\nproperty uint8 red\n"
      "property ushort quality\nend_header\n";
  writeText(folder.file("a.ply"),
            "ply\nformat ascii 1.0\ncomment by hand\n" + header +
                "3 0 1 0\n0.5 1 2 30 20 10 7\n\n-0.5 1 2 33 22 11 65535\n");
  std::string body("\3\0\0\0\0\0\0\0\1\0\0\0\0", 13);
  for (const char* const half : {"\x3F\xE0", "\xBF\xE0"}) { // 0.5 and -0.5, 1, 2
    body += std::string(half, 2) + std::string(6, '\0');
    body += std::string("\x3F\xF0\0\0\0\0\0\0\x40\0\0\0\0\0\0\0", 16);
    body += half[0] == '\x3F' ? std::string("\x1E\x14\x0A\x00\x07", 5)
                              : std::string("\x21\x16\x0B\xFF\xFF", 5);
  }
  writeText(folder.file("b.ply"),
            "ply\nformat binary_big_endian 1.0\n" + header + body);
  for (const char* const name : {"a.ply", "b.ply"}) {
    const LabelledCloud read = readCloud(folder.file(name));
    EXPECT_EQ(valuesOf<double>(read.fields, "x"), (std::vector<double>{0.5, -0.5}));
    EXPECT_EQ(valuesOf<double>(read.fields, "z"), (std::vector<double>{2, 2}));
    EXPECT_EQ(valuesOf<std::uint32_t>(read.fields, "rgb"),
              (std::vector<std::uint32_t>{0x0A141E, 0x0B1621}));
    EXPECT_EQ(valuesOf<std::uint16_t>(read.fields, "quality"),
              (std::vector<std::uint16_t>{7, 65535}));
  }
}

} // namespace
} // namespace pcl_cid::test
