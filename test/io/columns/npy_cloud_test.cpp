/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds from arrays of NumPy. What NumPy itself writes: parsers/.
 */

#include "cloud_files.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

std::string
npy(const std::string& header, const std::string& body, char version = 1)
{
  const auto length = static_cast<std::uint32_t>(header.size());
  std::string text = std::string("\x93NUMPY") + version + '\0';
  for (int byte = 0; byte < (version == 1 ? 2 : 4); ++byte)
    text += static_cast<char>(length >> 8 * byte & 0xFF);
  return text + header + body;
}

template <typename Value>
std::string
bytesOfValues(const std::vector<Value>& values)
{
  return std::string(reinterpret_cast<const char*>(values.data()),
                     values.size() * sizeof(Value));
}

std::string
header(const std::string& type, const std::string& shape, const char* fortran = "False")
{
  return "{'descr': " + type + ", 'fortran_order': " + fortran + ", 'shape': " + shape +
         ", }   \n";
}

class NpyCloud : public testing::Test {
protected:
  LabelledCloud
  read(const std::string& content)
  {
    writeText(path_, content);
    return readCloud(path_);
  }

  std::string
  complaint(const std::string& content)
  {
    writeText(path_, content);
    return complaintAbout(path_, [&] { readCloud(path_); });
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("a.npy");
};

TEST_F(NpyCloud, HasARowForEachPoint)
{
  for (const char version : {'\1', '\2', '\3'}) {
    const LabelledCloud cloud =
        read(npy(header("'<f8'", "(2, 3)"),
                 bytesOfValues<double>({1, 2, 3, 4.5, 5.5, 6.5}),
                 version));
    EXPECT_EQ(cloud.size(), 2u);
    EXPECT_EQ(valuesOf<float>(cloud.fields, "y"), (std::vector<float>{2.0f, 5.5f}));
  }
  const LabelledCloud far =
      read(npy(header("'<f8'", "(2, 3)"),
               bytesOfValues<double>({691234.001, 2, 3, 691239.004, 5.5, 6.5})));
  EXPECT_EQ(valuesOf<double>(far.fields, "x").at(1), 691239.004);
}

TEST_F(NpyCloud, IsReadInEitherOrder)
{
  const std::vector<float> rows{1, 2, 3, 4, 5, 6};
  const std::vector<float> columns{1, 4, 2, 5, 3, 6};
  std::string swapped;
  for (const float value : rows) {
    std::string bytes = bytesOfValues<float>({value});
    std::reverse(bytes.begin(), bytes.end());
    swapped += bytes;
  }
  for (const std::string& content :
       {npy(header("'<f4'", "(2, 3)"), bytesOfValues(rows)),
        npy(header("'<f4'", "(2, 3)", "True"), bytesOfValues(columns)),
        npy(header("'>f4'", "(2, 3)"), swapped)}) {
    const LabelledCloud cloud = read(content);
    EXPECT_EQ(valuesOf<float>(cloud.fields, "x"), (std::vector<float>{1, 4}));
    EXPECT_EQ(valuesOf<float>(cloud.fields, "z"), (std::vector<float>{3, 6}));
  }
}

TEST_F(NpyCloud, KeepsTheShapeOfAnImage)
{
  std::vector<float> values;
  for (int i = 0; i < 2 * 3 * 3; ++i)
    values.push_back(static_cast<float>(i));
  const LabelledCloud cloud =
      read(npy(header("'<f4'", "(2, 3, 3)"), bytesOfValues(values)));
  EXPECT_EQ(cloud.fields.height, 2u);
  EXPECT_EQ(cloud.fields.width, 3u);
  EXPECT_EQ(valuesOf<float>(cloud.fields, "x"),
            (std::vector<float>{0, 3, 6, 9, 12, 15}));

  std::vector<float> fortran(values.size());
  for (std::size_t y = 0; y < 2; ++y)
    for (std::size_t x = 0; x < 3; ++x)
      for (std::size_t k = 0; k < 3; ++k)
        fortran[y + 2 * (x + 3 * k)] = values[3 * (3 * y + x) + k];
  EXPECT_EQ(read(npy(header("'<f4'", "(2, 3, 3)", "True"), bytesOfValues(fortran)))
                .fields.data,
            cloud.fields.data);
}

TEST_F(NpyCloud, KeepsNamedFields)
{
  std::string body;
  for (const int i : {1, 2}) {
    body += bytesOfValues<float>({1.0f * static_cast<float>(i), 2.0f, 3.0f});
    body += bytesOfValues<std::uint8_t>({9, 8, 7});
    body += bytesOfValues<std::int64_t>({-70000 * i});
  }
  const LabelledCloud cloud = read(npy(
      header("[('xyz', '<f4', (3,)), ('rgb', '|u1', 3), ('id number', '<i8')]", "(2,)"),
      body));
  EXPECT_EQ(valuesOf<float>(cloud.fields, "x"), (std::vector<float>{1, 2}));
  EXPECT_EQ(colorsOf(cloud)[1].r, 9);
  EXPECT_EQ(colorsOf(cloud)[1].b, 7);
  EXPECT_EQ(valuesOf<std::int32_t>(cloud.fields, "id_number"),
            (std::vector<std::int32_t>{-70000, -140000}));
}

TEST_F(NpyCloud, IsRefusedWhereItIsNoCloud)
{
  const std::string six = bytesOfValues<float>({1, 2, 3, 4, 5, 6});
  EXPECT_NE(complaint(npy(header("'<f4'", "(6,)"), six)).find("shape 6"),
            std::string::npos);
  EXPECT_NE(complaint(npy(header("'<f4'", "(3, 2)"), six)).find("3 x 2"),
            std::string::npos);
  EXPECT_NE(complaint(npy(header("'<f4'", "(3, 3)"), six)).find("need 36"),
            std::string::npos);
  EXPECT_NE(complaint(npy(header("'<f4'", "(1, 3)"), six)).find("need 12"),
            std::string::npos);
  EXPECT_NE(complaint(npy(header("'<c8'", "(2, 3)"), six)).find("'<c8'"),
            std::string::npos);
  EXPECT_NE(complaint(npy(header("'<U4'", "(2, 3)"), six)).find("'<U4'"),
            std::string::npos);
  EXPECT_NE(complaint(npy(header("'<f4'", "(0, 3)"), "")).find("no points"),
            std::string::npos);
  EXPECT_NE(complaint(npy("{'descr': '<f4'}", six)).find("damaged"), std::string::npos);
  EXPECT_NE(complaint(npy("[(", six)).find("damaged"), std::string::npos);
  EXPECT_NE(
      complaint(npy(header("[('u', '<f4'), ('v', '<f4'), ('w', '<f4')]", "(2,)"), six))
          .find("columns u, v and w"),
      std::string::npos);
  EXPECT_NE(complaint(npy(header("'<f4'", "(99999999999, 3)"), six)).find("at most"),
            std::string::npos);
  EXPECT_NE(complaint(npy(header("'<f4'", "(2, 3)"), six, 9)).find("format 9"),
            std::string::npos);
}

TEST_F(NpyCloud, IsRefusedWhereItsSizesOverflow)
{
  for (const char* const shape :
       {"(2305843009213693951,)", "(4294967296, 4294967296)", "(-1,)"})
    EXPECT_NE(
        complaint(npy(
            header(std::string("[('x', '<f8'), ('a', '<f8', ") + shape + ")]", "(1,)"),
            "")),
        "none");
  EXPECT_NE(complaint(npy(header("'<f4'", "(-60, 3)"), "")).find("which is none"),
            std::string::npos);
}

TEST_F(NpyCloud, IsRefusedWhereverItIsCut)
{
  const std::string whole =
      npy(header("'<f4'", "(2, 3)"), bytesOfValues<float>({1, 2, 3, 4, 5, 6}));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(complaint(whole.substr(0, size)), "none") << size;
  EXPECT_EQ(complaint(whole), "none");
}

} // namespace
} // namespace pcl_cid::test
