/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan as a worse sensor would have seen it.
 */

#include "perturbation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>

#include <pcl_cid/exceptions.h>

#include "portable_draw.h"

namespace pcl_cid::test {
namespace {

using Field = pcl::PCLPointField;

Field
coordinateOf(const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  for (const Field& field : cloud.fields)
    if (field.name == name && field.count == 1 &&
        (field.datatype == Field::FLOAT32 || field.datatype == Field::FLOAT64))
      return field;
  throw CIDException("the cloud has no field " + name +
                     " of one float or double a point, which is needed");
}

template <typename Value>
void
addTo(std::uint8_t* bytes, double amount)
{
  Value value;
  std::memcpy(&value, bytes, sizeof(Value));
  value = static_cast<Value>(value + amount);
  std::memcpy(bytes, &value, sizeof(Value));
}

void
move(std::uint8_t* point, const Field& coordinate, double amount)
{
  if (coordinate.datatype == Field::FLOAT32)
    addTo<float>(point + coordinate.offset, amount);
  else
    addTo<double>(point + coordinate.offset, amount);
}

} // namespace

pcl::PCLPointCloud2
perturbed(const pcl::PCLPointCloud2& cloud, const Perturbation& perturbation)
{
  const std::array<Field, 3> coordinates{
      coordinateOf(cloud, "x"), coordinateOf(cloud, "y"), coordinateOf(cloud, "z")};
  RandomGenerator generator(perturbation.seed);
  pcl::PCLPointCloud2 result = cloud;
  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint8_t* const point = &result.data[kept * cloud.point_step];
    std::copy_n(&cloud.data[i * cloud.point_step], cloud.point_step, point);
    for (const Field& coordinate : coordinates) {
      const double shift = perturbation.noise * drawNormal(generator);
      if (shift != 0.0) // or the bits of -0 and NaN would change
        move(point, coordinate, shift);
    }
    if (drawUnit(generator) < perturbation.keep)
      ++kept;
  }
  if (kept == 0)
    throw CIDException("none of the cloud's " + std::to_string(count) +
                       " points is kept; a greater fraction keeps some");
  if (kept < count) {
    result.width = static_cast<std::uint32_t>(kept);
    result.height = 1;
    result.row_step = result.point_step * result.width;
    result.data.resize(kept * result.point_step);
  }
  return result;
}

} // namespace pcl_cid::test
