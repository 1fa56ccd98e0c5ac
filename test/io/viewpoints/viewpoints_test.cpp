/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Positions of sensors, as programs and people write them, and spoilt.
 */

#include "cloud_files.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/viewpoints.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

class ViewpointsTest : public testing::Test {
protected:
  std::vector<Eigen::Vector3d>
  read(const std::string& text)
  {
    writeText(path_, text);
    return readViewpoints(path_);
  }

  std::string
  complaint(const std::string& text)
  {
    return complaintAbout(path_ + ": ", [&] { read(text); });
  }

  const std::vector<Eigen::Vector3d> two_{{1, 2, 3}, {-4.5, 0, 1e15}};
  TemporaryFolder folder_;
  std::string path_ = folder_.file("sensors");
};

TEST_F(ViewpointsTest, AreReadFromEveryShapeOfJson)
{
  for (const char* const text :
       {"[[1, 2, 3], [-4.5, 0, 1e15]]",
        "\xEF\xBB\xBF \r\n[[1, 2, 3], [-4.5, 0, 1e15]]",
        R"({"cloud": "a", "sensor_positions": [[1, 2, 3], [-4.5, 0, 1e15]]})",
        R"({"viewpoints": [[1, 2, 3], [-4.5, 0, 1e15]], "x": 1})",
        R"([{"x": 1, "y": 2, "z": 3}, {"z": 1e15, "y": 0, "x": -4.5, "name": "b"}])",
        R"([{"position": [1, 2, 3]}, {"position": {"x": -4.5, "y": 0, "z": 1e15}}])"})
    EXPECT_EQ(read(text), two_) << text;
}

TEST_F(ViewpointsTest, AreReadFromTables)
{
  for (const char* const text : {"1,2,3\n-4.5,0,1e15\n",
                                 "x,y,z\n1,2,3\n-4.5,0,1e15\n",
                                 "z\ty\tname\tx\r\n3\t2\ta\t1\r\n\r\n1e15\t0\t\t-4,5",
                                 "sep=;\n\"x\"; y ;z\n1;2.0;3;\n-4,5;0;1e15;;\n"})
    EXPECT_EQ(read(text), two_) << text;
}

TEST_F(ViewpointsTest, OfTheSampleScanAreRead)
{
  const auto viewpoints =
      readViewpoints(std::string(PCL_CID_DATA_DIR) + "/room_truth.json");
  ASSERT_EQ(viewpoints.size(), 4u);
  EXPECT_EQ(viewpoints[0],
            Eigen::Vector3d(4.597898259837054, 1.5517590201590807, 1.1385652109527602));
}

TEST_F(ViewpointsTest, KeepEveryDigit)
{
  EXPECT_EQ(read("[[458123.12345678901, 0.1, 5e-324]]")[0],
            Eigen::Vector3d(458123.12345678901, 0.1, 5e-324));
}

TEST_F(ViewpointsTest, AreRefusedWhereThereIsNone)
{
  const std::string none = "holds no position of a sensor; at least 1 is needed";
  for (const char* const text :
       {"", "\n \n", "[]", R"({"sensor_positions": []})", "x,y,z\n"})
    EXPECT_EQ(complaint(text), none) << text;
  EXPECT_THROW(readViewpoints(folder_.file("missing.json")), CIDException);
  EXPECT_THROW(readViewpoints(folder_.file("")), CIDException);
}

TEST_F(ViewpointsTest, InJsonNameWhatIsWrong)
{
  const std::string shape = "it must be [x, y, z] or {\"x\": x, \"y\": y, \"z\": z}";
  const std::string number = "; it must be a number, -1e15 to 1e15";
  EXPECT_EQ(complaint("[[1, 2, 3], [1, 2]]"), "viewpoints[1] has 2 values; " + shape);
  EXPECT_EQ(complaint("[1, 2, 3]"), "viewpoints[0] is no position; " + shape);
  EXPECT_EQ(complaint(R"({"sensor_positions": [[1, "2", 3]]})"),
            "sensor_positions[0] has no usable coordinate y" + number);
  EXPECT_EQ(complaint("[[1, 2, 1.1e15]]"),
            "viewpoints[0] has no usable coordinate z" + number);
  EXPECT_EQ(complaint(R"([{"x": 1, "y": 2}])"), "viewpoints[0] has no member 'z'");
  EXPECT_EQ(complaint(R"([{"position": [1]}])"),
            "viewpoints[0].position has 1 value; " + shape);
  EXPECT_EQ(complaint(R"({"positions": [[1, 2, 3]]})"),
            "has no member 'sensor_positions' and no member 'viewpoints'; one of them "
            "must be an array of positions");
  EXPECT_EQ(complaint(R"({"viewpoints": 7})"), "viewpoints is 7; it must be an array");
  EXPECT_EQ(complaint("[[1, 2, nan]]"), "offset 9: is no valid JSON");
  EXPECT_EQ(complaint("[[1, 2, 1e999]]").rfind("is no JSON that can be read: ", 0), 0u);
  EXPECT_EQ(complaint(std::string(100, '[') + std::string(100, ']')),
            "is no JSON that can be read: it is nested more than 64 levels deep");
}

TEST_F(ViewpointsTest, InTablesNameLineAndValueOfWhatIsWrong)
{
  const std::string number = "; it must be a number, -1e15 to 1e15";
  EXPECT_EQ(complaint("1,2,3\n4,nan,6\n"), "line 2: the y is 'nan'" + number);
  EXPECT_EQ(complaint("1,2,inf\n"), "line 1: the z is 'inf'" + number);
  EXPECT_EQ(complaint("x,y,z\n1,2,3\n\n-2e15,0,0\n"),
            "line 4: the x is '-2e15'" + number);
  EXPECT_EQ(complaint("x,y,z\n1,2\n"), "line 2: the z is ''" + number);
  EXPECT_EQ(complaint("a,b,c\n1,2,3\n"), "line 1: the x is 'a'" + number);
  const std::string three =
      "; it must have three: x, y and z, separated by commas, semicolons or tabs, or a "
      "header must name the columns x, y and z";
  EXPECT_EQ(complaint("1,2,3\n1,2\n"), "line 2: has 2 values" + three);
  EXPECT_EQ(complaint("1 2 3\n"), "line 1: has 1 value" + three);
  EXPECT_EQ(complaint("1,2,\"3\n"), "line 1: quotes do not end");
}

} // namespace
} // namespace pcl_cid::test
