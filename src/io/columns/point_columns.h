/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Columns of numbers as the fields of a cloud.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Points that a cloud can have. */
constexpr std::uint64_t most_points = std::numeric_limits<std::int32_t>::max();

/** \brief What a file without types says of its points: numbers in columns. */
struct PointColumns {
  /** One for each column; empty where the file names none. */
  std::vector<std::string> names;
  /** The values of each column. */
  std::vector<std::vector<double>> values;
  /** Whether columns without names are those of a PTS: x y z intensity r g b. */
  bool are_of_pts = false;
  std::uint32_t width = 0;
  std::uint32_t height = 1;
};

/** \brief The name of a field that means what a column's name means: `x` for "X" and
 *  for ParaView's "Points:0", `red` for "R", `normal_x` for "Nx". Other names stay, but
 *  for their blanks, which become '_'. */
std::string
fieldNameOf(const std::string& column);

/** \brief Whether names, as of fields, say which columns are x, y and z. */
bool
namesCoordinates(const std::vector<std::string>& names);

/** \brief Make the columns the fields of a cloud.
 *
 *  Columns without names are named by their order: x y z; then nx ny nz where these are
 *  vectors of length 1, r g b where they are whole numbers from 0 to 255, or numbers
 * from 0 to 1, intensity where there are four columns or five, nx ny nz where three are
 * left. Others become `column_4`, by their number from 1. A remark says which.
 *
 *  The type of a field follows from its values: whole numbers become 32-bit integers,
 *  others float, or double where float would be too coarse. Colors of 8 bits become
 *  `rgb`.
 *  \param[in,out] cloud has its name; gets fields, width and height
 *  \throws CIDException when x, y or z is missing or two columns have one name */
void
setFields(PointColumns columns, LabelledCloud& cloud);

} // namespace pcl_cid
