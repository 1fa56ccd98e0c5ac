/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The places of a scan that a robot could use.
 */

#pragma once

#include "base/parallel_for.h"

#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl_cid {

/** \brief Consecutive places of one column: numbers begin, begin + 1, ... */
struct PlaceRange {
  std::uint32_t begin;
  std::uint32_t end;
};

/** \brief A grid of places, of which those are kept that are free: at least a distance
 *  from every point of the scan and, where viewpoints are known, seen free from one of
 *  them.
 *
 *  The places of a column (along z) are runs; kept ones are numbered column by column.
 *  Memory follows the surface and not the volume. */
class FreeSpace {
public:
  /** \param[in] points of the scan, in the frame of \a field
   *  \param[in] clearance least distance from every point, metres
   *  \param[in] viewpoints none: every place counts as seen */
  FreeSpace(const Points& points,
            const DistanceField& field,
            double clearance,
            const std::vector<Eigen::Vector3d>& viewpoints,
            int threads,
            Progress& progress);

  /** \brief Free places. */
  std::size_t
  size() const
  {
    return size_;
  }

  double
  step() const
  {
    return step_;
  }

  /** \brief Cubic metres that a place stands for. */
  double
  placeVolume() const
  {
    return step_ * step_ * step_;
  }

  /** \brief A position on the grid, in places from the first one. */
  Eigen::Vector3d
  toGrid(const Eigen::Vector3d& p) const
  {
    return (turn_.transpose() * p - first_) / step_;
  }

  /** \brief A direction on the grid. */
  Eigen::Vector3d
  turned(const Eigen::Vector3d& direction) const
  {
    return turn_.transpose() * direction;
  }

  const Eigen::Array3i&
  places() const
  {
    return places_;
  }

  /** \brief Call \a visit with the ranges of the free places of a column whose number
   *  along z is from \a low up to below \a high. */
  template <typename Visit>
  void
  forEachRange(int x, int y, int low, int high, const Visit& visit) const
  {
    const std::size_t column =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(places_.x()) +
        static_cast<std::size_t>(x);
    for (std::uint32_t r = column_[column]; r < column_[column + 1]; ++r) {
      const Run& run = runs_[r];
      const int begin = std::max(low, static_cast<int>(run.low));
      const int end = std::min(high, static_cast<int>(run.high));
      if (begin < end)
        visit(PlaceRange{run.number + static_cast<std::uint32_t>(begin - run.low),
                         run.number + static_cast<std::uint32_t>(end - run.low)});
    }
  }

private:
  class Looking;

  struct Run {
    std::int32_t low;     ///< along z
    std::int32_t high;    ///< one past the last
    std::uint32_t number; ///< of the first of its places
  };

  Eigen::Matrix3d turn_;  ///< from the grid to the scan
  Eigen::Vector3d first_; ///< the first place, turned
  double step_;
  Eigen::Array3i places_;
  std::vector<std::uint32_t> column_; ///< the first run of each
  std::vector<Run> runs_;
  std::size_t size_ = 0;
};

} // namespace pcl_cid
