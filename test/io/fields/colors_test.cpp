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

#include <cmath>
#include <limits>

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
    EXPECT_TRUE(hasColors(cloud));
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
  EXPECT_FALSE(hasColors(threePoints()));
  try {
    colorsOf(threePoints());
    FAIL() << "there are no colors";
  }
  catch (const CIDException& error) {
    EXPECT_STREQ(error.what(),
                 "three.pcd: has no colors, in a field 'rgb' or 'rgba', or in fields "
                 "'red', 'green' and 'blue'; its fields are x, y, z");
  }
}

template <typename Value>
LabelledCloud
withChannels(const std::vector<std::string>& names,
             const std::vector<Value>& red,
             const std::vector<Value>& green,
             const std::vector<Value>& blue)
{
  LabelledCloud cloud = threePoints();
  appendField(names[0], red, cloud.fields);
  appendField(names[1], green, cloud.fields);
  appendField(names[2], blue, cloud.fields);
  return cloud;
}

/// The third point is not finite, so its color does not matter.
void
expectChannels(const LabelledCloud& cloud)
{
  const std::vector<ColorRGB> colors = colorsOf(cloud);
  ASSERT_EQ(colors.size(), 3u);
  EXPECT_EQ(colors[0].r, 255);
  EXPECT_EQ(colors[0].g, 0);
  EXPECT_EQ(colors[0].b, 51);
  EXPECT_EQ(colors[1].r, 0);
  EXPECT_EQ(colors[1].g, 255);
  EXPECT_EQ(colors[1].b, 102);
}

TEST(ColorsOf, MayStandInThreeFieldsOfAnyType)
{
  const float nan = std::nanf("");
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"r", "g", "b"},
        {"Red", "Green", "Blue"},
        {"red", "green", "blue"},
        {"diffuse_red", "diffuse_green", "diffuse_blue"}}) {
    expectChannels(
        withChannels<std::uint8_t>(names, {255, 0, 9}, {0, 255, 9}, {51, 102, 9}));
    expectChannels(withChannels<std::uint16_t>(
        names, {65535, 0, 9}, {0, 65535, 9}, {13107, 26214, 9}));
    expectChannels(
        withChannels<float>(names, {1, 0, nan}, {0, 1, nan}, {0.2f, 0.4f, nan}));
    expectChannels(
        withChannels<double>(names, {255, 0, -9}, {0, 255, 1e9}, {51, 102, nan}));
    expectChannels(
        withChannels<std::int32_t>(names, {255, 0, -9}, {0, 255, 999}, {51, 102, 9}));
  }
}

TEST(ColorsOf, RefusesChannelsOutOfRange)
{
  const float inf = std::numeric_limits<float>::infinity();
  for (const float bad : {-0.5f, 256.0f, inf, -inf, std::nanf("")})
    EXPECT_THROW(colorsOf(withChannels<float>(
                     {"r", "g", "b"}, {1, bad, 0}, {0, 0, 0}, {0, 0, 0})),
                 CIDException)
        << bad;
}

TEST(ColorsOf, RefusesOtherSizes)
{
  LabelledCloud cloud = threePoints();
  appendField<std::uint8_t>("rgb", {1, 2, 3}, cloud.fields);
  EXPECT_THROW(colorsOf(cloud), CIDException);
}

} // namespace
} // namespace pcl_cid::test
