/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The table of settings, and the page that shows it.
 */

#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** What 0 means is a part of the meaning, unless the range says it. */
template <typename Value>
std::string
withZero(const NumberSetting<Value>& setting)
{
  const bool is_in_range = setting.least <= Value{0};
  return setting.zero && is_in_range
             ? std::string(setting.meaning) + "; 0 " + setting.zero
             : setting.meaning;
}

/** The default, and the paper's where it is another. */
template <typename Value>
std::string
defaultOf(const NumberSetting<Value>& setting)
{
  std::ostringstream text;
  text << setting.initial;
  if (setting.paper() != setting.initial)
    text << " (the paper: " << setting.paper() << ")";
  return text.str();
}

template <typename Value, std::size_t Count>
std::string
defaultOf(const ChoiceSetting<Value, Count>& setting)
{
  const std::string text = setting.wordOf(setting.initial);
  if (setting.paper() == setting.initial)
    return text;
  return text + " (the paper: " + setting.wordOf(setting.paper()) + ")";
}

/** A row as text. */
struct Row {
  std::string group;
  std::string name;
  std::string placeholder;
  std::string initial;
  std::string range;
  std::string unit;
  std::string meaning;
};

template <typename Value>
Row
rowOf(const NumberSetting<Value>& setting)
{
  return {setting.group,
          setting.name,
          setting.placeholder,
          defaultOf(setting),
          rangeOf(setting),
          setting.unit,
          withZero(setting)};
}

template <typename Value, std::size_t Count>
Row
rowOf(const ChoiceSetting<Value, Count>& setting)
{
  std::string words;
  for (const auto& each : setting.words)
    words += (words.empty() ? "" : ", ") + std::string(each.word);
  return {setting.group,
          setting.name,
          setting.placeholder,
          defaultOf(setting),
          words,
          "",
          setting.meaning};
}

std::vector<Row>
allRows()
{
  std::vector<Row> rows;
  forEachSetting([&](const auto& setting) { rows.push_back(rowOf(setting)); });
  return rows;
}

template <typename Value>
void
expectSound(const NumberSetting<Value>& setting)
{
  SCOPED_TRACE(setting.name);
  EXPECT_LE(setting.least, setting.most);
  EXPECT_TRUE(setting.allows(setting.initial));
  EXPECT_TRUE(setting.allows(setting.least));
  EXPECT_TRUE(setting.allows(setting.most));
  EXPECT_TRUE(setting.allows(setting.paper()));
  EXPECT_EQ(setting.allows(Value{0}), setting.least <= Value{0} || setting.zero);
  EXPECT_FALSE(std::string(setting.title).empty());
  EXPECT_NO_THROW(require(setting, setting.initial));
  if constexpr (std::is_floating_point_v<Value>) {
    EXPECT_FALSE(setting.allows(std::numeric_limits<Value>::quiet_NaN()));
    EXPECT_FALSE(setting.allows(std::numeric_limits<Value>::infinity()));
    EXPECT_THROW(require(setting, std::numeric_limits<Value>::quiet_NaN()),
                 CIDException);
  }
  if constexpr (std::is_signed_v<Value>) {
    EXPECT_FALSE(setting.allows(Value{-1}));
    EXPECT_THROW(require(setting, Value{-1}), CIDException);
  }
}

template <typename Value, std::size_t Count>
void
expectSound(const ChoiceSetting<Value, Count>& setting)
{
  SCOPED_TRACE(setting.name);
  std::set<std::string> words;
  for (const auto& each : setting.words) {
    EXPECT_TRUE(words.insert(each.word).second) << each.word;
    EXPECT_STREQ(setting.wordOf(each.value), each.word) << "two words for one value";
  }
  EXPECT_STRNE(setting.wordOf(setting.initial), "") << "the default has no word";
  EXPECT_STRNE(setting.wordOf(setting.paper()), "") << "the paper's has no word";
}

TEST(Settings, RowsAreSound)
{
  forEachSetting([](const auto& setting) { expectSound(setting); });
  std::set<std::string> names;
  for (const Row& row : allRows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " stands twice";
    EXPECT_TRUE(std::regex_match(row.name, std::regex("[a-z]+(_[a-z]+)*"))) << row.name;
    EXPECT_FALSE(row.group.empty()) << row.name;
    EXPECT_FALSE(row.placeholder.empty()) << row.name;
    ASSERT_FALSE(row.meaning.empty()) << row.name;
    EXPECT_NE(row.meaning.back(), '.')
        << row.name << ": one sentence, without its stop";
  }
}

TEST(Settings, GroupsStandTogether)
{
  std::vector<std::string> groups;
  for (const Row& row : allRows())
    if (groups.empty() || groups.back() != row.group)
      groups.push_back(row.group);
  EXPECT_EQ(std::set<std::string>(groups.begin(), groups.end()).size(), groups.size());
}

std::string
textOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_FALSE(text.str().empty()) << path;
  return text.str();
}

/** Who visits the rows must not miss one that was added. */
TEST(Settings, EveryRowIsVisited)
{
  const std::string header = textOf(PCL_CID_SETTINGS_HEADER);
  const std::regex row(R"(inline constexpr (Number|Choice)Setting<[^>]*>\s+(\w+)\{)");
  std::set<std::string> written;
  for (std::sregex_iterator it(header.begin(), header.end(), row), end; it != end; ++it)
    written.insert((*it)[2]);
  std::set<std::string> visited;
  for (const Row& each : allRows())
    visited.insert(each.name);
  EXPECT_EQ(written, visited) << "a row's variable has its name";
}

template <typename Value>
std::string
refusal(const NumberSetting<Value>& setting, Value value)
{
  try {
    require(setting, value);
  }
  catch (const CIDException& error) {
    return error.what();
  }
  return "";
}

void
expectContains(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(Settings, RefusalsSayNameValueAndRange)
{
  expectContains(refusal(setting::seeds, 0),
                 "the number of seeds is 0; it must be a whole number, at least 1");
  expectContains(
      refusal(setting::samples, 1),
      "the number of samples on a segment is 1; it must be a whole number, 2 "
      "to 1048576");
  expectContains(refusal(setting::subsample, -1),
                 "the subsample is -1; it must be a whole number, 0 or more");
  expectContains(
      refusal(setting::coverage, -0.5f),
      "the coverage is -0.5; it must be a number of metres above 0, or 0 for no "
      "limit");
  expectContains(refusal(setting::density_power, 5.0f),
                 "the density power is 5; it must be a number, 0 to 4");
  expectContains(refusal(setting::max_vertices, 3),
                 "the largest number of vertices is 3; it must be a whole number, at "
                 "least 4, or 0 for any number");
  expectContains(refusal(setting::threads, 1025u),
                 "the number of threads is 1025; it must be a whole number, 0 to 1024");
  EXPECT_EQ(refusal(setting::max_vertices, 0), "");
}

/** These do nothing until they are given; what their rows start from is of no meaning.
 */
bool
isOffUntilGiven(const std::string& name)
{
  return name == "start_index" || name == "parts" || name == "threshold" ||
         name == "merges" || name == "max_error";
}

std::string
escaped(const std::string& text)
{
  return std::regex_replace(text, std::regex(R"([*|])"), R"(\$&)");
}

/** Headlines and tables of the page, line by line. */
std::vector<std::string>
expectedLines()
{
  std::vector<std::string> lines;
  std::string group;
  for (const Row& row : allRows()) {
    if (row.group != group) {
      group = row.group;
      lines.insert(lines.end(),
                   {"## " + group,
                    "| Option | Default | Range | Unit | Meaning |",
                    "|---|---|---|---|---|"});
    }
    std::string option = "--" + row.name + " " + row.placeholder;
    std::replace(option.begin(), option.end(), '_', '-');
    const std::string initial = isOffUntilGiven(row.name) ? "none" : row.initial;
    lines.push_back("| `" + option + "` | " + initial + " | " + row.range + " | " +
                    row.unit + " | " + escaped(row.meaning) + " |");
  }
  return lines;
}

TEST(Settings, PageShowsTheTable)
{
  std::istringstream page(textOf(PCL_CID_SETTINGS_PAGE));
  std::vector<std::string> lines;
  for (std::string line; std::getline(page, line);)
    if (line.rfind("## ", 0) == 0 || line.rfind("|", 0) == 0)
      lines.push_back(line);
  std::string expected;
  for (const std::string& line : expectedLines())
    expected += (line.rfind("## ", 0) == 0 ? "\n" + line + "\n\n" : line + "\n");
  EXPECT_EQ(lines, expectedLines()) << "doc/settings.md should have:\n" << expected;
}

} // namespace
} // namespace pcl_cid::test
