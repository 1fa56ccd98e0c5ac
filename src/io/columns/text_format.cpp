/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading text: all points at once, or block by block.
 */

#include "column_formats.h"
#include "point_columns.h"
#include "text_points.h"

#include <algorithm>
#include <cstdint>
#include <istream>
#include <memory>
#include <vector>

namespace pcl_cid {
namespace {

void
readText(std::istream& stream, std::uint64_t, LabelledCloud& cloud)
{
  TextPoints points(stream, cloud);
  PointColumns columns;
  columns.values.resize(points.columns());
  while (points.next())
    for (std::size_t k = 0; k < columns.values.size(); ++k)
      columns.values[k].push_back(points.row()[k]);
  points.requireCount();
  columns.names = points.names();
  columns.are_of_pts = points.areOfPTS();
  columns.width = static_cast<std::uint32_t>(points.points());
  setFields(columns, cloud);
}

/** Tells how far a text that is read twice was read. */
struct Telling {
  std::istream& stream;
  std::uint64_t size; ///< of the file
  const ProgressCallback& progress;

  /** Now and then.
   *  \param[in] points so far
   *  \param[in] begin 0 the first time, 0.5 the second */
  void
  tell(std::size_t points, double begin) const
  {
    constexpr std::size_t seldom = 1 << 16;
    if (!progress || points % seldom != 0)
      return;
    const auto at = static_cast<double>(
        std::max(std::streamoff{0}, std::streamoff(stream.tellg())));
    if (!progress(begin + 0.5 * std::min(1.0, at / static_cast<double>(size))))
      throw CIDCancelled();
  }
};

/** A text block by block. What its columns are follows from all of its values, so it is
 *  read twice before: to count the points, and to look at them. */
class TextRows : public CloudRows {
public:
  TextRows(std::istream& stream, LabelledCloud& head, const Telling& telling)
  : points_(stream, head), cloud_(head)
  {
    while (points_.pass())
      telling.tell(points_.points(), 0.0);
    const std::size_t count = points_.points();
    ColumnSurvey survey(points_.columns(), points_.areOfPTS(), count);
    points_.begin();
    while (points_.next()) {
      survey.take([&](std::size_t k) { return points_.row()[k]; });
      telling.tell(points_.points(), 0.5);
    }
    points_.requireCount();
    head.fields.width = static_cast<std::uint32_t>(count);
    head.fields.height = 1;
    targets_ = defineFields(points_.names(), survey, head);
    head.fields.row_step = head.fields.point_step * head.fields.width;
  }

  void
  begin() override
  {
    points_.begin();
  }

  void
  read(std::size_t count, std::uint8_t* points) override
  {
    std::vector<double> values;
    values.reserve(count * points_.columns());
    for (std::size_t i = 0; i < count; ++i) {
      if (!points_.next())
        failForChange();
      values.insert(values.end(), points_.row().begin(), points_.row().end());
    }
    std::fill_n(points, count * cloud_.fields.point_step, std::uint8_t{0});
    for (std::size_t k = 0; k < targets_.size(); ++k)
      storeColumn(
          targets_[k], values.data() + k, targets_.size(), count, cloud_, points);
  }

  void
  end() override
  {
    if (points_.pass())
      failForChange();
  }

private:
  [[noreturn]] void
  failForChange() const
  {
    throw CIDException(cloud_.name + ": has changed while it was read");
  }

  TextPoints points_;
  LabelledCloud& cloud_;
  std::vector<ColumnTarget> targets_;
};

std::unique_ptr<CloudRows>
streamText(std::istream& stream,
           std::uint64_t size,
           LabelledCloud& head,
           const ProgressCallback& progress)
{
  return std::make_unique<TextRows>(stream, head, Telling{stream, size, progress});
}

} // namespace

CloudFormat
textFormat()
{
  CloudFormat format;
  format.name = "text";
  format.extensions = {".xyz", ".xyzn", ".xyzrgb", ".txt", ".csv", ".pts", ".asc"};
  format.is_of_scans_only = false;
  format.read = readText;
  format.streams = "text";
  format.stream = streamText;
  return format;
}

} // namespace pcl_cid
