/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels and coordinates of clouds.
 */

#include "cloud_files.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

LabelledCloud
threePoints()
{
  LabelledCloud cloud;
  cloud.name = "three.pcd";
  appendField<float>("x", {0, 1, std::nanf("")}, cloud.fields);
  appendField<float>("y", {0, 0, 0}, cloud.fields);
  appendField<float>("z", {1, 1, 1}, cloud.fields);
  return cloud;
}

template <typename Value>
class LabelField : public testing::Test {
};

using LabelTypes = testing::Types<std::int8_t,
                                  std::uint8_t,
                                  std::int16_t,
                                  std::uint16_t,
                                  std::int32_t,
                                  std::uint32_t,
                                  std::int64_t,
                                  std::uint64_t,
                                  float,
                                  double>;
TYPED_TEST_SUITE(LabelField, LabelTypes);

TYPED_TEST(LabelField, IsConvertedByItsType)
{
  LabelledCloud cloud = threePoints();
  appendField<TypeParam>("truth", {0, 117, 5}, cloud.fields);
  EXPECT_EQ(labelsOf(cloud, "truth", pointsOf(cloud)),
            (std::vector<std::uint32_t>{0, 117, 0}));
}

template <typename Value>
std::string
complaintAbout(Value value)
{
  LabelledCloud cloud = threePoints();
  appendField<Value>("truth", {1, value, 5}, cloud.fields);
  try {
    labelsOf(cloud, "truth", pointsOf(cloud));
  }
  catch (const CIDException& error) {
    return error.what();
  }
  return "";
}

TEST(HasField, IsAboutTheWholeName)
{
  const LabelledCloud cloud = threePoints();
  EXPECT_TRUE(hasField(cloud, "x"));
  EXPECT_FALSE(hasField(cloud, "xy"));
  EXPECT_FALSE(hasField(cloud, ""));
}

TEST(FinitePoints, KeepTheirIndices)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.emplace_back(1.0f, 2.0f, 3.0f);
  cloud.emplace_back(std::nanf(""), 0.0f, 0.0f);
  cloud.emplace_back(4.0f, 5.0f, 6.0f);
  const PointSet points = finitePoints(cloud);
  EXPECT_EQ(points.source, (pcl::Indices{0, 2}));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ((points.points[1].cast<double>() + points.origin),
            Eigen::Vector3d(4, 5, 6));
}

TEST(LabelsOf, RefusesWhatIsNoLabel)
{
  EXPECT_NE(complaintAbout<std::int8_t>(-1).find("point 1 is -1"), std::string::npos);
  EXPECT_NE(complaintAbout<std::int32_t>(-7).find("is -7"), std::string::npos);
  EXPECT_NE(complaintAbout(1.5f).find("is 1.5"), std::string::npos);
  EXPECT_NE(complaintAbout(std::nan("")).find("nan"), std::string::npos);
  EXPECT_NE(complaintAbout(4294967296.0), "");
  EXPECT_NE(complaintAbout(std::numeric_limits<float>::infinity()), "");
  EXPECT_NE(complaintAbout(std::uint64_t{4294967296}), "");
  EXPECT_EQ(complaintAbout(std::uint64_t{4294967295}), "");
  EXPECT_EQ(complaintAbout(4294967295.0), "");
}

TEST(LabelsOf, AcceptsAnythingAtInvalidPoints)
{
  LabelledCloud cloud = threePoints();
  appendField<float>("truth", {1, 2, std::nanf("")}, cloud.fields);
  EXPECT_EQ(labelsOf(cloud, "truth", pointsOf(cloud)),
            (std::vector<std::uint32_t>{1, 2, 0}));
}

TEST(LabelsOf, NamesTheFieldsThatThereAre)
{
  const LabelledCloud cloud = threePoints();
  try {
    labelsOf(cloud, "class", pointsOf(cloud));
    FAIL() << "there is no such field";
  }
  catch (const CIDException& error) {
    EXPECT_STREQ(error.what(),
                 "three.pcd: has no field 'class'; its fields are x, y, z");
  }
}

TEST(LabelsOf, RefusesFieldsWithSeveralValues)
{
  LabelledCloud cloud = threePoints();
  appendField<std::uint64_t>("pair", {1, 2, 3}, cloud.fields);
  cloud.fields.fields.back().datatype = pcl::PCLPointField::UINT32;
  cloud.fields.fields.back().count = 2;
  EXPECT_THROW(labelsOf(cloud, "pair", pointsOf(cloud)), CIDException);
}

template <typename Value>
class ColorField : public testing::Test {
};

using ColorTypes = testing::Types<float, std::uint32_t, std::int32_t>;
TYPED_TEST_SUITE(ColorField, ColorTypes);

/// The colours are 0xAARRGGBB, whatever type the file says they have.
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
    FAIL() << "there are no colours";
  }
  catch (const CIDException& error) {
    EXPECT_STREQ(error.what(),
                 "three.pcd: has no colours, in a field 'rgb' or 'rgba'; its fields "
                 "are x, y, z");
  }
}

TEST(ColorsOf, RefusesOtherSizes)
{
  LabelledCloud cloud = threePoints();
  appendField<std::uint8_t>("rgb", {1, 2, 3}, cloud.fields);
  EXPECT_THROW(colorsOf(cloud), CIDException);
}

TEST(SetLabels, AppendsAField)
{
  LabelledCloud cloud = deskScan();
  const LabelledCloud before = cloud;
  setLabels(deskLabels(), LabelType::U4, cloud);
  ASSERT_EQ(cloud.fields.fields.size(), 5u);
  EXPECT_EQ(cloud.fields.fields.back().name, "label");
  EXPECT_EQ(valuesOf<std::uint32_t>(cloud.fields, "label"), deskLabels());
  for (const char* const name : {"x", "y", "z", "rgb"})
    EXPECT_EQ(bytesOf(cloud.fields, name), bytesOf(before.fields, name));
  EXPECT_EQ(cloud.fields.width, before.fields.width);
  EXPECT_EQ(cloud.fields.height, before.fields.height);
}

TEST(SetLabels, ReplacesAFieldOfAnotherTypeInItsPlace)
{
  LabelledCloud cloud = threePoints();
  appendField<std::uint8_t>("label", {9, 9, 9}, cloud.fields);
  appendField<double>("stamp", {0.1, 0.2, 0.3}, cloud.fields);
  const std::vector<std::uint32_t> labels{70000, 1, 0};
  setLabels(labels, LabelType::U4, cloud);
  ASSERT_EQ(cloud.fields.fields.size(), 5u);
  EXPECT_EQ(cloud.fields.fields[3].name, "label");
  EXPECT_EQ(cloud.fields.point_step, 24u);
  EXPECT_EQ(valuesOf<std::uint32_t>(cloud.fields, "label"), labels);
  EXPECT_EQ(valuesOf<double>(cloud.fields, "stamp"),
            (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(valuesOf<float>(cloud.fields, "z"), (std::vector<float>{1, 1, 1}));
}

TEST(SetLabels, TakesAnotherNameThanLabel)
{
  LabelledCloud cloud = threePoints();
  setLabels({1, 2, 3}, LabelType::U4, cloud);
  setLabels({9, 9, 9}, LabelType::U4, cloud, "semantic");
  setLabels({7, 8, 9}, LabelType::U4, cloud, "semantic");
  EXPECT_EQ(cloud.fields.fields.size(), 5u);
  EXPECT_EQ(valuesOf<std::uint32_t>(cloud.fields, "label"),
            (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(valuesOf<std::uint32_t>(cloud.fields, "semantic"),
            (std::vector<std::uint32_t>{7, 8, 9}));
}

TEST(SetLabels, WritesTheTypeThatWasAskedFor)
{
  LabelledCloud cloud = threePoints();
  setLabels({3, 2, 16777216}, LabelType::F4, cloud);
  EXPECT_EQ(valuesOf<float>(cloud.fields, "label"),
            (std::vector<float>{3, 2, 16777216}));
  setLabels({3, 2, 2147483647}, LabelType::I4, cloud);
  EXPECT_EQ(valuesOf<std::int32_t>(cloud.fields, "label"),
            (std::vector<std::int32_t>{3, 2, 2147483647}));
  EXPECT_EQ(cloud.fields.fields.back().datatype, pcl::PCLPointField::INT32);
}

TEST(SetLabels, RefusesWhatDoesNotFit)
{
  LabelledCloud cloud = threePoints();
  const LabelledCloud before = cloud;
  EXPECT_THROW(setLabels({0, 0, 16777217}, LabelType::F4, cloud), CIDException);
  EXPECT_THROW(setLabels({0, 0, 2147483648u}, LabelType::I4, cloud), CIDException);
  EXPECT_THROW(setLabels({0, 0}, LabelType::U4, cloud), CIDException);
  EXPECT_EQ(cloud.fields.data, before.fields.data);
  EXPECT_EQ(cloud.fields.fields.size(), before.fields.fields.size());
}

TEST(PointsOf, TakesAnOffsetOutOfDoubleCoordinates)
{
  const std::vector<double> x{500000.001, 500000.002, 500001.5, std::nan("")};
  const std::vector<double> y{4100000.25, 4100000.251, 4100002.0, 0.0};
  const std::vector<double> z{120.0, 120.001, 121.0, 0.0};
  LabelledCloud cloud;
  appendField("x", x, cloud.fields);
  appendField("y", y, cloud.fields);
  appendField("z", z, cloud.fields);
  const CloudPoints points = pointsOf(cloud);
  EXPECT_EQ(points.finite, 3u);
  EXPECT_FALSE(points.points->is_dense);
  for (std::size_t i = 0; i < points.finite; ++i) {
    const Eigen::Vector3d back =
        (*points.points)[i].getVector3fMap().cast<double>() + points.offset;
    EXPECT_NEAR(back.x(), x[i], 1e-6);
    EXPECT_NEAR(back.y(), y[i], 1e-6);
    EXPECT_NEAR(back.z(), z[i], 1e-6);
  }
}

TEST(PointsOf, LeavesFloatAndSmallCoordinatesAlone)
{
  EXPECT_TRUE(pointsOf(deskScan()).offset.isZero(0.0));
  LabelledCloud cloud;
  appendField<double>("x", {-1, 2}, cloud.fields);
  appendField<double>("y", {0, 3}, cloud.fields);
  appendField<double>("z", {1, 1}, cloud.fields);
  EXPECT_TRUE(pointsOf(cloud).offset.isZero(0.0));
}

TEST(PointsOf, CountsFinitePoints)
{
  const CloudPoints points = pointsOf(deskScan());
  std::size_t labelled = 0;
  for (const std::uint32_t label : deskLabels())
    labelled += label != 0 ? 1 : 0;
  EXPECT_EQ(points.finite, labelled);
  EXPECT_EQ(points.points->width, 40u);
  EXPECT_EQ(points.points->height, 30u);
}

} // namespace
} // namespace pcl_cid::test
