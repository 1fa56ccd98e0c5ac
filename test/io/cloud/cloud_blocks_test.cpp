/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds read and written block by block: the same as all at once, remarks and errors,
 * too.
 */

#include "cloud_files.h"

#include <pcl_cid/io/cloud_blocks.h>

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <zlib.h>

namespace pcl_cid::test {
namespace {

/** What blocks gave, put together. */
LabelledCloud
readInBlocks(CloudBlockReader& reader, std::size_t most)
{
  LabelledCloud whole = reader.head();
  LabelledCloud block;
  while (reader.read(block)) {
    EXPECT_LE(block.size(), most);
    EXPECT_EQ(block.fields.fields.size(), whole.fields.fields.size());
    EXPECT_EQ(block.fields.data.size(), block.size() * block.fields.point_step);
    EXPECT_EQ(block.scale, whole.scale);
    whole.fields.data.insert(
        whole.fields.data.end(), block.fields.data.begin(), block.fields.data.end());
  }
  whole.remarks = reader.head().remarks;
  return whole;
}

void
expectEqual(const LabelledCloud& cloud, const LabelledCloud& expected)
{
  EXPECT_EQ(cloud.fields.width, expected.fields.width);
  EXPECT_EQ(cloud.fields.height, expected.fields.height);
  EXPECT_EQ(cloud.fields.row_step, expected.fields.row_step);
  EXPECT_EQ(cloud.fields.data, expected.fields.data);
  EXPECT_EQ(cloud.layout, expected.layout);
  EXPECT_EQ(cloud.sensor_origin, expected.sensor_origin);
  EXPECT_EQ(cloud.sensor_orientation.coeffs(), expected.sensor_orientation.coeffs());
  EXPECT_EQ(cloud.remarks, expected.remarks);
  ASSERT_EQ(cloud.fields.fields.size(), expected.fields.fields.size());
  for (std::size_t k = 0; k < cloud.fields.fields.size(); ++k) {
    EXPECT_EQ(cloud.fields.fields[k].name, expected.fields.fields[k].name);
    EXPECT_EQ(cloud.fields.fields[k].offset, expected.fields.fields[k].offset);
    EXPECT_EQ(cloud.fields.fields[k].datatype, expected.fields.fields[k].datatype);
    EXPECT_EQ(cloud.fields.fields[k].count, expected.fields.fields[k].count);
  }
}

/** Read as often as need be, in blocks of any size, it is what readCloud() gives. */
void
expectSameInBlocks(const std::string& path)
{
  SCOPED_TRACE(path);
  const LabelledCloud expected = readCloud(path);
  for (const std::size_t most : {std::size_t{1}, std::size_t{7}, std::size_t{65536}}) {
    CloudBlockReader reader(path, "", setting::scale.initial, most);
    for (int time = 0; time < 3; ++time) {
      expectEqual(readInBlocks(reader, most), expected);
      reader.rewind();
    }
    LabelledCloud some;
    reader.read(some); // and not to the end
    reader.rewind();
    expectEqual(readInBlocks(reader, most), expected);
  }
}

std::string
bytesOfFloats(const std::vector<float>& values)
{
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

std::string
reversedFloats(std::string bytes)
{
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(float))
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + sizeof(float)));
  return bytes;
}

TEST(CloudBlocks, AreThoseOfTheWholeCloud)
{
  const TemporaryFolder folder;
  LabelledCloud desk = deskScan();
  setLabels(deskLabels(), LabelType::U4, desk);
  for (const CloudLayout& layout : {pcd_ascii, pcd_binary, ply_binary}) {
    const std::string path = folder.file(layout.format == "PCD" ? "a.pcd" : "a.ply");
    saveCloud(path, desk, layout);
    expectSameInBlocks(path);
  }
}

/** The types of columns follow from all values, of which the last may be another. */
TEST(CloudBlocks, ReadTextAsAllAtOnce)
{
  const TemporaryFolder folder;
  std::string far_off = "x,y,z,class\n";
  std::string colors = "# x y z r g b\r\n";
  std::string pts = "2\n1 2 3 -500 1 2 3\n4 5.5 6 7 255 0 9\n";
  for (int i = 0; i < 30000; ++i) {
    far_off += std::to_string(456000.0 + 0.001 * (i % 977)) + ",5400000.25," +
               std::to_string(i % 7) + (i == 29999 ? ",-1\n" : ",3\n");
    if (i < 40)
      colors += "1 2 " + std::to_string(i) + " 0.25 1 0.5\r\n\r\n";
  }
  int number = 0;
  for (const std::string& text :
       {std::string("1 2 3\n4 5.5 6e-3\nnan 8 9\n"),
        std::string("\xEF\xBB\xBF//X,Y,Z,R,G,B,class\n2\n1,2,3,255,0,1,wall\n"
                    "4,5,6,1,2,3,\n"),
        std::string("sep=;\nx;y;z;\"my label\"\r\n1,5;2;3;4\r\n;;;5\r\n"),
        std::string("1 2 3 0 0 1\r4 5 6 0 1 0\r# end\r"),
        std::string("1 2 3 9 8 255\n4 5 6 1 0 0"),
        std::string("1 2 3 9 8 256\n4 5 6 1 0 0"),
        pts,
        pts + "1\n1 2 3 4 5 6 7\n",
        colors,
        colors + "1 2 3 300 4 5\n",
        far_off}) {
    const std::string path = folder.file(std::to_string(number++) + ".txt");
    writeText(path, text);
    SCOPED_TRACE(text.substr(0, 60));
    const LabelledCloud expected = readCloud(path);
    for (const std::size_t most : {std::size_t{3}, std::size_t{65536}}) {
      CloudBlockReader reader(path, "", setting::scale.initial, most);
      for (int time = 0; time < 2; ++time) {
        expectEqual(readInBlocks(reader, most), expected);
        reader.rewind();
      }
    }
  }
}

TEST(CloudBlocks, TellHowFarATextWasRead)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("a.xyz");
  std::string text;
  for (int i = 0; i < 140000; ++i)
    text += "1 2 3\n";
  writeText(path, text);
  std::vector<double> told;
  const auto open = [&](std::size_t most) {
    told.clear();
    CloudBlockReader reader(path, "", setting::scale.initial, 65536, [&](double done) {
      told.push_back(done);
      return told.size() < most;
    });
  };
  open(100);
  ASSERT_EQ(told.size(), 4u); // twice the file, with two blocks that are full
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told[0], 0.2);
  EXPECT_LE(told[3], 1.0);
  EXPECT_THROW(open(3), CIDCancelled);
}

TEST(CloudBlocks, SeeThatATextHasChanged)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("a.xyz");
  for (const char* const text :
       {"1 2 3\n", "1 2 3\n4 5 6\n7 8 9\n", "1 2 3\n4 5 7\n"}) {
    writeText(path, "1 2 3\n4 5 6\n");
    CloudBlockReader reader(path);
    readInBlocks(reader, 65536);
    std::ofstream(path) << text; // the same file, which is open
    reader.rewind();
    EXPECT_THROW(readInBlocks(reader, 65536), CIDException) << text;
  }
}

TEST(CloudBlocks, ReadWhatOtherProgramsWrite)
{
  const TemporaryFolder folder;
  const std::string three = bytesOfFloats({1, 2, 3, 9, 4, 5, 6, 9, 7, 8, 9.5, 9});
  writeText(folder.file("padded.pcd"),
            "VERSION 0.7\nFIELDS x y z _\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
            "WIDTH 3\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 3\nDATA binary\n" +
                three);
  expectSameInBlocks(folder.file("padded.pcd"));
  writeText(folder.file("zeros.pcd"),
            readText(folder.file("padded.pcd")) + std::string(100, '\0'));
  expectSameInBlocks(folder.file("zeros.pcd"));
  EXPECT_EQ(readCloud(folder.file("zeros.pcd")).remarks.size(), 1u);
  writeText(folder.file("blanks.pcd"),
            "FIELDS x y z\r\nSIZE 4 4 4\r\nTYPE F F F\r\nWIDTH 2\r\nHEIGHT 1\r\nPOINTS "
            "2\r\nDATA ascii\r\n\r\n1 2 3\r\n\r\n4 5 nan\r\n\r\n");
  expectSameInBlocks(folder.file("blanks.pcd"));

  const std::string elements =
      "element before 1\nproperty list uchar float l\nelement vertex 3\nproperty float "
      "x\nproperty float y\nproperty float z\nproperty float nx\nelement face "
      "1\nproperty list uchar int v\nend_header\n";
  const std::string list("\1", 1);
  const std::string faces = list + std::string(4, '\0');
  writeText(folder.file("little.ply"),
            "ply\nformat binary_little_endian 1.0\n" + elements + list +
                std::string(4, '\0') + three + faces);
  expectSameInBlocks(folder.file("little.ply"));
  writeText(folder.file("big.ply"),
            "ply\nformat binary_big_endian 1.0\n" + elements + list +
                std::string(4, '\0') + reversedFloats(three) + faces);
  expectSameInBlocks(folder.file("big.ply"));
  EXPECT_EQ(readCloud(folder.file("big.ply")).fields.data,
            readCloud(folder.file("little.ply")).fields.data);
}

TEST(CloudBlocks, ReadScansOfDatasets)
{
  const TemporaryFolder folder;
  std::vector<float> rings;
  for (int i = 0; i < 60; ++i) // divides by four and by five
    for (int k = 0; k < 5; ++k)
      rings.push_back(k == 4 ? static_cast<float>(i % 32)
                             : 0.3f * static_cast<float>(i));
  writeText(folder.file("nuscenes.bin"), bytesOfFloats(rings));
  expectSameInBlocks(folder.file("nuscenes.bin"));
  EXPECT_TRUE(hasField(readCloud(folder.file("nuscenes.bin")), "ring"));
  rings.back() = 0.5f;
  writeText(folder.file("kitti.bin"), bytesOfFloats(rings));
  expectSameInBlocks(folder.file("kitti.bin"));
  EXPECT_FALSE(hasField(readCloud(folder.file("kitti.bin")), "ring"));
}

TEST(CloudBlocks, RefuseWhatIsNoRowOfPoints)
{
  const TemporaryFolder folder;
  const auto complaint = [&](const std::string& path) {
    return complaintAbout(path, [&] { CloudBlockReader reader(path); });
  };
  saveCloud(folder.file("a.pcd"), deskScan(), pcd_compressed);
  saveCloud(folder.file("a.ply"), deskScan(), ply_ascii);
  writeText(folder.file("a.npy"), "\x93NUMPY");
  writeText(folder.file("list.ply"),
            "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float "
            "x\nproperty float y\nproperty float z\nproperty list uchar float "
            "l\nend_header\n" +
                std::string(13, '\0'));
  const gzFile packed = gzopen(folder.file("a.gz").c_str(), "wb");
  gzputs(packed, "1 2 3\n");
  gzclose(packed);
  for (const auto& [name, what] : {std::pair("a.pcd", "this PCD file"),
                                   std::pair("a.ply", "this PLY file"),
                                   std::pair("list.ply", "this PLY file"),
                                   std::pair("a.npy", "this NumPy file"),
                                   std::pair("a.gz", "a file packed by gzip")})
    EXPECT_EQ(complaint(folder.file(name)),
              std::string(": ") + what + " cannot be read block by block; " +
                  whatCanBeReadInBlocks() + " can");
  EXPECT_NE(complaint("-"), "none");
  EXPECT_EQ(complaint(folder.file("missing.pcd")), ": there is no such file");
  EXPECT_NE(whatCanBeReadInBlocks().find("a PCD that is not compressed"),
            std::string::npos);
}

/** What is wrong with a text shows before the work, in the words of readCloud(). */
TEST(CloudBlocks, ComplainOfTextAsTheWholeDoes)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("a.xyz");
  for (const char* const text : {"1 2\n",
                                 "1 2 3\n4 5\n",
                                 "1 2 3\n4 5 six\n",
                                 "1 2 3\n4 5 6 7\n",
                                 "3\n1 2 3\n",
                                 "x y y\n1 2 3\n",
                                 "# nothing\n"}) {
    writeText(path, text);
    const std::string expected = complaintAbout(path, [&] { readCloud(path); });
    EXPECT_NE(expected, "none") << text;
    EXPECT_EQ(complaintAbout(path, [&] { CloudBlockReader reader(path); }), expected);
  }
}

/** What is wrong with a file, all at once and in blocks. */
TEST(CloudBlocks, ComplainOfDamageAsTheWholeDoes)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("damaged");
  const auto whole = [&] { return complaintAbout(path, [&] { readCloud(path); }); };
  const auto in_blocks = [&] {
    return complaintAbout(path, [&] {
      CloudBlockReader reader(path, "", setting::scale.initial, 100);
      readInBlocks(reader, 100);
    });
  };
  for (const CloudLayout& layout : {pcd_ascii, pcd_binary, ply_binary}) {
    saveCloud(path, deskScan(), layout);
    const std::string good = readText(path);
    const std::string tail = layout == pcd_ascii ? "1 2 3 4\n" : "odd";
    for (const std::string& bad :
         {good + tail, good.substr(0, 40), good.substr(0, good.size() / 2)}) {
      writeText(path, bad);
      EXPECT_NE(whole(), "none");
      EXPECT_EQ(in_blocks(), whole()) << layout.format << bad.size();
    }
    // Within the camera of a PLY, which is read first then.
    writeText(path, good.substr(0, good.size() - 30));
    EXPECT_NE(in_blocks(), "none");
  }
}

/** Vertices that nothing follows in the file, though it goes on; with and without
 *  something before them. */
TEST(CloudBlocks, ComplainOfBytesAfterTheVertices)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("tail.ply");
  for (const bool has_before : {false, true}) {
    writeText(path,
              std::string("ply\nformat binary_little_endian 1.0\n") +
                  (has_before ? "element before 1\nproperty uchar u\n" : "") +
                  "element vertex 2\nproperty float x\nproperty float y\n"
                  "property float z\nend_header\n" +
                  std::string(24 + 3 + (has_before ? 1 : 0), '\0'));
    const std::string whole = complaintAbout(path, [&] { readCloud(path); });
    EXPECT_NE(
        whole.find("3 bytes left after the last of the 2 rows of element 'vertex'"),
        std::string::npos)
        << whole;
    EXPECT_EQ(complaintAbout(path, [&] { CloudBlockReader reader(path); }), whole);
  }
}

TEST(CloudBlocks, SayWhereTheyAreAndThatAFileHasChanged)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("desk.pcd");
  const LabelledCloud desk = deskScan();
  saveCloud(path, desk, pcd_binary);
  CloudBlockReader reader(path, "", setting::scale.initial, 100);
  LabelledCloud block;
  for (int pass = 0; pass < 2; ++pass, reader.rewind())
    for (std::size_t first = 0; reader.read(block); first += 100)
      EXPECT_EQ(block.first_point, first);
  reader.read(block); // the third time
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(-1, std::ios::end);
  const char last = static_cast<char>(~desk.fields.data.back());
  file.write(&last, 1);
  file.close();
  EXPECT_EQ(complaintAbout(path,
                           [&] {
                             while (reader.read(block))
                               ;
                           }),
            ": has changed while it was read");
}

TEST(CloudBlocks, AreWrittenAsTheWholeIs)
{
  LabelledCloud desk = deskScan();
  setLabels(deskLabels(), LabelType::I4, desk);
  const TemporaryFolder folder;
  const std::string path = folder.file("desk.pcd");
  saveCloud(path, desk, pcd_binary);
  for (const CloudLayout& layout : {pcd_ascii, pcd_binary, ply_ascii, ply_binary})
    for (const std::size_t most :
         {std::size_t{1}, std::size_t{7}, std::size_t{65536}}) {
      std::ostringstream expected;
      writeCloud(expected, desk, layout);
      std::ostringstream stream;
      CloudBlockReader reader(path, "", setting::scale.initial, most);
      CloudBlockWriter writer(stream, reader.head(), layout);
      LabelledCloud block;
      while (reader.read(block))
        writer.write(block);
      writer.finish();
      EXPECT_EQ(stream.str(), expected.str()) << layout.format;
    }
}

TEST(CloudBlocks, KeepTheLayoutWhereItHasRows)
{
  const CloudLayout kitti{"KITTI", CloudEncoding::binary};
  EXPECT_EQ(blockLayoutFor("a.pcd", pcd_ascii), pcd_ascii);
  EXPECT_EQ(blockLayoutFor("a.pcd", pcd_binary), pcd_binary);
  EXPECT_EQ(blockLayoutFor("a.pcd", pcd_compressed), pcd_binary);
  EXPECT_EQ(blockLayoutFor("a.pcd", ply_binary), pcd_binary);
  EXPECT_EQ(blockLayoutFor("a.pcd", kitti), pcd_binary);
  EXPECT_EQ(blockLayoutFor("a.ply", kitti), ply_binary);
  EXPECT_EQ(blockLayoutFor("a.ply", pcd_ascii), ply_ascii);
  EXPECT_THROW(blockLayoutFor("a.xyz", pcd_ascii), CIDException);
}

TEST(CloudBlocks, AreRefusedWhereTheyAreNotTheWhole)
{
  std::ostringstream stream;
  EXPECT_THROW(CloudBlockWriter(stream, deskScan(), pcd_compressed), CIDException);
  CloudBlockWriter writer(stream, deskScan(), pcd_binary);
  writer.write(threePoints());
  EXPECT_THROW(writer.finish(), CIDException);
}

} // namespace
} // namespace pcl_cid::test
