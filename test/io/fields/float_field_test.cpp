/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Float fields: values as they are, all else as it was.
 */

#include "cloud_files.h"

#include <pcl_cid/io/float_field.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

std::vector<float>
valuesForDesk()
{
  std::vector<float> values;
  for (std::size_t i = 0; i < deskScan().size(); ++i)
    values.push_back(0.1f * static_cast<float>(i));
  values[3] = std::numeric_limits<float>::quiet_NaN();
  return values;
}

void
expectSame(const std::vector<float>& found, const std::vector<float>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_TRUE(found[i] == expected[i] ||
                (std::isnan(found[i]) && std::isnan(expected[i])))
        << i;
}

TEST(SetFloats, AppendsAndKeepsEverythingElse)
{
  LabelledCloud cloud = deskScan();
  const LabelledCloud before = cloud;
  setFloats(valuesForDesk(), "cid", cloud);
  EXPECT_EQ(cloud.fields.fields.back().name, "cid");
  expectSame(valuesOf<float>(cloud.fields, "cid"), valuesForDesk());
  for (const char* const name : {"x", "y", "z", "rgb"})
    EXPECT_EQ(bytesOf(cloud.fields, name), bytesOf(before.fields, name));
  EXPECT_EQ(cloud.fields.width, before.fields.width);
  EXPECT_EQ(cloud.fields.height, before.fields.height);
}

TEST(SetFloats, ReplacesAFieldOfAnotherTypeInItsPlace)
{
  LabelledCloud cloud = deskScan();
  appendField("cid", std::vector<std::uint8_t>(cloud.size(), 9), cloud.fields);
  appendField("stamp", std::vector<double>(cloud.size(), 0.25), cloud.fields);
  const std::size_t fields = cloud.fields.fields.size();
  setFloats(valuesForDesk(), "cid", cloud);
  ASSERT_EQ(cloud.fields.fields.size(), fields);
  EXPECT_EQ(cloud.fields.fields[fields - 2].name, "cid");
  expectSame(valuesOf<float>(cloud.fields, "cid"), valuesForDesk());
  EXPECT_EQ(valuesOf<double>(cloud.fields, "stamp"),
            std::vector<double>(cloud.size(), 0.25));
}

TEST(SetFloats, RefusesAnotherNumberAndCoordinates)
{
  LabelledCloud cloud = deskScan();
  const LabelledCloud before = cloud;
  EXPECT_THROW(setFloats({1.0f, 2.0f}, "cid", cloud), CIDException);
  EXPECT_THROW(setFloats(valuesForDesk(), "y", cloud), CIDException);
  EXPECT_EQ(cloud.fields.data, before.fields.data);
}

} // namespace
} // namespace pcl_cid::test
