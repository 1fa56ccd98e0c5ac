/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files that are empty, truncated, damaged or not clouds at all.
 */

#include "cloud_files.h"

#include "base/random.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

struct BadFile {
  const char* name;
  std::string content;
  const char* complaint; ///< what the message must contain
};

void
PrintTo(const BadFile& bad, std::ostream* stream)
{
  *stream << bad.name;
}

/** A PCD of one point with some lines of the header replaced. */
std::string
pcd(const std::string& fields,
    const std::string& sizes,
    const std::string& types,
    const std::string& counts,
    const std::string& shape,
    const std::string& data)
{
  return "VERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types +
         "\nCOUNT " + counts + "\n" + shape + "\nDATA " + data;
}

const std::string one = "WIDTH 1\nHEIGHT 1\nPOINTS 1";

std::string
xyz(const std::string& shape, const std::string& data)
{
  return pcd("x y z", "4 4 4", "F F F", "1 1 1", shape, data);
}

std::string
ply(const std::string& lines, const std::string& body)
{
  return "ply\nformat ascii 1.0\n" + lines + "end_header\n" + body;
}

const std::string ply_xyz = "property float x\nproperty float y\nproperty float z\n";

std::vector<BadFile>
badFiles()
{
  return {
      {"Empty", "", "is empty"},
      {"Text", "1 2 3\n4 5 6\n", "is neither a PCD"},
      {"Zeros", std::string(4096, '\0'), "is neither a PCD"},
      {"Comment", "#include <cstdio>\nint main() {}\n", "is neither a PCD"},
      {"HeaderOnly", "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n", "truncated"},
      {"NoPoints", xyz("WIDTH 0\nHEIGHT 1\nPOINTS 0", "ascii\n"), "no points"},
      {"ShapeAndPoints",
       xyz("WIDTH 2\nHEIGHT 1\nPOINTS 1", "ascii\n1 2 3\n"),
       "WIDTH 2"},
      {"WidthNegative", xyz("WIDTH -1\nHEIGHT 1\nPOINTS 1", "ascii\n1 2 3\n"), "WIDTH"},
      {"PointsNoNumber", xyz("POINTS many", "ascii\n1 2 3\n"), "many"},
      {"HugeAscii",
       xyz("WIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000", "ascii\n1 2 3\n"),
       "truncated"},
      {"HugeBinary",
       xyz("WIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000", "binary\n0123"),
       "truncated"},
      {"HugeCompressed",
       xyz("WIDTH 300000000\nHEIGHT 1\nPOINTS 300000000",
           "binary_compressed\n" + std::string("\4\0\0\0\0\xA4\x93\xD6"
                                               "abcd",
                                               12)),
       "damaged"},
      {"HugeShape",
       xyz("WIDTH 2000000000\nHEIGHT 2000000000\nPOINTS 1", "ascii\n1 2 3\n"),
       "is not POINTS 1"},
      {"HugeCount",
       pcd("x y z", "4 4 4", "F F F", "1 1 2000000000", one, "ascii\n1 2 3\n"),
       "bytes"},
      {"CountZero",
       pcd("x y z", "4 4 4", "F F F", "1 1 0", one, "ascii\n1 2\n"),
       "no field 'z'"},
      {"SizeOdd",
       pcd("x y z", "4 4 3", "F F F", "1 1 1", one, "ascii\n1 2 3\n"),
       "'z'"},
      {"TypeOdd", pcd("x y z", "4 4 4", "F F Q", "1 1 1", one, "ascii\n1 2 3\n"), "Q"},
      {"SizesMissing",
       pcd("x y z", "4 4", "F F F", "1 1 1", one, "ascii\n1 2 3\n"),
       "SIZE"},
      {"NoZ", pcd("x y", "4 4", "F F", "1 1", one, "ascii\n1 2\n"), "no field 'z'"},
      {"BytesLeft",
       xyz(one, "binary\n" + std::string(12, 'a') + "b"),
       "has 1 byte after its last point"},
      {"HalfAsLabel",
       pcd("x y z l", "4 4 4 4", "F F F I", "1 1 1 1", one, "ascii\n1 2 3 0.5\n"),
       "'0.5' is no value for field 'l'"},
      {"TooLargeForFloat", xyz(one, "ascii\n1 2 1e39\n"), "'1e39'"},
      {"ZTwice",
       pcd("x y z z", "4 4 4 4", "F F F F", "1 1 1 1", one, "ascii\n1 2 3 4\n"),
       "two fields"},
      {"XWithTwoValues",
       pcd("x y z", "4 4 4", "F F F", "2 1 1", one, "ascii\n1 1 2 3\n"),
       "2 values"},
      {"DataUnknown", xyz(one, "octal\n1 2 3\n"), "octal"},
      {"EntryUnknown", xyz("POINTS 1\nSHADE red", "ascii\n1 2 3\n"), "SHADE"},
      {"PoseShort", xyz(one + "\nVIEWPOINT 0 0 0 1", "ascii\n1 2 3\n"), "VIEWPOINT"},
      {"WordForNumber", xyz(one, "ascii\n1 two 3\n"), "two"},
      {"NumberWithTail", xyz(one, "ascii\n1 2.5x 3\n"), "2.5x"},
      {"ValueMissing", xyz(one, "ascii\n1.00 2.00\n"), "fewer values"},
      {"ValueTooMany", xyz(one, "ascii\n1 2 3 4\n"), "more values"},
      {"PointTooMany", xyz(one, "ascii\n1 2 3\n1 2 3\n"), "more points"},
      {"LabelOverflow",
       pcd("x y z label", "4 4 4 1", "F F F U", "1 1 1 1", one, "ascii\n1 2 3 256\n"),
       "256"},
      {"CompressedSizeWrong",
       xyz(one,
           "binary_compressed\n" + std::string("\4\0\0\0\x0D\0\0\0"
                                               "abcd",
                                               12)),
       "damaged"},
      {"CompressedGarbage",
       xyz(one,
           "binary_compressed\n" + std::string("\4\0\0\0\x0C\0\0\0"
                                               "\xFF\xFF\xFF\xFF",
                                               12)),
       "damaged"},
      {"PLYNoEnd", "ply\nformat ascii 1.0\nelement vertex 1\n", "truncated"},
      {"PLYNoFormat",
       "ply\nelement vertex 1\n" + ply_xyz + "end_header\n1 2 3\n",
       "format"},
      {"PLYNoVertices", ply("element face 0\n", ""), "no points"},
      {"PLYZeroVertices", ply("element vertex 0\n" + ply_xyz, ""), "no points"},
      {"PLYHuge", ply("element vertex 2000000000\n" + ply_xyz, "1 2 3\n"), "truncated"},
      {"PLYHugest",
       ply("element vertex 18446744073709551615\n" + ply_xyz, "1 2 3\n"),
       "at most"},
      {"PLYTypeUnknown", ply("element vertex 1\nproperty quad x\n", "1\n"), "quad"},
      {"PLYLineUnknown", ply("vertices 1\n" + ply_xyz, "1 2 3\n"), "vertices 1"},
      {"PLYExtraColumns",
       ply("element vertex 2\n" + ply_xyz, "1 2 3 4 5\n1 2 3 4 5\n"),
       "line 8: row 1 of element 'vertex' has 5 values; the header says 3"},
      {"PLYMissingValue",
       ply("element vertex 3\n" + ply_xyz, "1 2 3\n1.5 2\n1 2 3.5\n"),
       "line 9: row 2 of element 'vertex' has 2 values; the header says 3"},
      {"PLYMissingValueBeforeFaces",
       ply("element vertex 1\n" + ply_xyz +
               "element face 1\nproperty list uchar int vertex_indices\n",
           "1 2\n3 0 0 0\n"),
       "row 1 of element 'vertex' has 2 values; the header says 3"},
      {"PLYFaceTooLong",
       ply("element vertex 1\n" + ply_xyz +
               "element face 1\nproperty list uchar int vertex_indices\n",
           "1 2 3\n3 0 0 0 0\n"),
       "row 1 of element 'face' has 5 values; the header says 4"},
      {"PLYCountTooSmall",
       ply("element vertex 1\n" + ply_xyz, "1 2 3\n4 5 6\n"),
       "line 9: '4' is left after the last of the 1 row of element 'vertex'"},
      {"PLYBytesLeft",
       "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + ply_xyz +
           "end_header\n" + std::string(13, '\0'),
       "1 byte left after the last"},
      {"PLYWord", ply("element vertex 1\n" + ply_xyz, "1 zz 3\n"), "zz"},
      {"PLYNoX", ply("element vertex 1\nproperty float y\n", "12\n"), "no field 'x'"},
      {"PLYListNegative",
       ply("element vertex 1\n" + ply_xyz +
               "element face 1\nproperty list char int vertex_indices\n",
           "1 2 3\n-1\n"),
       "list"}};
}

class BadCloudFile : public testing::TestWithParam<BadFile> {};

INSTANTIATE_TEST_SUITE_P(Files,
                         BadCloudFile,
                         testing::ValuesIn(badFiles()),
                         [](const auto& info) { return info.param.name; });

TEST_P(BadCloudFile, IsRefusedWithFileAndReason)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("bad");
  writeText(path, GetParam().content);
  try {
    readCloud(path);
    FAIL() << "was read";
  }
  catch (const CIDException& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(path, 0), 0u) << message;
    EXPECT_NE(message.find(GetParam().complaint), std::string::npos) << message;
  }
}

TEST(BadCloudFile, MissingFileAndFolderAreRefused)
{
  const TemporaryFolder folder;
  EXPECT_THROW(readCloud(folder.file("nothing.pcd")), CIDException);
  EXPECT_THROW(readCloud(folder.file("")), CIDException);
}

/** A few points with all that a file can hold. */
LabelledCloud
smallCloud()
{
  LabelledCloud cloud;
  appendField<float>("x", {0.125f, 1.5f, 2.25f}, cloud.fields);
  appendField<float>("y", {0, 0, 0}, cloud.fields);
  appendField<double>("z", {1, 1, 1}, cloud.fields);
  appendField<std::uint32_t>("rgba", {1, 2, 3}, cloud.fields);
  appendField<std::uint16_t>("label", {111, 222, 333}, cloud.fields);
  return cloud;
}

class DamagedCloudFile : public testing::TestWithParam<CloudLayout> {
protected:
  DamagedCloudFile()
  {
    saveCloud(path_, smallCloud(), GetParam());
    whole_ = readText(path_);
  }

  /** Anything but a cloud or a CIDException fails the test; a crash anyway. */
  bool
  isRead(const std::string& content)
  {
    writeText(path_, content);
    try {
      const LabelledCloud cloud = readCloud(path_);
      EXPECT_EQ(cloud.fields.data.size(), cloud.size() * cloud.fields.point_step);
      pointsOf(cloud);
      return true;
    }
    catch (const CIDException&) {
      return false;
    }
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("cloud");
  std::string whole_;
};

INSTANTIATE_TEST_SUITE_P(
    Formats,
    DamagedCloudFile,
    testing::Values(pcd_ascii, pcd_binary, pcd_compressed, ply_ascii, ply_binary));

TEST_P(DamagedCloudFile, IsRefusedWhereverItIsCut)
{
  ASSERT_TRUE(isRead(whole_));
  const bool is_text = GetParam() == pcd_ascii || GetParam() == ply_ascii;
  // In text nothing tells "33" from the first digits of "333".
  const std::size_t last_value = whole_.find_last_of(' ');
  const std::size_t end = is_text ? last_value + 2 : whole_.size();
  for (std::size_t size = 0; size < end; ++size)
    EXPECT_FALSE(isRead(whole_.substr(0, size))) << "cut to " << size << " bytes";
}

TEST_P(DamagedCloudFile, NeverCrashesTheReader)
{
  RandomGenerator generator(7);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = whole_;
    for (std::uint64_t change = 0; change <= drawBelow(generator, 4); ++change) {
      const std::size_t place = drawBelow(generator, damaged.size());
      switch (drawBelow(generator, 3)) {
      case 0:
        damaged[place] = static_cast<char>(drawBelow(generator, 256));
        break;
      case 1:
        damaged[place] = static_cast<char>('0' + drawBelow(generator, 10));
        break;
      default:
        damaged.erase(place, 1 + drawBelow(generator, 8));
      }
      if (damaged.empty())
        damaged = "#";
    }
    refused += isRead(damaged) ? 0 : 1;
  }
  EXPECT_GT(refused, 0);
}

} // namespace
} // namespace pcl_cid::test
