/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The places of a scan that a robot could use.
 */

#include "free_space.h"

#include "seen_space.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_cid {
namespace {

constexpr double usual_places = 1 << 20;
constexpr double most_places = 1 << 24;
constexpr double most_places_a_side = 2048.0;

/** Fine enough for the clearance, and for the scan as a whole, but not finer than a
 * robot that is large next to the scan needs. */
double
stepFor(const Eigen::AlignedBox3d& box, double clearance)
{
  const double volume = box.volume();
  return std::max({std::min(clearance / 3.0, std::cbrt(volume / usual_places)),
                   clearance / 12.0,
                   std::cbrt(volume / most_places),
                   box.sizes().maxCoeff() / most_places_a_side});
}

/** Floors and walls stand upright and square; no layer of places is parallel to one, or
 *  a wall that is a little thicker would take a whole layer or nothing. */
Eigen::Matrix3d
unlikelyTurn()
{
  return Eigen::AngleAxisd(0.5, Eigen::Vector3d(1.0, 0.7, 0.4).normalized())
      .toRotationMatrix();
}

/** Numbers along a column of places: from low up to below high. */
struct ColumnPart {
  int low;
  int high;
};

/** Where a column is inside of a box, and a place more at either end, where rounding
 *  may decide: flat scans have long columns of which hardly anything is inside. */
ColumnPart
partInside(const Eigen::AlignedBox3d& box,
           const Eigen::Vector3d& first,
           const Eigen::Vector3d& step,
           int places)
{
  double low = 0.0;
  double high = places;
  for (int axis = 0; axis < 3; ++axis) {
    const double to_min = (box.min()[axis] - first[axis]) / step[axis];
    const double to_max = (box.max()[axis] - first[axis]) / step[axis];
    low = std::max(low, std::min(to_min, to_max) - 1.0);
    high = std::min(high, std::max(to_min, to_max) + 2.0);
  }
  if (!(low < high))
    return {0, 0};
  return {static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high))};
}

} // namespace

/** Tells which places are free, and finds them along a column. */
class FreeSpace::Looking {
public:
  Looking(const FreeSpace& space,
          const Eigen::AlignedBox3d& box,
          const DistanceField& field,
          double clearance,
          const SeenSpace& seen)
  : space_(space), box_(box), field_(field), clearance_(clearance), seen_(seen)
  {
  }

  /** Add the runs of free places of a column. */
  void
  along(std::size_t x, std::size_t y, std::vector<Run>& runs) const
  {
    const Eigen::Vector3d first =
        space_.turn_ *
        (space_.first_ + space_.step_ * Eigen::Vector3d(static_cast<double>(x),
                                                        static_cast<double>(y),
                                                        0.0));
    const Eigen::Vector3d step = space_.step_ * space_.turn_.col(2);
    const ColumnPart inside = partInside(box_, first, step, space_.places_.z());
    bool is_in_run = false;
    for (int z = inside.low; z < inside.high; ++z) {
      const bool is_free = isFree(first + static_cast<double>(z) * step);
      if (is_free && !is_in_run)
        runs.push_back({z, z, 0});
      if (is_free)
        runs.back().high = z + 1;
      is_in_run = is_free;
    }
  }

private:
  bool
  isFree(const Eigen::Vector3d& place) const
  {
    if (!box_.contains(place))
      return false;
    const Eigen::Vector3f x = place.cast<float>();
    const DistanceBounds bounds = field_.bounds(x);
    if (static_cast<double>(bounds.high) < clearance_)
      return false;
    return (static_cast<double>(bounds.low) >= clearance_ ||
            static_cast<double>(field_.distance(x)) >= clearance_) &&
           seen_.isSeen(place);
  }

  const FreeSpace& space_;
  const Eigen::AlignedBox3d& box_;
  const DistanceField& field_;
  double clearance_;
  const SeenSpace& seen_;
};

FreeSpace::FreeSpace(const Points& points,
                     const DistanceField& field,
                     double clearance,
                     const std::vector<Eigen::Vector3d>& viewpoints,
                     int threads,
                     Progress& progress)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : points)
    box.extend(p.cast<double>());
  step_ = stepFor(box, clearance);
  turn_ = unlikelyTurn();
  Eigen::AlignedBox3d turned;
  for (int corner = 0; corner < 8; ++corner)
    turned.extend(turn_.transpose() *
                  box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  first_ = turned.min().array() + 0.5 * step_;
  places_ = (turned.sizes() / step_).array().ceil().cast<int>().max(1);
  const SeenSpace seen(points, viewpoints, step_);
  const Looking looking(*this, box, field, clearance, seen);
  const auto rows = static_cast<std::size_t>(places_.y());
  const auto columns = static_cast<std::size_t>(places_.x());
  std::vector<std::vector<Run>> runs(rows);
  column_.assign(rows * columns + 1, 0);
  parallelForEach(rows, threads, progress, {}, [&](std::size_t y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const std::size_t before = runs[y].size();
      looking.along(x, y, runs[y]);
      column_[y * columns + x + 1] =
          static_cast<std::uint32_t>(runs[y].size() - before);
    }
  });
  std::partial_sum(column_.begin(), column_.end(), column_.begin());
  for (const std::vector<Run>& of_row : runs)
    for (Run run : of_row) {
      run.number = static_cast<std::uint32_t>(size_);
      size_ += static_cast<std::size_t>(run.high - run.low);
      runs_.push_back(run);
    }
}

} // namespace pcl_cid
