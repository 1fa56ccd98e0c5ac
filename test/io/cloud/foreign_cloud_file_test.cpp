/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Cloud files as other programs write them: they are read, nothing in them is lost, and
 * what is passed over is said.
 */

#include "cloud_files.h"

#include <cmath>
#include <functional>
#include <sstream>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** A file that holds some text. */
class ForeignCloudFile : public testing::Test {
protected:
  LabelledCloud
  read(const std::string& content)
  {
    writeText(path_, content);
    return readCloud(path_);
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("cloud");
};

const std::string pcd_of_two = "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\n"
                               "TYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\n"
                               "POINTS 2\nDATA ascii\n1 2 3 7\n4 5 6 8\n";
const std::string ply_of_two =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty uint label\nend_header\n1 2 3 7\n4 5 6 8\n";

std::string
withLineEnd(const std::string& text, const std::string& end)
{
  std::string result;
  for (const char c : text)
    if (c == '\n')
      result += end;
    else
      result += c;
  return result;
}

void
expectTwoPoints(const LabelledCloud& cloud)
{
  EXPECT_EQ(valuesOf<float>(cloud.fields, "x"), (std::vector<float>{1, 4}));
  EXPECT_EQ(valuesOf<float>(cloud.fields, "y"), (std::vector<float>{2, 5}));
  EXPECT_EQ(valuesOf<float>(cloud.fields, "z"), (std::vector<float>{3, 6}));
  EXPECT_EQ(valuesOf<std::uint32_t>(cloud.fields, "label"),
            (std::vector<std::uint32_t>{7, 8}));
}

TEST_F(ForeignCloudFile, MayEndItsLinesInAnyWay)
{
  for (const std::string& text : {pcd_of_two, ply_of_two})
    for (const char* const end : {"\n", "\r", "\r\n", "\r\r\n"}) {
      SCOPED_TRACE(testing::PrintToString(end) + text.substr(0, 3));
      expectTwoPoints(read(withLineEnd(text, end)));
    }
}

TEST_F(ForeignCloudFile, MayBeginWithAByteOrderMarkOrBlanks)
{
  for (const std::string& text : {pcd_of_two, ply_of_two})
    for (const char* const start : {"\xEF\xBB\xBF", "\n", "  ", "\xEF\xBB\xBF\n \n"}) {
      SCOPED_TRACE(testing::PrintToString(start) + text.substr(0, 3));
      expectTwoPoints(read(start + text));
    }
}

TEST_F(ForeignCloudFile, MayBreakLinesWithinAVertex)
{
  expectTwoPoints(read(ply_of_two.substr(0, ply_of_two.find("1 2 3 7")) +
                       "1 2\n3 7\n\n4\n5\n6\n8\n\n \n"));
}

TEST_F(ForeignCloudFile, MayHaveFieldsWithoutValues)
{
  const LabelledCloud cloud =
      read("VERSION 0.7\nFIELDS x y empty z _ label\nSIZE 4 4 1 4 1 4\n"
           "TYPE F F U F U U\nCOUNT 1 1 0 1 0 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n"
           "DATA ascii\n1 2 3 7\n4 5 6 8\n");
  expectTwoPoints(cloud);
  EXPECT_EQ(cloud.remarks,
            std::vector<std::string>{"field 'empty' has COUNT 0; it is passed over"});
}

TEST_F(ForeignCloudFile, MustHaveAFieldWithValues)
{
  for (const char* const data : {"ascii\n", "binary\n", "binary_compressed\n"})
    EXPECT_THROW(read(std::string("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
                                  "TYPE F F F\nCOUNT 0 0 0\nWIDTH 2\nHEIGHT 1\n"
                                  "POINTS 2\nDATA ") +
                      data + std::string(64, '\0')),
                 CIDException)
        << data;
}

TEST_F(ForeignCloudFile, KeepsListsThatAreEquallyLongForAllVertices)
{
  const LabelledCloud cloud =
      read("ply\nformat ascii 1.0\nelement vertex 2\nproperty list uchar uchar _\n"
           "property float x\nproperty list uchar ushort views\nproperty float y\n"
           "property list int float weights\nproperty float z\nproperty uint label\n"
           "property list uchar float none\nend_header\n"
           "1 9 1 2 10 11 2 1 0.5 3 7 0\n3 9 9 9 4 2 12 13 5 2 0.5 0.25 6 8 0\n");
  expectTwoPoints(cloud);
  EXPECT_EQ(valuesOf<std::uint16_t>(cloud.fields, "views"),
            (std::vector<std::uint16_t>{10, 11, 12, 13}));
  EXPECT_FALSE(hasField(cloud, "weights"));
  EXPECT_FALSE(hasField(cloud, "none"));
  EXPECT_FALSE(hasField(cloud, "_"));
  ASSERT_EQ(cloud.remarks.size(), 2u);
  EXPECT_NE(cloud.remarks[0].find("'weights'"), std::string::npos);
  EXPECT_NE(cloud.remarks[1].find("'none'"), std::string::npos);
}

TEST_F(ForeignCloudFile, MayHoldWholeNumbersAsDecimalsAndNumbersBelowFloat)
{
  const LabelledCloud cloud =
      read("VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\n"
           "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
           "1e-46 -1e-330 1e-40 3.0\n4 5 6 8.00\n");
  EXPECT_EQ(valuesOf<float>(cloud.fields, "x"), (std::vector<float>{0, 4}));
  EXPECT_EQ(valuesOf<float>(cloud.fields, "y"), (std::vector<float>{-0.0f, 5}));
  EXPECT_EQ(valuesOf<float>(cloud.fields, "z"), (std::vector<float>{1e-40f, 6}));
  EXPECT_EQ(valuesOf<std::uint32_t>(cloud.fields, "label"),
            (std::vector<std::uint32_t>{3, 8}));
}

TEST_F(ForeignCloudFile, MayHaveIntegerCoordinatesAndTruthValues)
{
  const LabelledCloud cloud =
      read("VERSION 0.7\nFIELDS x y z ground\nSIZE 4 2 1 1\nTYPE I I U B\n"
           "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
           "-2000000001 2 3 1\n-2000000000 5 6 0\n");
  const CloudPoints points = pointsOf(cloud);
  EXPECT_EQ((*points.points)[1].x - (*points.points)[0].x, 1.0f);
  EXPECT_EQ((*points.points)[1].y, 5.0f);
  EXPECT_EQ(labelsOf(cloud, "ground", points), (std::vector<std::uint32_t>{1, 0}));
  for (const CloudLayout& layout : {pcd_ascii, pcd_binary, pcd_compressed}) {
    saveCloud(path_, cloud, layout);
    const LabelledCloud again = readCloud(path_);
    EXPECT_EQ(again.fields.fields.back().datatype, pcl::PCLPointField::BOOL);
    EXPECT_EQ(bytesOf(again.fields, "ground"), bytesOf(cloud.fields, "ground"));
  }
}

TEST_F(ForeignCloudFile, MayEndInAPageOfZeros)
{
  for (const CloudLayout& layout : {pcd_binary, pcd_compressed}) {
    saveCloud(path_, read(pcd_of_two), layout);
    const std::string whole = readText(path_);
    for (const std::size_t zeros : {1u, 4096u}) {
      const LabelledCloud cloud = read(whole + std::string(zeros, '\0'));
      expectTwoPoints(cloud);
      EXPECT_EQ(cloud.remarks.size(), 1u);
    }
    EXPECT_THROW(read(whole + std::string(4097, '\0')), CIDException);
    EXPECT_THROW(read(whole + std::string("\0\0x", 3)), CIDException);
  }
}

TEST_F(ForeignCloudFile, MayHaveAViewpointThatIsNone)
{
  for (const char* const pose :
       {"0 0 0 0 0 0 0", "nan 0 0 1 0 0 0", "1 2 3 1 0 0 inf"}) {
    std::string text = pcd_of_two;
    text.insert(text.find("POINTS"), std::string("VIEWPOINT ") + pose + "\n");
    const LabelledCloud cloud = read(text);
    expectTwoPoints(cloud);
    EXPECT_TRUE(cloud.sensor_origin.isZero(0.0f)) << pose;
    EXPECT_EQ(cloud.sensor_orientation.w(), 1.0f) << pose;
    EXPECT_EQ(cloud.remarks.size(), 1u) << pose;
  }
}

/** What a file of many lines costs must not depend on what its header promises. */
TEST_F(ForeignCloudFile, WithoutValuesInItsRowsIsReadAtOnce)
{
  EXPECT_NO_THROW(read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                       "property float y\nproperty float z\n"
                       "element nothing 18446744073709551615\nend_header\n1 2 3\n"));
}

} // namespace
} // namespace pcl_cid::test
