/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One line of a file of S3DIS.
 */

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pcl_cid {

/** \brief A point as a file of S3DIS has it.
 *  \tparam Coordinate float or double */
template <typename Coordinate>
struct S3DISPoint {
  Coordinate x = 0;
  Coordinate y = 0;
  Coordinate z = 0;
  /** Packed as PCL does. */
  std::uint32_t rgb = 0;
};

/** \brief The point of a line; none when it is not six numbers, three finite ones and
 *  three from 0 to 255. */
template <typename Coordinate>
std::optional<S3DISPoint<Coordinate>>
parseS3DISLine(std::string_view line);

/** \brief Whether a line holds a control byte other than tabs. */
bool
hasControlByte(std::string_view line);

/** \brief The line with the lost bit (0x20) restored in its control bytes, where that
 *  gives a character of a number or a blank. */
std::string
withLostBits(std::string_view line);

/** \brief For messages: at most 64 bytes of the line, control bytes as \x10. */
std::string
printable(std::string_view line);

} // namespace pcl_cid
