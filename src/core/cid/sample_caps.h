/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Upper bounds of d at all samples of a segment, each from some surface points.
 */

#pragma once

#include "base/rounding.h"
#include "sample_trail.h"
#include "segment_samples.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief An upper bound of d^2 at each sample of a segment.
 *
 *  Any point n of the surface bounds d at all samples at once: d(x) <= |x - n|, and the
 *  square of that is a polynomial of degree 2 along the segment. The smallest of the
 *  bounds of a few points says how far from the surface each sample can be. */
class SampleCaps {
public:
  /** Sentinel: the cap of a sample that needs no further look. */
  static constexpr float settled = -1.0f;

  /** \param[in] storage of the caps, reused since there are millions of segments
   *  \note All three arguments are kept by reference. */
  SampleCaps(const SegmentSamples& segment,
             const SampleOrder& order,
             Eigen::ArrayXf& storage)
  : segment_(segment)
  , order_(order)
  , squared_length_(segment.along.squaredNorm())
  , caps_(storage)
  {
  }

  /** \brief Back to no caps. */
  void
  reset()
  {
    caps_.setConstant(order_.fractions().size(),
                      std::numeric_limits<float>::infinity());
    caps_.tail(order_.fractions().size() - order_.samples()) = settled;
  }

  /** \brief Begin with the caps that a trail of surface points gives. */
  void
  reset(const SampleTrail& trail)
  {
    caps_.resize(order_.fractions().size());
    for (Eigen::Index k = 0; k < caps_.size(); k += SampleOrder::packet) {
      const auto t = Packet::MapAligned(order_.fractions().data() + k);
      Packet squared = Packet::Zero();
      for (int axis = 0; axis < 3; ++axis) {
        const auto point = Packet::MapAligned(trail.coordinates(axis) + k);
        squared += (segment_.from[axis] + segment_.along[axis] * t - point).square();
      }
      Packet::MapAligned(caps_.data() + k) =
          squared * rounding::widening + std::numeric_limits<float>::min();
    }
    caps_.tail(caps_.size() - order_.samples()) = settled;
  }

  /** \brief The cap of a sample: an upper bound of d^2, up to segment.slack. */
  float&
  operator[](std::size_t sample)
  {
    return caps_[static_cast<Eigen::Index>(sample)];
  }

  float
  largest() const
  {
    return caps_.maxCoeff();
  }

  /** \brief The first sample with this cap. */
  std::size_t
  find(float cap) const
  {
    return static_cast<std::size_t>(std::find(caps_.begin(), caps_.end(), cap) -
                                    caps_.begin());
  }

  /** \brief A cap below this shows that d is below a distance. */
  float
  squareOf(float distance) const
  {
    const float certain = std::max(distance - segment_.slack, 0.0f);
    return certain * certain * (1.0f - rounding::of_product);
  }

  /** \brief Lower the caps of the samples near a surface point.
   *  \param[in] sample the one that the point was found at
   *  \param[in] reach how many samples before and after that one */
  void
  lower(const Eigen::Vector3f& point, std::size_t sample, std::size_t reach)
  {
    // At t from 0 to 1 along the segment, |x - n|^2 = a + b t + c t^2; rounding lowers
    // it by less than 16 epsilon (a + c) or, near 0, the smallest normal float.
    const Eigen::Vector3f from = segment_.from - point;
    const float b = 2.0f * segment_.along.dot(from);
    const float c = squared_length_;
    float a = from.squaredNorm();
    a += rounding::ofSquaredDistance(a, c);

    constexpr std::size_t packet = SampleOrder::packet;
    const std::size_t first = sample - std::min(sample, reach);
    const std::size_t last = std::min(sample + reach, order_.last());
    for (std::size_t k = first / packet * packet; k <= last; k += packet) {
      const auto t = Packet::MapAligned(order_.fractions().data() + k);
      auto caps = Packet::MapAligned(caps_.data() + k);
      caps = caps.min(a + t * (b + c * t));
    }
  }

private:
  using Packet = Eigen::Array<float, SampleOrder::packet, 1>;

  const SegmentSamples& segment_;
  const SampleOrder& order_;
  float squared_length_;
  Eigen::ArrayXf& caps_;
};

} // namespace pcl_cid
