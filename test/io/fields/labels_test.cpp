/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels of clouds: read from any field, written as one.
 */

#include "cloud_files.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

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
complaintAboutValue(Value value)
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

TEST(LabelsOf, RefusesWhatIsNoLabel)
{
  EXPECT_NE(complaintAboutValue<std::int8_t>(-2).find("point 1 is -2"),
            std::string::npos);
  EXPECT_NE(complaintAboutValue<std::int32_t>(-7).find("is -7"), std::string::npos);
  EXPECT_NE(complaintAboutValue(1.5f).find("is 1.5"), std::string::npos);
  EXPECT_NE(complaintAboutValue(4294967296.0), "");
  EXPECT_NE(complaintAboutValue(std::numeric_limits<float>::infinity()), "");
  EXPECT_NE(complaintAboutValue(std::uint64_t{4294967296}), "");
  EXPECT_EQ(complaintAboutValue(std::uint64_t{4294967295}), "");
  EXPECT_EQ(complaintAboutValue(4294967295.0), "");
}

template <typename Value>
void
expectNone(Value none)
{
  LabelledCloud cloud = threePoints();
  appendField<Value>("truth", {none, 7, none}, cloud.fields);
  std::vector<std::string> remarks;
  EXPECT_EQ(labelsOf(cloud,
                     "truth",
                     pointsOf(cloud),
                     [&](const std::string& text) { remarks.push_back(text); }),
            (std::vector<std::uint32_t>{0, 7, 0}));
  EXPECT_EQ(remarks,
            std::vector<std::string>{"three.pcd: field 'truth' is -1 or NaN for 1 "
                                     "point; taken as label 0"});
}

TEST(LabelsOf, TakesMinusOneAndNaNForNone)
{
  expectNone<std::int8_t>(-1);
  expectNone<std::int64_t>(-1);
  expectNone(-1.0f);
  expectNone(std::nan(""));
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

} // namespace
} // namespace pcl_cid::test
