/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds from text, as many programs write it.
 */

#include "cloud_files.h"

#include <pcl_cid/io/scan_source.h>

#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Two points that every text below holds: (1.5, -2, 0.25) and (3, 4, 5e-1). */
struct GoodText {
  const char* name;
  const char* file; ///< its name
  std::string content;
  std::string fields; ///< of the cloud, with their types
};

void
PrintTo(const GoodText& text, std::ostream* stream)
{
  *stream << text.name;
}

std::string
fieldsOf(const LabelledCloud& cloud)
{
  std::string text;
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    text += (text.empty() ? "" : " ") + field.name + ":" +
            std::to_string(static_cast<int>(field.datatype));
  return text;
}

// 2 uint8, 4 uint16, 5 int32, 6 uint32, 7 float, 8 double
std::vector<GoodText>
goodTexts()
{
  return {
      {"Plain", "a.xyz", "1.5 -2 0.25\n3 4 5e-1\n", "x:7 y:7 z:7"},
      {"NoLastLineEnd", "a.asc", "1.5 -2 0.25\n3 4 0.5", "x:7 y:7 z:7"},
      {"Windows", "a.txt", "1.5\t-2\t0.25\r\n3\t4\t0.5\r\n\r\n", "x:7 y:7 z:7"},
      {"OldMac", "a.txt", "1.5 -2 0.25\r3 4 0.5\r", "x:7 y:7 z:7"},
      {"ByteOrderMark",
       "a.txt",
       "\xEF\xBB\xBF"
       "1.5 -2 0.25\n3 4 0.5\n",
       "x:7 y:7 z:7"},
      {"Capitals", "a.XYZ", "1.5 -2 0.25\n3 4 0.5\n", "x:7 y:7 z:7"},
      {"Blanks", "a.xyz", "  1.5   -2  +0.25  \n\n\t3 4 .5\n", "x:7 y:7 z:7"},
      {"Comments",
       "a.xyz",
       "# made by x y z\n1.5 -2 0.25\n// here\n3 4 0.5\n",
       "x:7 y:7 z:7"},
      {"Intensity", "a.xyz", "1.5 -2 0.25 7\n3 4 0.5 9\n", "x:7 y:7 z:7 intensity:7"},
      {"Colors", "a.xyz", "1.5 -2 0.25 255 0 10\n3 4 0.5 1 2 3\n", "x:7 y:7 z:7 rgb:7"},
      {"Normals",
       "a.xyz",
       "1.5 -2 0.25 0 0 1\n3 4 0.5 0 -1 0\n",
       "x:7 y:7 z:7 normal_x:7 normal_y:7 normal_z:7"},
      {"PTS",
       "a.pts",
       "2\n1.5 -2 0.25 -1200 255 0 10\n3 4 0.5 800 1 2 3\n",
       "x:7 y:7 z:7 intensity:7 rgb:7"},
      {"PTSOfTwoScans",
       "a.pts",
       "1\n1.5 -2 0.25 -1200 255 0 10\n1\n3 4 0.5 800 1 2 3\n",
       "x:7 y:7 z:7 intensity:7 rgb:7"},
      {"ColorsAndLabel",
       "a.txt",
       "1.5 -2 0.25 255 0 10 70000\n3 4 0.5 1 2 3 0\n",
       "x:7 y:7 z:7 rgb:7 column_7:6"},
      {"CSV",
       "a.csv",
       "\"X\",\"Y "
       "[m]\",Z(m),R,G,B,Label,Offset\n1.5,-2,.25,255,0,10,12,-4\n3,4,0.5,1,2,3,13,5\n",
       "x:7 y:7 z:7 rgb:7 label:6 Offset:5"},
      {"CSVInAnotherOrder",
       "a.csv",
       "time,z,y,x\n0.125,0.25,-2,1.5\n1.25,0.5,4,3\n",
       "time:7 z:7 y:7 x:7"},
      {"CSVWithClasses",
       "a.csv",
       "class,x,y,z\nwall,1.5,-2,0.25\nfloor,3,4,0.5\n",
       "x:7 y:7 z:7"},
      {"CSVWithLastSeparator", "a.csv", "1.5,-2,0.25\n3,4,0.5,\n", "x:7 y:7 z:7"},
      {"Semicolons", "a.csv", "x;y;z\n1,5;-2;0,25\n3;4;0,5\n", "x:7 y:7 z:7"},
      {"DecimalCommas", "a.txt", "1,5 -2,0 0,25\n3,0 4,0 0,5\n", "x:7 y:7 z:7"},
      {"CloudCompare",
       "a.asc",
       "//X Y Z R G B Scalar_field\n2\n1.5 -2 0.25 255 0 10 0.1\n3 4 0.5 1 2 3 0.7\n",
       "x:7 y:7 z:7 rgb:7 Scalar_field:7"},
      {"NumPy",
       "a.txt",
       "# x y z nx ny nz\n1.5 -2 0.25 0 0 1\n3 4 0.5 1 0 0\n",
       "x:7 y:7 z:7 normal_x:7 normal_y:7 normal_z:7"},
      {"ParaView",
       "a.csv",
       "\"intensity\",\"Points:0\",\"Points:1\",\"Points:2\"\n1,1.5,-2,0.25\n2,3,4,0."
       "5\n",
       "intensity:7 x:7 y:7 z:7"},
      {"Tabs",
       "a.txt",
       "x\ty\tz\tmy value\n1.5\t-2\t0.25\t1\n3\t4\t0.5\t2\n",
       "x:7 y:7 z:7 my_value:6"},
      {"ShareOfWhite",
       "a.csv",
       "x,y,z,r,g,b\n1.5,-2,0.25,1,0,0.5\n3,4,0.5,0.25,1,0\n",
       "x:7 y:7 z:7 red:7 green:7 blue:7"},
      {"SixteenBits",
       "a.csv",
       "x,y,z,r,g,b\n1.5,-2,0.25,65535,0,2\n3,4,0.5,0,1,0\n",
       "x:7 y:7 z:7 red:4 green:4 blue:4"},
      {"NormalsAlongAxes",
       "a.xyzn",
       "1.5 -2 0.25 0 0 1\n3 4 0.5 0 1 0\n",
       "x:7 y:7 z:7 normal_x:7 normal_y:7 normal_z:7"},
      {"SharesOfWhite",
       "a.xyzrgb",
       "1.5 -2 0.25 1 0 1\n3 4 0.5 1 1 1\n",
       "x:7 y:7 z:7 red:7 green:7 blue:7"},
      {"TwoComments",
       "a.txt",
       "# z y x\n# metres\n0.25 -2 1.5\n0.5 4 3\n",
       "z:7 y:7 x:7"},
      {"CommentBelowNames",
       "a.csv",
       "x,y,z\n# metres\n1.5,-2,0.25\n3,4,0.5\n",
       "x:7 y:7 z:7"},
      {"Pandas",
       "a.csv",
       ",x,y,z\n0,1.5,-2,0.25\n1,3,4,0.5\n",
       "column_1:6 x:7 y:7 z:7"},
      {"LastSeparators", "a.csv", "1.5,-2,0.25,\n3,4,0.5,\n", "x:7 y:7 z:7"},
      {"LastSeparatorsBelowNames",
       "a.csv",
       "x,y,z\n1.5,-2,0.25,\n3,4,0.5,\n",
       "x:7 y:7 z:7"},
      {"QuotedWords",
       "a.csv",
       "x,y,z,name\n1.5,-2,0.25,\"chair, big\"\n3,4,0.5,\"a\"\n",
       "x:7 y:7 z:7"},
      {"Excel", "a.csv", "sep=;\r\nx;y;z\r\n1,5;-2;0,25\r\n3;4;0,5\r\n", "x:7 y:7 z:7"},
      {"Time",
       "a.csv",
       "x,y,z,time\n1.5,-2,0.25,1700000000.125\n3,4,0.5,1700000000.25\n",
       "x:7 y:7 z:7 time:8"}};
}

class GoodTextCloud : public testing::TestWithParam<GoodText> {};

INSTANTIATE_TEST_SUITE_P(Texts,
                         GoodTextCloud,
                         testing::ValuesIn(goodTexts()),
                         [](const testing::TestParamInfo<GoodText>& info) {
                           return info.param.name;
                         });

TEST_P(GoodTextCloud, IsReadWithItsFields)
{
  const TemporaryFolder folder;
  const std::string path = folder.file(GetParam().file);
  writeText(path, GetParam().content);
  const LabelledCloud cloud = readCloud(path);
  EXPECT_EQ(fieldsOf(cloud), GetParam().fields);
  ASSERT_EQ(cloud.size(), 2u);
  const FileCoordinates points(cloud);
  EXPECT_EQ(points[0], Eigen::Vector3d(1.5, -2.0, 0.25));
  EXPECT_EQ(points[1], Eigen::Vector3d(3.0, 4.0, 0.5));
  if (hasColors(cloud)) {
    const ColorRGB color = colorsOf(cloud)[0]; // all red, no green
    EXPECT_EQ(color.r, 255);
    EXPECT_EQ(color.g, 0);
  }
}

struct BadText {
  const char* name;
  std::string content;
  const char* complaint;
};

void
PrintTo(const BadText& text, std::ostream* stream)
{
  *stream << text.name;
}

std::vector<BadText>
badTexts()
{
  return {
      {"Words", "no points here\nnor here\n", "line 2"},
      {"OnlyComments", "# x y z\n// nothing\n", "holds no points"},
      {"OnlyNames", "x,y,z\n", "holds no points"},
      {"TwoColumns", "1 2\n3 4\n", "x, y and z are needed"},
      {"NoZ", "x,y,w\n1,2,3\n", "line 1: 'x,y,w'"},
      {"FewerNames", "x,y,z\n1,2,3,4\n", "4 columns"},
      {"NoNumber", "1 2 3\n4 five 6\n", "line 2: 'five' is no number (column 2)"},
      {"NamedNoNumber", "x,y,z\n1,2,b\n", "line 2: 'b' is no number (column 3, z)"},
      {"Fewer", "1 2 3\n\n4 5\n", "line 3: 2 values; as on line 1"},
      {"OneOnly", "1 2 3\n4\n", "line 2: 1 value;"},
      {"More", "1 2 3\n4 5 6 7\n", "line 2: more than the 3 values of line 1"},
      {"FewerThanCount", "3\n1 2 3 4\n4 5 6 7\n", "holds 3 points, but there are 2"},
      {"MoreThanCount", "1\n1 2 3 4\n4 5 6 7\n", "holds 1 point, but there are 2"},
      {"Twice", "x,y,z,Intensity,INTENSITY\n1,2,3,4,5\n", "named 'intensity'"},
      {"TwoX", "x,X,y,z\n1,2,3,4\n", "line 1"},
      {"Binary", std::string("1 2 3\0\0\n", 8), "no text"},
      {"UTF16",
       std::string("\xFF\xFE"
                   "1\0 \0002\0",
                   8),
       "no text"}};
}

class BadTextCloud : public testing::TestWithParam<BadText> {};

INSTANTIATE_TEST_SUITE_P(Texts,
                         BadTextCloud,
                         testing::ValuesIn(badTexts()),
                         [](const testing::TestParamInfo<BadText>& info) {
                           return info.param.name;
                         });

TEST_P(BadTextCloud, IsRefusedWithItsLine)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("bad.xyz");
  writeText(path, GetParam().content);
  const std::string complaint = complaintAbout(path, [&] { readCloud(path); });
  EXPECT_NE(complaint.find(GetParam().complaint), std::string::npos) << complaint;
}

TEST(TextCloud, KeepsMillimetersFarFromTheOrigin)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("utm.xyz");
  writeText(path, "691234.001 5334321.002 520.003\n691239.004 5334325.005 523.006\n");
  const LabelledCloud cloud = readCloud(path);
  EXPECT_EQ(fieldsOf(cloud), "x:8 y:8 z:8");
  EXPECT_EQ(FileCoordinates(cloud)[1],
            Eigen::Vector3d(691239.004, 5334325.005, 523.006));
}

TEST(TextCloud, KeepsMillimetersBesideAPointAstray)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("utm.xyz");
  std::string text = "0 0 0\n";
  for (int i = 0; i < 100; ++i)
    text += "691234.0" + std::to_string(10 + i) + " 5334321.002 520.003\n";
  writeText(path, text);
  EXPECT_EQ(fieldsOf(readCloud(path)), "x:8 y:8 z:8");
}

TEST(TextCloud, MayHaveDecimalCommasFromTheSecondPointOn)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("comma.txt");
  writeText(path, "0 0 0\n0,25 1,5 -2\n");
  EXPECT_EQ(FileCoordinates(readCloud(path))[1], Eigen::Vector3d(0.25, 1.5, -2.0));
}

TEST(TextCloud, TakesWhatIsNoNumberAsNoPoint)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("holes.csv");
  writeText(path, "1,2,3\nnan,NaN,-inf\n,,\n4,5,6\n");
  const CloudPoints points = pointsOf(readCloud(path));
  EXPECT_EQ(points.points->size(), 4u);
  EXPECT_EQ(points.finite, 2u);
}

TEST(TextCloud, SaysWhatItTookColumnsFor)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("five.txt");
  writeText(path, "1 2 3 4 5\n");
  std::string said;
  readScan(path, {"", [&](const std::string& sentence) { said += sentence; }});
  EXPECT_NE(said.find("x, y, z, intensity and column_5"), std::string::npos) << said;
  said.clear();
  writeText(path, "x y z class\n1 2 3 wall\n");
  readScan(path, {"", [&](const std::string& sentence) { said += sentence; }});
  EXPECT_NE(said.find("passed over: 'class'"), std::string::npos) << said;
}

TEST(TextCloud, IsNoScanWhereAFolderHoldsIt)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("seeds.csv");
  writeText(path, "1,2,3\n");
  EXPECT_FALSE(isScan(path));
  EXPECT_EQ(readScan(path).size(), 1u);
}

TEST(TextCloud, IsRefusedWhereALineLacksValues)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("cut.xyz");
  const std::string first = "1.5 2.5 3.5 77\n";
  const std::string second = "4.5 5.5 6.5 88";
  for (std::size_t size = 0; size <= second.size(); ++size) {
    writeText(path, first + second.substr(0, size));
    const bool lacks_values = size > 0 && size <= second.rfind(' ') + 1;
    EXPECT_EQ(complaintAbout(path, [&] { readCloud(path); }) != "none", lacks_values)
        << size;
  }
}

} // namespace
} // namespace pcl_cid::test
