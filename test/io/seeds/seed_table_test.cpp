/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Seed tables, as written, filled in, and spoilt.
 */

#include "cloud_files.h"

#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/seed_table.h>

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Four points; the last is invalid. */
CloudPoints
fourPoints()
{
  CloudPoints points;
  points.points.reset(new pcl::PointCloud<pcl::PointXYZ>);
  points.points->emplace_back(0.0f, 0.0f, 0.0f);
  points.points->emplace_back(0.1f, 1.0f / 3.0f, -1e-7f);
  points.points->emplace_back(10.0f, 0.0f, 0.0f);
  points.points->emplace_back(std::nanf(""), 0.0f, 0.0f);
  points.finite = 3;
  return points;
}

class SeedTableTest : public testing::Test {
protected:
  SeedTable
  read(const std::string& text)
  {
    writeText(path_, text);
    return readSeedTable(path_, points_);
  }

  std::string
  complaint(const std::string& text)
  {
    return complaintAbout(path_, [&] { read(text); });
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("seeds.csv");
  CloudPoints points_ = fourPoints();
};

TEST_F(SeedTableTest, IsWrittenWithTheLabelsThatThereAre)
{
  std::ostringstream text;
  writeSeedTable(text, {2, 1, 0}, points_, {7, std::nullopt, 0});
  const SeedTable table = read(text.str());
  EXPECT_EQ(table.seeds, (pcl::Indices{2, 0}));
  EXPECT_EQ(table.labels, (std::vector<std::uint32_t>{7, 0}));
}

TEST_F(SeedTableTest, IsWrittenWithEmptyLabels)
{
  std::ostringstream text;
  writeSeedTable(text, {2, 1}, points_);
  EXPECT_EQ(text.str(), "index,x,y,z,label\n2,10,0,0,\n1,0.1,0.33333334,-1e-07,\n");
}

TEST_F(SeedTableTest, IsInTheUnitOfTheFile)
{
  points_.metres_per_unit = 0.001;
  std::ostringstream text;
  writeSeedTable(text, {2}, points_);
  EXPECT_EQ(text.str(), "index,x,y,z,label\n2,10000,0,0,\n");
  EXPECT_EQ(read("index,x,y,z,label\n2,10000,0,0,5\n").seeds, pcl::Indices{2});
  EXPECT_NE(complaint("index,x,y,z,label\n2,10,0,0,5\n"), "none");
}

TEST_F(SeedTableTest, ComesBackWhenFilledIn)
{
  std::ostringstream text;
  writeSeedTable(text, {2, 1, 0}, points_);
  std::string filled = text.str();
  filled.insert(filled.find("\n1,"), "7");
  filled.insert(filled.find("\n0,"), "0");
  const SeedTable table = read(filled); // the third was not asked
  EXPECT_EQ(table.seeds, (pcl::Indices{2, 1}));
  EXPECT_EQ(table.labels, (std::vector<std::uint32_t>{7, 0}));
}

TEST_F(SeedTableTest, KeepsMillimetersOfLargeCoordinates)
{
  points_.frame.origin = Eigen::Vector3d(500000, 4100000, 0);
  std::ostringstream text;
  writeSeedTable(text, {0, 1}, points_);
  EXPECT_NE(text.str().find("\n1,500000.1000000"), std::string::npos) << text.str();
  writeText(path_, text.str() + "2,,,,5\n");
  EXPECT_EQ(readSeedTable(path_, points_).seeds, pcl::Indices{2});
}

TEST_F(SeedTableTest, IsReadHoweverSpreadsheetsWriteIt)
{
  const SeedTable table =
      read("\xEF\xBB\xBFlabel , note,index\r\n\r\n 3 ,left chair, 1\r\n"
           ",,\r\n,no idea,2\r\n4294967295,,0");
  EXPECT_EQ(table.seeds, (pcl::Indices{1, 0}));
  EXPECT_EQ(table.labels, (std::vector<std::uint32_t>{3, 4294967295u}));
}

std::string
inUTF16(const std::string& text, bool is_big_endian)
{
  std::string bytes = is_big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text)
    bytes += is_big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

TEST_F(SeedTableTest, MayBeSeparatedAndEncodedInAnyWay)
{
  const std::string semicolons = "index;x;label\n1,0;0,1;3,0\n\"2\";10;\"5\"\n";
  const std::string tabs = "index\tx\tlabel\n1\t0.1\t3\n2\t\t5\n";
  const std::string named = "sep=;\nindex;label\n1;3\n2;5\n";
  const std::string quoted = "note,index,label\n\"a \"\"b\"\",\nc\",1,3\n,2.0,5\n";
  for (const std::string& text : {semicolons, tabs, named, quoted})
    for (const char* const end : {"\n", "\r", "\r\n"}) {
      std::string lines;
      for (const char c : text)
        lines += c == '\n' ? std::string(end) : std::string{c};
      for (const std::string& encoded : {lines,
                                         "\xEF\xBB\xBF" + lines,
                                         inUTF16(lines, false),
                                         inUTF16(lines, true)}) {
        const SeedTable table = read(encoded);
        EXPECT_EQ(table.seeds, (pcl::Indices{1, 2})) << lines;
        EXPECT_EQ(table.labels, (std::vector<std::uint32_t>{3, 5})) << lines;
      }
    }
  EXPECT_NE(complaint("index,label\n\"1,3\n").find("line 2: quotes do not end"),
            std::string::npos);
}

TEST_F(SeedTableTest, MayNameClassesInsteadOfLabels)
{
  const SeedTable table = read("index,label\n1,office chair\n0,1\n2,office chair\n");
  EXPECT_EQ(table.seeds, (pcl::Indices{1, 0, 2}));
  EXPECT_EQ(table.labels, (std::vector<std::uint32_t>{2, 1, 2}));
  EXPECT_EQ(table.names, (std::map<std::uint32_t, std::string>{{2, "office chair"}}));
}

TEST_F(SeedTableTest, CountsARepeatedSeedOnce)
{
  EXPECT_EQ(read("index,label\n1,5\n1,5\n1,\n").seeds, pcl::Indices{1});
}

TEST_F(SeedTableTest, NamesLineAndValueOfWhatIsWrong)
{
  const std::string header = "index,x,y,z,label\n";
  EXPECT_EQ(complaint(header + "0,,,,1\n4,,,,1\n"),
            ": line 3: the index is '4'; it must be a whole number, 0 to 3");
  EXPECT_EQ(complaint(header + "-1,,,,1\n"),
            ": line 2: the index is '-1'; it must be a whole number, 0 to 3");
  for (const char* const index : {"", "one", "1.5", "1x", "99999999999999999999"})
    EXPECT_NE(complaint(header + index + ",0,,,1\n").find("the index is '"),
              std::string::npos)
        << index;
  EXPECT_EQ(complaint(header + "0,,,,-1\n"),
            ": line 2: the label is '-1'; it must be a whole number, 0 to "
            "4294967295, the name of a class, or empty");
  for (const char* const label : {"-1", "1.5", "4294967296", "nan", "0x1"})
    EXPECT_NE(complaint(header + "0,,,," + label).find(label), std::string::npos);
  EXPECT_EQ(complaint(header + "1,,,,1\n0,,,,1\n1,,,,2\n"),
            ": line 4: point 1 has label 2, but label 1 in line 2; it must have one "
            "label");
  EXPECT_NE(
      complaint(header + "3,,,,1\n").find("line 2: the index is 3, a point whose"),
      std::string::npos);
  EXPECT_NE(complaint(header + "0,a,,,1\n").find("line 2: the x is 'a'"),
            std::string::npos);
}

TEST_F(SeedTableTest, MustBelongToTheCloud)
{
  const std::string header = "index,x,y,z,label\n";
  // The diagonal is 10 m, so 1 cm is the limit.
  EXPECT_EQ(read(header + "2,10.009,0,0,1\n").seeds, pcl::Indices{2});
  EXPECT_EQ(complaint(header + "2,10.02,0,0,1\n"),
            ": line 2: the table says (10.02, 0, 0), but point 2 is at (10, 0, 0); the "
            "table must belong to this cloud");
  EXPECT_NE(complaint(header + "2,nan,0,0,1\n"), "none");
}

TEST_F(SeedTableTest, NeedsItsColumnsAndALabel)
{
  EXPECT_NE(complaint("").find("is empty"), std::string::npos);
  EXPECT_NE(complaint("0,0,0,0,1\n").find("no column 'index'"), std::string::npos);
  EXPECT_NE(complaint("index,x,y,z\n0,0,0,0\n").find("no column 'label'"),
            std::string::npos);
  EXPECT_NE(complaint("index|label\n0|1\n").find("no column 'index'"),
            std::string::npos);
  EXPECT_NE(complaint("index,x,y,z,label\n0,0,0,0,\n").find("no label is filled in"),
            std::string::npos);
  EXPECT_THROW(readSeedTable(folder_.file("missing.csv"), points_), CIDException);
}

TEST_F(SeedTableTest, TellsWhetherLabelsWouldBeLost)
{
  EXPECT_FALSE(holdsLabels(path_));
  writeText(path_, "index,x,y,z,label\n0,0,0,0,\n");
  EXPECT_FALSE(holdsLabels(path_));
  writeText(path_, "index,x,y,z,label\n0,0,0,0,0\n");
  EXPECT_TRUE(holdsLabels(path_));
  writeText(path_, "something else\n");
  EXPECT_FALSE(holdsLabels(path_));
}

} // namespace
} // namespace pcl_cid::test
