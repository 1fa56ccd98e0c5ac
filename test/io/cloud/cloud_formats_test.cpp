/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The table of cloud formats: what follows from a row, and a format added from outside.
 */

#include "cloud_files.h"

#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <istream>
#include <ostream>
#include <sstream>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(LayoutFor, KeepsTheEncodingWhereItCan)
{
  EXPECT_EQ(layoutFor("a.pcd", pcd_ascii), pcd_ascii);
  EXPECT_EQ(layoutFor("a.PCD", pcd_binary), pcd_binary);
  EXPECT_EQ(layoutFor("a.pcd", pcd_compressed), pcd_compressed);
  EXPECT_EQ(layoutFor("a.pcd", ply_binary), pcd_compressed);
  EXPECT_EQ(layoutFor("a.pcd", ply_ascii), pcd_ascii);
  EXPECT_EQ(layoutFor("a.ply", ply_binary), ply_binary);
  EXPECT_EQ(layoutFor("a.ply", pcd_ascii), ply_ascii);
  EXPECT_EQ(layoutFor("a.ply", pcd_binary), ply_binary);
  EXPECT_EQ(layoutFor("a.ply", pcd_compressed), ply_binary);
}

TEST(CloudFormats, SayWhichExtensionsThereAre)
{
  EXPECT_EQ(cloudFormats().at(0).name, "PCD");
  EXPECT_EQ(cloudFormats().at(1).name, "PLY");
  EXPECT_EQ(readableCloudNames().at(1), "PLY");
  EXPECT_EQ(writableCloudExtensions().at(0), ".pcd");
  ASSERT_NE(findCloudFormat("no such/file.PLY"), nullptr);
  EXPECT_EQ(findCloudFormat("file.PLY")->name, "PLY");
  for (const char* const path : {"", "pcd", ".pcd", "a.pc", "a.pcd.doc"})
    EXPECT_EQ(findCloudFormat(path), nullptr) << path;
}

TEST(CloudFormats, RefuseWhatNoneOfThemIs)
{
  try {
    layoutFor("a.obj", pcd_ascii);
    FAIL() << "no cloud is written as .obj";
  }
  catch (const CIDException& error) {
    EXPECT_EQ(std::string(error.what()).rfind("a.obj: a cloud is written as .pcd", 0),
              0u)
        << error.what();
  }
  std::ostringstream stream;
  for (const CloudLayout& layout : {CloudLayout{"PLY", CloudEncoding::compressed},
                                    CloudLayout{"", CloudEncoding::ascii},
                                    CloudLayout{"ply", CloudEncoding::ascii}})
    EXPECT_THROW(writeCloud(stream, deskScan(), layout), CIDException);
  EXPECT_EQ(stream.str(), "");
}

/** A toy: a file with a mark, then a line "x y z" for each point. */
void
readLines(std::istream& stream, std::uint64_t, LabelledCloud& cloud)
{
  std::string mark;
  std::getline(stream, mark);
  pcl::PointCloud<pcl::PointXYZ> points;
  for (pcl::PointXYZ point; stream >> point.x >> point.y >> point.z;)
    points.push_back(point);
  const std::string name = cloud.name;
  cloud = toLabelledCloud(points);
  cloud.name = name;
  cloud.layout = {"LINES", CloudEncoding::ascii};
}

void
writeLines(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding)
{
  const CloudPoints points = pointsOf(cloud);
  stream << "lines\n";
  for (const pcl::PointXYZ& point : *points.points)
    stream << point.x << ' ' << point.y << ' ' << point.z << '\n';
}

CloudFormat
linesFormat()
{
  CloudFormat format;
  format.name = "LINES";
  format.extensions = {".lines", ".ln"};
  format.encodings = {CloudEncoding::ascii};
  format.recognizes = [](std::istream& stream) {
    std::string mark;
    return stream >> mark && mark == "lines";
  };
  format.read = readLines;
  format.write = writeLines;
  return format;
}

/** Registered once for all tests of this process. */
class RegisteredCloudFormat : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    if (!findCloudFormat("a.lines"))
      registerCloudFormat(linesFormat());
  }

  TemporaryFolder folder_;
};

TEST_F(RegisteredCloudFormat, IsReadByItsContentAndWrittenByItsName)
{
  const std::string path = folder_.file("scan.ln");
  EXPECT_EQ(layoutFor(path, pcd_binary).format, "LINES");
  pcl::PointCloud<pcl::PointXYZ> points;
  points.emplace_back(1.0f, 2.0f, 3.0f);
  points.emplace_back(-0.5f, 0.25f, 0.0f);
  saveCloud(path, toLabelledCloud(points), layoutFor(path, pcd_binary));
  EXPECT_EQ(readText(path), "lines\n1 2 3\n-0.5 0.25 0\n");

  for (const std::string& name : {path, folder_.file("renamed.pcd")}) {
    std::rename(path.c_str(), name.c_str());
    const LabelledCloud cloud = readScan(name);
    EXPECT_EQ(cloud.name, name);
    EXPECT_EQ(cloud.size(), 2u);
    EXPECT_EQ((*pointsOf(cloud).points)[1].y, 0.25f);
  }
  saveCloud(folder_.file("back.ply"),
            readCloud(folder_.file("renamed.pcd")),
            layoutFor("back.ply", {"LINES", CloudEncoding::ascii}));
  EXPECT_EQ(readCloud(folder_.file("back.ply")).layout, ply_ascii);
}

TEST_F(RegisteredCloudFormat, IsKnownWhereverFormatsAreNamed)
{
  const std::vector<std::string> extensions = writableCloudExtensions();
  EXPECT_EQ(std::count(extensions.begin(), extensions.end(), ".ln"), 1);
  const std::string path = folder_.file("scan.LINES");
  EXPECT_FALSE(isScan(path));
  writeText(path, "lines\n1 2 3\n");
  EXPECT_TRUE(isScan(path));
  writeText(folder_.file("text"), "no lines");
  try {
    readCloud(folder_.file("text"));
    FAIL() << "was read";
  }
  catch (const CIDException& error) {
    EXPECT_NE(std::string(error.what()).find("a LINES"), std::string::npos);
  }
}

TEST_F(RegisteredCloudFormat, MustReadWholeClouds)
{
  writeText(folder_.file("empty.lines"), "lines\n");
  EXPECT_THROW(readCloud(folder_.file("empty.lines")), CIDException);

  CloudFormat careless = linesFormat();
  careless.name = "CARELESS";
  careless.extensions = {".careless"};
  careless.recognizes = nullptr; // its files have no mark
  careless.read = [](std::istream&, std::uint64_t, LabelledCloud& cloud) {
    cloud.fields = deskScan().fields;
    cloud.fields.width += 1;
  };
  careless.write = nullptr;
  if (!findCloudFormat("a.careless"))
    registerCloudFormat(careless);
  writeText(folder_.file("a.careless"), "0");
  EXPECT_THROW(readCloud(folder_.file("a.careless")), CIDException);
  EXPECT_THROW(layoutFor("a.careless", pcd_binary), CIDException);
}

TEST_F(RegisteredCloudFormat, MustBeNewAndWhole)
{
  const std::size_t before = cloudFormats().size();
  const auto expectRefused = [](const std::function<void(CloudFormat&)>& spoil) {
    CloudFormat format = linesFormat();
    format.name = "OTHER";
    format.extensions = {".other"};
    spoil(format);
    EXPECT_THROW(registerCloudFormat(format), CIDException);
  };
  expectRefused([](CloudFormat& format) { format.name = "PCD"; });
  expectRefused([](CloudFormat& format) { format.name = ""; });
  expectRefused([](CloudFormat& format) { format.extensions = {}; });
  expectRefused([](CloudFormat& format) { format.extensions = {".new", ".ply"}; });
  for (const char* const extension : {"", ".", "new", ".NEW", ".new.gz"})
    expectRefused([&](CloudFormat& format) { format.extensions = {extension}; });
  expectRefused([](CloudFormat& format) { format.encodings = {}; });
  expectRefused([](CloudFormat& format) {
    format.read = nullptr;
    format.write = nullptr;
  });
  EXPECT_EQ(cloudFormats().size(), before);
}

} // namespace
} // namespace pcl_cid::test
