/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Name and color of a part.
 */

#include <pcl_cid/io/mesh_export.h>

#include <pcl/common/colors.h>

namespace pcl_cid {

PartColor
partColor(std::size_t part)
{
  const pcl::RGB color = pcl::GlasbeyLUT::at(part % pcl::GlasbeyLUT::size());
  return {color.r, color.g, color.b};
}

std::string
partName(std::size_t part)
{
  std::string number = std::to_string(part);
  if (number.size() < 3)
    number.insert(0, 3 - number.size(), '0');
  return "part_" + number;
}

} // namespace pcl_cid
