/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colours as people tell them apart.
 */

#pragma once

#include <pcl_cid/core/nearest_neighbors.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief A colour of sRGB, 8 bits a channel. */
struct ColorRGB {
  std::uint8_t r;
  std::uint8_t g;
  std::uint8_t b;
};

/** \brief A colour as PCL's fields `rgb` and `rgba` hold it, whatever type they are
 * said to have: 0xAARRGGBB. */
inline ColorRGB
unpackColor(std::uint32_t packed)
{
  return {static_cast<std::uint8_t>(packed >> 16),
          static_cast<std::uint8_t>(packed >> 8),
          static_cast<std::uint8_t>(packed)};
}

/** \brief CIE L*a*b* of a colour, for the white of sRGB (D65): L* is 0 to 100.
 *
 *  The difference of two colours is about their Euclidean distance here; 2.3 can just
 *  be seen. */
PCL_CID_EXPORT Eigen::Vector3f
labOf(const ColorRGB& color);

/** \brief L*a*b* of each point, as the mean over itself and its neighbours: a sensor's
 *  colours are noisy, and the surfaces of things are larger than nine points.
 *  \param[in] colors of the points
 *  \param[in] neighbors of the points */
PCL_CID_EXPORT std::vector<Eigen::Vector3f>
smoothLab(const std::vector<ColorRGB>& colors, const NearestNeighbors& neighbors);

} // namespace pcl_cid
