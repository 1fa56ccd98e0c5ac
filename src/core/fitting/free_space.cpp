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

namespace pcl_cid {
namespace {

constexpr double usual_places = 1 << 20;
constexpr double most_places = 1 << 24;
constexpr double most_places_a_side = 2048.0;

/** Fine enough for the clearance, and for the scan as a whole. */
double
stepFor(const Eigen::AlignedBox3d& box, double clearance)
{
  const double volume = box.volume();
  return std::max({std::min(clearance / 3.0, std::cbrt(volume / usual_places)),
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

} // namespace

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

  const auto isFree = [&](const Eigen::Vector3d& on_grid) {
    const Eigen::Vector3d place = turn_ * on_grid;
    if (!box.contains(place))
      return false;
    const Eigen::Vector3f x = place.cast<float>();
    const DistanceBounds bounds = field.bounds(x);
    if (static_cast<double>(bounds.high) < clearance)
      return false;
    return (static_cast<double>(bounds.low) >= clearance ||
            static_cast<double>(field.distance(x)) >= clearance) &&
           seen.isSeen(place);
  };
  const auto rows = static_cast<std::size_t>(places_.y());
  const auto columns = static_cast<std::size_t>(places_.x());
  std::vector<std::vector<Run>> runs(rows * columns);
  parallelFor(rows, 1, threads, progress, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin * columns; c < end * columns; ++c) {
      Eigen::Vector3d place = first_;
      place.x() += step_ * static_cast<double>(c % columns);
      place.y() += step_ * static_cast<double>(c / columns);
      bool inside = false;
      for (int z = 0; z < places_.z(); ++z) {
        place.z() = first_.z() + step_ * z;
        if (!isFree(place)) {
          inside = false;
          continue;
        }
        if (!inside)
          runs[c].push_back({z, z, 0});
        runs[c].back().high = z + 1;
        inside = true;
      }
    }
  });
  for (const std::vector<Run>& of_column : runs) {
    column_.push_back(static_cast<std::uint32_t>(runs_.size()));
    for (Run run : of_column) {
      run.number = static_cast<std::uint32_t>(size_);
      size_ += static_cast<std::size_t>(run.high - run.low);
      runs_.push_back(run);
    }
  }
  column_.push_back(static_cast<std::uint32_t>(runs_.size()));
}

} // namespace pcl_cid
