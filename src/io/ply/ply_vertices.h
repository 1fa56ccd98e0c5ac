/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the properties of vertices become: names, colors, lists.
 */

#pragma once

#include "fields/field_values.h"
#include "ply_header.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief PCL's names of normals, unless these are taken. */
inline std::string
fieldName(const std::string& property, const PLYElement& points)
{
  if (property != "nx" && property != "ny" && property != "nz")
    return property;
  const std::string name = "normal_" + property.substr(1);
  return points.find(name) < 0 ? name : property;
}

/** \brief What holds no values: a PLY by PCL has padding, as a PCD has. */
inline bool
isPadding(const PLYProperty& property)
{
  return property.name == padding_name;
}

/** \brief A list of the vertices: a field with several values when all have the same
 * number.
 */
struct VertexList {
  std::size_t property;
  std::optional<std::uint64_t> length = {};
  bool varies = false;
  std::vector<std::uint8_t> values = {};

  void
  take(const std::uint8_t* bytes, std::uint64_t count, std::size_t value_size)
  {
    varies = varies || count != length.value_or(count);
    length = count;
    if (varies)
      values = {};
    else
      values.insert(values.end(), bytes, bytes + count * value_size);
  }
};

/** \brief Which properties of the vertices make up a packed color; -1 where there is
 * none. */
struct ColorProperties {
  int red = -1;
  int green = -1;
  int blue = -1;
  int alpha = -1;

  explicit ColorProperties(const PLYElement& element)
  {
    if (element.find("rgb") >= 0 || element.find("rgba") >= 0)
      return;
    for (const std::string prefix : {"", "diffuse_"}) {
      if (red >= 0 && green >= 0 && blue >= 0)
        break;
      red = element.find(prefix + "red", pcl::PCLPointField::UINT8);
      green = element.find(prefix + "green", pcl::PCLPointField::UINT8);
      blue = element.find(prefix + "blue", pcl::PCLPointField::UINT8);
    }
    alpha = element.find("alpha", pcl::PCLPointField::UINT8);
  }

  /** \return the byte of the packed color that a property is, -1 when it is none */
  int
  byteOf(int property) const
  {
    if (red < 0 || green < 0 || blue < 0)
      return -1;
    return property == blue    ? 0
           : property == green ? 1
           : property == red   ? 2
           : property == alpha ? 3
                               : -1;
  }
};

} // namespace pcl_cid
