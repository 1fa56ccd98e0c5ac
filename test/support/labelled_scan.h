/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the scan generators of the tests return: points with their truth.
 */

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <pcl_cid/core/color.h>

namespace pcl_cid::test {

/** \brief Points with the true instance and class of each; parallel vectors. */
struct LabelledScan {
  /// Metres, in the frame of the room: x, y from a corner of the floor, z up.
  std::vector<Eigen::Vector3f> points;
  /// 1..n, the instance of the scene that the point lies on.
  std::vector<std::uint32_t> instance;
  /// The primitive of the scene that the point lies on.
  std::vector<std::uint32_t> primitive;
  /// The class of that instance, an index into class_names; 0 is "none" and unused.
  std::vector<std::uint8_t> semantic;
  /// "none", then the classes in the order of roomClassNames().
  std::vector<std::string> class_names;
  /// Where the sensor stood, one entry a position; empty for even sampling.
  std::vector<Eigen::Vector3d> sensor_positions;
  /// The position that saw the point; empty for even sampling.
  std::vector<std::uint8_t> sensor;
  /// The color of the point; empty where the room has none.
  std::vector<ColorRGB> colors;
};

} // namespace pcl_cid::test
