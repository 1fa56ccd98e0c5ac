/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors of clouds.
 */

#include "cloud_files.h"

#include <cstring>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

template <typename Value>
class ColorField : public testing::Test {
};

using ColorTypes = testing::Types<float, std::uint32_t, std::int32_t>;
TYPED_TEST_SUITE(ColorField, ColorTypes);

/// The colors are 0xAARRGGBB, whatever type the file says they have.
TYPED_TEST(ColorField, IsUnpacked)
{
  std::vector<TypeParam> packed(3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t color = 0x80010203 + (i << 16);
    std::memcpy(&packed[i], &color, sizeof(color));
  }
  for (const char* const name : {"rgb", "rgba"}) {
    LabelledCloud cloud = threePoints();
    appendField(name, packed, cloud.fields);
    const std::vector<ColorRGB> colors = colorsOf(cloud);
    ASSERT_EQ(colors.size(), 3u);
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      EXPECT_EQ(colors[at].r, 1 + i);
      EXPECT_EQ(colors[at].g, 2);
      EXPECT_EQ(colors[at].b, 3);
    }
  }
}

TEST(ColorsOf, NamesTheFieldsThatThereAre)
{
  try {
    colorsOf(threePoints());
    FAIL() << "there are no colors";
  }
  catch (const CIDException& error) {
    EXPECT_STREQ(error.what(),
                 "three.pcd: has no colors, in a field 'rgb' or 'rgba'; its fields "
                 "are x, y, z");
  }
}

TEST(ColorsOf, RefusesOtherSizes)
{
  LabelledCloud cloud = threePoints();
  appendField<std::uint8_t>("rgb", {1, 2, 3}, cloud.fields);
  EXPECT_THROW(colorsOf(cloud), CIDException);
}

} // namespace
} // namespace pcl_cid::test
