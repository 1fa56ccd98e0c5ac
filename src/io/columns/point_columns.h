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

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

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

/** \brief What the names and types of columns follow from, of rows of numbers that are
 *  shown one after the other; only a sample is held. */
class ColumnSurvey {
public:
  /** \param[in] columns how many there are
   *  \param[in] are_of_pts see PointColumns
   *  \param[in] points how many rows will be shown */
  ColumnSurvey(std::size_t columns, bool are_of_pts, std::size_t points);

  /** \brief Take the next row.
   *  \param[in] value called with the number of a column */
  template <typename Value>
  void
  take(const Value& value)
  {
    const bool is_sampled = shown_++ % stride_ == 0;
    for (std::size_t k = 0; k < columns_.size(); ++k)
      columns_[k].take(value(k), is_sampled);
    if (triple_ + 3 <= columns_.size())
      takeTriple({value(triple_), value(triple_ + 1), value(triple_ + 2)});
  }

  /** \brief How many columns there are. */
  std::size_t
  columns() const
  {
    return columns_.size();
  }

  /** \brief Whether all values of a column are whole numbers in a range. */
  bool
  isWhole(std::size_t column, double least, double most) const;

  /** \brief Whether a value of a column is above 1. */
  bool
  isAboveOne(std::size_t column) const;

  /** \brief Whether the largest error of float is small beside the extent of the values
   *  of a column. */
  bool
  fitsFloat(std::size_t column) const;

  /** \brief The names of columns that have none, by their order. */
  std::vector<std::string>
  usualNames() const;

private:
  /** The values of one column. */
  struct Column {
    bool are_whole = true;
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
    double float_error = 0.0;
    std::vector<double> sample;

    void
    take(double value, bool is_sampled);
  };

  void
  takeTriple(const Eigen::Vector3d& values);

  std::vector<Column> columns_;
  bool has_intensity_; ///< the fourth of a PTS
  std::size_t triple_; ///< the first of three that may be normals or colors
  std::size_t stride_; ///< of the sample
  std::size_t shown_ = 0;
  bool are_unit_ = true; ///< vectors of length 1
  bool are_bytes_ = true;
  bool are_shares_ = true; ///< of white
};

/** \brief Where the values of a column go in a point. */
struct ColumnTarget {
  std::size_t offset = 0;
  std::uint8_t datatype = 0;
};

/** \brief Make columns the fields of a cloud, as setFields() does, but for the data.
 *  \param[in] names of the columns; empty: there are none
 *  \param[in] survey all points were shown to it
 *  \param[in,out] cloud has its name; gets fields
 *  \return one for each column */
std::vector<ColumnTarget>
defineFields(std::vector<std::string> names,
             const ColumnSurvey& survey,
             LabelledCloud& cloud);

/** \brief Store values of a column.
 *  \param[in] target of the column
 *  \param[in] values so many, every \a step
 *  \param[in] cloud says how long a point is
 *  \param[out] points room for them */
void
storeColumn(const ColumnTarget& target,
            const double* values,
            std::size_t step,
            std::size_t count,
            const LabelledCloud& cloud,
            std::uint8_t* points);

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
setFields(const PointColumns& columns, LabelledCloud& cloud);

} // namespace pcl_cid
