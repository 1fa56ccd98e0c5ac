/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Settings as options and as parameters of a report: all of it from one row.
 */

#include "run/command_line.h"
#include "run/parameter.h"

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using tools::CommandLine;
using tools::UsageError;

enum class Fruit { pear, apple };

constexpr NumberSetting<int> corners{"Shapes",
                                     "most_corners",
                                     "number of corners",
                                     "N",
                                     "",
                                     0,
                                     3,
                                     9,
                                     "corners",
                                     "for any"};
constexpr NumberSetting<float> width{
    "Shapes", "width", "width", "W", "metres", 0.5f, 0.0f, 2.0f, "how wide it is"};
constexpr ChoiceSetting<Fruit, 2> fruit{
    "Shapes",
    "fruit",
    "F",
    Fruit::apple,
    {{{"pear", Fruit::pear}, {"apple", Fruit::apple}}},
    "pear or apple"};

class SettingOptions : public testing::Test {
protected:
  SettingOptions()
  {
    line_.group("Shapes");
    line_.optional(corners, corners_);
    line_.setting(width, width_, "of no use");
    line_.choice(fruit, fruit_);
  }

  void
  parse(std::vector<const char*> arguments)
  {
    arguments.insert(arguments.begin(), "tool");
    line_.parse(static_cast<int>(arguments.size()), arguments.data(), {}, {});
  }

  /** What is said of a wrong command line. */
  std::string
  complaintAbout(const std::vector<const char*>& arguments)
  {
    try {
      parse(arguments);
    }
    catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }

  CommandLine line_{"tool", "tool [options]", "A tool."};
  std::optional<int> corners_;
  double width_ = width.initial;
  Fruit fruit_ = fruit.initial;
};

TEST_F(SettingOptions, HaveTheDefaultsOfTheirRows)
{
  parse({});
  EXPECT_FALSE(corners_);
  EXPECT_EQ(width_, 0.5);
  EXPECT_EQ(fruit_, Fruit::apple);
}

TEST_F(SettingOptions, TakeNumbersAndWords)
{
  parse({"--most-corners", "9", "--width", "0.02", "--fruit", "pear"});
  EXPECT_EQ(corners_, 9);
  EXPECT_EQ(width_, 0.02); // with the digits of its own type, not of the row's
  EXPECT_EQ(fruit_, Fruit::pear);
}

TEST_F(SettingOptions, RefuseWhatTheirRowsRefuse)
{
  EXPECT_EQ(complaintAbout({"--most-corners", "2"}),
            "--most-corners is '2'; it must be a whole number, 3 to 9");
  EXPECT_EQ(complaintAbout({"--width", "2.5"}),
            "--width is '2.5'; it must be a number of metres, 0 to 2");
  EXPECT_EQ(complaintAbout({"--fruit", "plum"}),
            "--fruit is 'plum'; it must be pear or apple");
}

TEST_F(SettingOptions, AreLeftOutInThePlaceOfZero)
{
  EXPECT_TRUE(corners.allows(0));
  EXPECT_EQ(rangeOf(corners), "a whole number, 3 to 9, or 0 for any");
  EXPECT_NE(complaintAbout({"--most-corners", "0"}), "");
}

TEST_F(SettingOptions, AreExplainedByTheirRows)
{
  testing::internal::CaptureStdout();
  parse({"--help"});
  const std::string help = testing::internal::GetCapturedStdout();
  EXPECT_NE(help.find("--most-corners N"), std::string::npos) << help;
  EXPECT_NE(help.find("how wide it is, metres; of no use;"), std::string::npos) << help;
  EXPECT_NE(help.find("pear or apple; default apple"), std::string::npos) << help;
}

TEST(SettingParameters, HaveNameAndValueByTheRow)
{
  const Report::Parameter number = tools::parameter(corners, 7);
  EXPECT_EQ(number.name, "most_corners");
  EXPECT_EQ(std::get<std::int64_t>(number.value), 7);
  const Report::Parameter left_out = tools::parameter(corners, std::optional<int>());
  EXPECT_TRUE(std::holds_alternative<std::monostate>(left_out.value));
  EXPECT_EQ(std::get<double>(tools::parameter(width, 0.02).value), 0.02);
  EXPECT_EQ(std::get<std::string>(tools::parameter(fruit, Fruit::pear).value), "pear");
}

} // namespace
} // namespace pcl_cid::test
