/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Name and color of a part.
 */

#include "base/sentence.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>

#include <algorithm>

#include <pcl/common/colors.h>

namespace pcl_cid {
namespace {

/** Of ASCII alone, whatever the locale says. */
bool
isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool
isDigit(char c)
{
  return c >= '0' && c <= '9';
}

/** SDF and MuJoCo have a world of their own. */
bool
isPartsName(const std::string& name)
{
  return !name.empty() && isLetter(name[0]) && name != "world" &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return isLetter(c) || isDigit(c) || c == '_';
         });
}

} // namespace

PartColor
partColor(std::size_t part)
{
  const pcl::RGB color = pcl::GlasbeyLUT::at(part % pcl::GlasbeyLUT::size());
  return {color.r, color.g, color.b};
}

std::string
partName(std::size_t part, const std::string& name)
{
  std::string number = std::to_string(part);
  if (number.size() < 3)
    number.insert(0, 3 - number.size(), '0');
  return (name.empty() ? "part_" : name + "_part_") + number;
}

void
requirePartsName(const std::string& name)
{
  if (!isPartsName(name))
    throw CIDException(
        sentence("the name '",
                 name,
                 "' does not do in every format; it must be letters (a to z), digits "
                 "and underscores, a letter first, and not 'world'"));
}

std::string
partsNameFrom(const std::string& text)
{
  std::string name;
  for (const char c : text)
    if (isLetter(c) || isDigit(c))
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  if (!name.empty() && name.back() == '_')
    name.pop_back();
  if (name.empty())
    return "scan";
  return isPartsName(name) ? name : "scan_" + name;
}

} // namespace pcl_cid
