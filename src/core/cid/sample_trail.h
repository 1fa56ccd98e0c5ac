/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Surface points along a segment, for the next segment beside it.
 */

#pragma once

#include "segment_samples.h"

#include <cstddef>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief A surface point for each sample of segments that are next to each other, as
 *  those from a seed to the points of a block: the last one that was found there. What
 *  is near a sample of one segment is near that of the next one. */
class SampleTrail {
public:
  /** \brief Begin anew, with one point at all samples.
   *  \param[in] origin names the point that the segments are from */
  void
  begin(std::size_t origin, const SampleOrder& order, const Eigen::Vector3f& point)
  {
    origin_ = origin;
    is_begun_ = true;
    points_.resize(order.fractions().size(), 3);
    points_.rowwise() = point.transpose().array();
    hint_ = order.last() / 2;
  }

  /** \brief The sample that decided last, see SegmentSearch. */
  std::size_t&
  hint()
  {
    return hint_;
  }

  /** \brief Whether it is of segments from this point. */
  bool
  isFrom(std::size_t origin) const
  {
    return is_begun_ && origin_ == origin;
  }

  void
  set(std::size_t sample, const Eigen::Vector3f& point)
  {
    points_.row(static_cast<Eigen::Index>(sample)) = point.transpose().array();
  }

  /** \brief One of the coordinates at all samples, in packets. */
  const float*
  coordinates(int axis) const
  {
    return points_.col(axis).data();
  }

private:
  Eigen::Array<float, Eigen::Dynamic, 3> points_; ///< by column
  std::size_t origin_ = 0;
  std::size_t hint_ = 0;
  bool is_begun_ = false;
};

} // namespace pcl_cid
