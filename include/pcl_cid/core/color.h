/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors of points.
 */

#pragma once

#include <cstdint>

namespace pcl_cid {

/** \brief A color of sRGB, 8 bits a channel. */
struct ColorRGB {
  std::uint8_t r;
  std::uint8_t g;
  std::uint8_t b;
};

/** \brief A color as PCL's fields `rgb` and `rgba` hold it, whatever type they are said
 *  to have: 0xAARRGGBB. */
inline ColorRGB
unpackColor(std::uint32_t packed)
{
  return {static_cast<std::uint8_t>(packed >> 16),
          static_cast<std::uint8_t>(packed >> 8),
          static_cast<std::uint8_t>(packed)};
}

} // namespace pcl_cid
