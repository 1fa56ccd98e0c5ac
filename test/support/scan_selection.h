/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Some points of a simulated scan, with all that is known of them.
 */

#pragma once

#include <cstddef>
#include <vector>

#include "labelled_scan.h"

namespace pcl_cid::test {

/** \brief The items of a parallel vector at \a indices; none where it is empty. */
template <typename Item>
std::vector<Item>
selected(const std::vector<Item>& items, const std::vector<std::size_t>& indices)
{
  std::vector<Item> some;
  for (std::size_t i = 0; i < indices.size() && !items.empty(); ++i)
    some.push_back(items[indices[i]]);
  return some;
}

/** \brief The points at \a indices, in this order; all positions of the sensor. */
inline LabelledScan
selected(const LabelledScan& scan, const std::vector<std::size_t>& indices)
{
  LabelledScan some;
  some.points = selected(scan.points, indices);
  some.instance = selected(scan.instance, indices);
  some.primitive = selected(scan.primitive, indices);
  some.semantic = selected(scan.semantic, indices);
  some.class_names = scan.class_names;
  some.sensor_positions = scan.sensor_positions;
  some.sensor = selected(scan.sensor, indices);
  some.colors = selected(scan.colors, indices);
  return some;
}

} // namespace pcl_cid::test
