/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Perceptual colors, CIE L*a*b*.
 */

#include "lab_color.h"

#include <array>
#include <cmath>

#include <pcl/common/colors.h>

namespace pcl_cid {
namespace {

/** The curve of CIE 15: a cube root, and a line near 0. (PCL's XYZ2LAB_LUT has 4,000
 *  steps, so a* is wrong by up to 1 in the dark, and a line that does not meet the
 *  root.) */
double
lightness(double share_of_white)
{
  constexpr double knee = 6.0 / 29.0;
  if (share_of_white > knee * knee * knee)
    return std::cbrt(share_of_white);
  return share_of_white / (3.0 * knee * knee) + 4.0 / 29.0;
}

} // namespace

Eigen::Vector3f
labOf(const ColorRGB& color)
{
  // Despite its name, this is the curve from sRGB to linear light.
  static const std::array<double, 256> linear = pcl::RGB2sRGB_LUT<double>();
  static const Eigen::Matrix3d to_xyz = // IEC 61966-2-1
      (Eigen::Matrix3d() << 0.4124,
       0.3576,
       0.1805, //
       0.2126,
       0.7152,
       0.0722, //
       0.0193,
       0.1192,
       0.9505)
          .finished();
  static const Eigen::Vector3d white = to_xyz.rowwise().sum();
  const Eigen::Vector3d light(linear[color.r], linear[color.g], linear[color.b]);
  const Eigen::Vector3d xyz = (to_xyz * light).cwiseQuotient(white);
  const double x = lightness(xyz.x());
  const double y = lightness(xyz.y());
  const double z = lightness(xyz.z());
  return Eigen::Vector3d(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
      .cast<float>();
}

std::vector<Eigen::Vector3f>
smoothLab(const std::vector<ColorRGB>& colors, const NearestNeighbors& neighbors)
{
  std::vector<Eigen::Vector3f> lab;
  lab.reserve(colors.size());
  for (const ColorRGB& color : colors)
    lab.push_back(labOf(color));
  std::vector<Eigen::Vector3f> smooth(lab);
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    for (std::size_t k = 0; k < neighbors.nearCount(); ++k)
      smooth[i] += lab[static_cast<std::size_t>(neighbors.neighbor(i, k))];
    smooth[i] /= static_cast<float>(1 + neighbors.nearCount());
  }
  return smooth;
}

} // namespace pcl_cid
