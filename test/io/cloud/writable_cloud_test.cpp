/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Whatever is written can be read, with every value; what cannot be is refused before.
 */

#include "base/random.h"
#include "cloud_files.h"

#include <algorithm>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include <pcl/common/io.h>

namespace pcl_cid::test {
namespace {

constexpr std::size_t points = 5;

/** Names that mean something to a format, or become alike in it. */
const std::vector<std::string> names{
    "_",       "__",       "a",       "a_0",    "a_1",  "a__0", "nx",    "normal_x",
    "ny",      "normal_y", "rgb",     "rgba",   "red",  "blue", "green", "alpha",
    "list",    "label",    "a b",     "",       "a\tb", "f",    "f_0",   "f_1",
    "vertex",  "property", "element", "POINTS", "DATA", "#a",   "count", "f_10",
    "diffuse", "r",        "g",       "b",      "x_0",  "y_",   "z_z",   "\x7F"};

const std::vector<std::uint8_t> datatypes{pcl::PCLPointField::BOOL,
                                          pcl::PCLPointField::INT8,
                                          pcl::PCLPointField::UINT8,
                                          pcl::PCLPointField::INT16,
                                          pcl::PCLPointField::UINT16,
                                          pcl::PCLPointField::INT32,
                                          pcl::PCLPointField::UINT32,
                                          pcl::PCLPointField::INT64,
                                          pcl::PCLPointField::UINT64,
                                          pcl::PCLPointField::FLOAT32,
                                          pcl::PCLPointField::FLOAT64};

std::size_t
sizeOfType(std::uint8_t datatype)
{
  return static_cast<std::size_t>(pcl::getFieldSize(datatype));
}

/** Some fields of random names, types and counts, each value a small whole number. */
LabelledCloud
randomCloud(std::uint64_t seed)
{
  RandomGenerator generator(seed);
  LabelledCloud cloud;
  cloud.name = "random";
  cloud.fields.width = points;
  cloud.fields.height = 1;
  std::vector<std::string> chosen{"x", "y", "z"};
  for (std::uint64_t k = drawBelow(generator, 6); k > 0; --k)
    chosen.push_back(names[drawBelow(generator, names.size())]);
  for (const std::string& name : chosen) {
    pcl::PCLPointField field;
    field.name = name;
    field.datatype = datatypes[drawBelow(generator, datatypes.size())];
    field.count = name.size() == 1 && name >= "x"
                      ? 1
                      : static_cast<std::uint32_t>(1 + drawBelow(generator, 12));
    field.offset = cloud.fields.point_step;
    cloud.fields.point_step +=
        static_cast<std::uint32_t>(field.count * sizeOfType(field.datatype));
    cloud.fields.fields.push_back(field);
  }
  cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
  cloud.fields.data.assign(cloud.fields.row_step, 0);
  for (std::size_t i = 0; i < points; ++i)
    for (const pcl::PCLPointField& field : cloud.fields.fields)
      for (std::uint32_t k = 0; k < field.count; ++k) {
        const std::size_t size = sizeOfType(field.datatype);
        std::uint8_t* const value = cloud.fields.data.data() +
                                    i * cloud.fields.point_step + field.offset +
                                    k * size;
        const auto number = static_cast<std::uint8_t>(drawBelow(generator, 100));
        const float as_float = number;
        const double as_double = number;
        if (field.datatype == pcl::PCLPointField::FLOAT32)
          std::memcpy(value, &as_float, size);
        else if (field.datatype == pcl::PCLPointField::FLOAT64)
          std::memcpy(value, &as_double, size);
        else
          *value = number; // the lowest byte
      }
  return cloud;
}

/** How often each value occurs in a point, whatever its field is called: what PLY makes
 *  of colors is a matter of bytes, so values of these count by their bytes. */
std::map<double, int>
valuesOfPoint(const LabelledCloud& cloud, std::size_t point)
{
  std::map<double, int> values;
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    for (std::uint32_t k = 0; k < field.count; ++k) {
      const std::size_t size = sizeOfType(field.datatype);
      const std::uint8_t* const bytes = cloud.fields.data.data() +
                                        point * cloud.fields.point_step + field.offset +
                                        k * size;
      float as_float = 0.0f;
      double as_double = 0.0;
      std::uint64_t as_number = 0;
      if (field.datatype == pcl::PCLPointField::FLOAT32 && field.name != "rgb") {
        std::memcpy(&as_float, bytes, size);
        ++values[as_float];
      }
      else if (field.datatype == pcl::PCLPointField::FLOAT64) {
        std::memcpy(&as_double, bytes, size);
        ++values[as_double];
      }
      else if (field.name == "rgb" || field.name == "rgba") {
        for (std::size_t b = 0; b < size; ++b)
          ++values[bytes[b]];
      }
      else {
        std::memcpy(&as_number, bytes, size);
        ++values[static_cast<double>(as_number)];
      }
    }
  values.erase(0.0); // PLY has no fourth byte of `rgb`
  return values;
}

bool
hasPackedColor(const LabelledCloud& cloud)
{
  return hasField(cloud, "rgb") || hasField(cloud, "rgba");
}

TEST(WritableCloud, IsReadAgainWithEveryValue)
{
  const TemporaryFolder folder;
  std::size_t written = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const LabelledCloud cloud = randomCloud(seed);
    for (const CloudLayout& layout :
         {pcd_ascii, pcd_binary, pcd_compressed, ply_ascii, ply_binary}) {
      const bool is_ply = layout.format == "PLY";
      const std::string path = folder.file(is_ply ? "cloud.ply" : "cloud.pcd");
      try {
        requireWritable(cloud, path);
      }
      catch (const CIDException&) {
        std::ostringstream stream;
        EXPECT_THROW(writeCloud(stream, cloud, layout), CIDException) << seed;
        continue;
      }
      saveCloud(path, cloud, layout);
      LabelledCloud again;
      ASSERT_NO_THROW(again = readCloud(path)) << seed << layout.format;
      ++written;
      // A packed color of another type than four bytes is none, and its float may be a
      // NaN in text.
      if (hasPackedColor(cloud) || hasPackedColor(again))
        continue;
      for (std::size_t i = 0; i < points; ++i)
        ASSERT_EQ(valuesOfPoint(again, i), valuesOfPoint(cloud, i)) << seed;
    }
  }
  EXPECT_GT(written, 1000u);
}

TEST(WritableCloud, HasNamesThatAFileCanHold)
{
  LabelledCloud cloud = threePoints();
  for (const char* const name : {"_", "", "a b", "a\tb", "\x7F", "x"}) {
    LabelledCloud other = cloud;
    appendField<float>(name, {1, 2, 3}, other.fields);
    for (const char* const path : {"out.pcd", "out.ply"})
      EXPECT_THROW(requireWritable(other, path), CIDException) << name;
  }
  EXPECT_THROW(requireWritable(cloud, "out.txt"), CIDException);
  EXPECT_NO_THROW(requireWritable(cloud, "out.PLY"));
}

TEST(WritableCloud, HasLongIntegersInAPLYWhereDoubleHoldsThem)
{
  LabelledCloud cloud = threePoints();
  appendField<std::uint64_t>("stamp", {1, 2, std::uint64_t{1} << 63}, cloud.fields);
  std::vector<std::string> remarks;
  const auto remark = [&](const std::string& text) { remarks.push_back(text); };
  requireWritable(cloud, "out.pcd", remark);
  EXPECT_TRUE(remarks.empty());
  requireWritable(cloud, "out.ply", remark);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("'stamp'"), std::string::npos);

  const TemporaryFolder folder;
  for (const CloudLayout& layout : {ply_ascii, ply_binary}) {
    saveCloud(folder.file("out.ply"), cloud, layout);
    EXPECT_EQ(valuesOf<double>(readCloud(folder.file("out.ply")).fields, "stamp"),
              (std::vector<double>{1, 2, 0x1p63}));
  }
  for (const std::uint64_t wide : {(std::uint64_t{1} << 53) + 1, UINT64_MAX}) {
    LabelledCloud other = threePoints();
    appendField<std::uint64_t>("stamp", {1, 2, wide}, other.fields);
    EXPECT_THROW(requireWritable(other, "out.ply"), CIDException) << wide;
    EXPECT_NO_THROW(requireWritable(other, "out.pcd")) << wide;
  }
}

} // namespace
} // namespace pcl_cid::test
