/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Names that somebody may have meant.
 */

#include "near_names.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

constexpr std::size_t most_names = 3;
constexpr std::size_t shortest_part = 3; // letters; shorter ones are in anything

std::string
inSmallLetters(std::string text)
{
  for (char& letter : text)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

/** Letters to change, add or take away to make one of the other (Levenshtein). */
std::size_t
changesBetween(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

bool
isPartOf(const std::string& part, const std::string& whole)
{
  return part.size() >= shortest_part && whole.find(part) != std::string::npos;
}

bool
isNear(const std::string& a, const std::string& b, std::size_t changes)
{
  return isPartOf(a, b) || isPartOf(b, a) ||
         changes <= (std::min(a.size(), b.size()) + 1) / 3;
}

} // namespace

std::vector<std::string>
nearNames(const std::string& name, const std::vector<std::string>& names)
{
  const std::string meant = inSmallLetters(name);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const std::string& each : names) {
    const std::string small = inSmallLetters(each);
    const std::size_t changes = changesBetween(meant, small);
    if (isNear(meant, small, changes))
      found.emplace_back(changes, each);
  }
  std::sort(found.begin(), found.end());
  found.resize(std::min(found.size(), most_names));
  std::vector<std::string> nearest;
  for (const auto& each : found)
    nearest.push_back(each.second);
  return nearest;
}

} // namespace pcl_cid
