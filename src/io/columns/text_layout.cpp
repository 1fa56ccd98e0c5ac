/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How the lines of a text are divided into cells.
 */

#include "text_layout.h"

#include "text/words.h"

#include <algorithm>

namespace pcl_cid {
namespace {

/** Without blanks and one pair of quotes around it. */
std::string_view
bare(std::string_view cell)
{
  const auto trim = [&cell] {
    while (!cell.empty() && static_cast<unsigned char>(cell.front()) <= ' ')
      cell.remove_prefix(1);
    while (!cell.empty() && static_cast<unsigned char>(cell.back()) <= ' ')
      cell.remove_suffix(1);
  };
  trim();
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    cell = cell.substr(1, cell.size() - 2);
    trim();
  }
  return cell;
}

/** "1,5 2 3,25": one comma at most in a word, and digits on both sides of it. */
bool
hasDecimalCommas(std::string_view line)
{
  bool any = false;
  std::size_t words = 0;
  for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
    const auto commas = std::count(word.begin(), word.end(), ',');
    if (commas > 1 || word.front() == ',' || word.back() == ',')
      return false;
    any = any || commas == 1;
    ++words;
  }
  return any && words >= 3;
}

/** Whether tabs separate the cells: else they are blanks like others. */
bool
isOfTabs(std::string_view line)
{
  if (line.find('\t') == std::string_view::npos)
    return false;
  const std::vector<std::string> cells = cellsOf(line, '\t');
  return std::none_of(cells.begin(), cells.end(), [](const std::string& cell) {
    return cell.find(' ') != std::string::npos;
  });
}

} // namespace

char
separatorOf(std::string_view line)
{
  const auto has = [line](char c) { return line.find(c) != std::string_view::npos; };
  if (has(';'))
    return ';';
  if (has(',') && !hasDecimalCommas(line))
    return ',';
  return isOfTabs(line) ? '\t' : ' ';
}

std::optional<std::string_view>
takeCell(std::string_view& line, char separator)
{
  if (separator == ' ') {
    const std::string_view word = takeWord(line);
    return word.empty() ? std::nullopt : std::optional(bare(word));
  }
  if (!line.data())
    return std::nullopt;
  std::size_t begin = line.find_first_not_of(' ');
  if (begin < line.size() && line[begin] == '"')
    begin = line.find('"', begin + 1);
  const std::size_t end =
      begin < line.size() ? line.find(separator, begin) : std::string_view::npos;
  const std::string_view cell = bare(line.substr(0, end));
  line = end == std::string_view::npos ? std::string_view() : line.substr(end + 1);
  return cell;
}

std::vector<std::string>
cellsOf(std::string_view line, char separator)
{
  std::vector<std::string> cells;
  while (const std::optional<std::string_view> cell = takeCell(line, separator))
    cells.emplace_back(*cell);
  return cells;
}

} // namespace pcl_cid
