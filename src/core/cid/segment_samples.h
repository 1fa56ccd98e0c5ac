/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The samples of a segment: in which order to look at them, and where they are in
 * float.
 */

#pragma once

#include "base/rounding.h"
#include <pcl_cid/core/concavity.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_cid {

/** \brief The samples 0 .. M - 1 of a segment by bisection: both ends, the middle, the
 *  quarters, and so on. What is far from the surface is met early, and each sample
 *  after the ends lies between two of earlier levels, whose looks often rule it out. */
class SampleOrder {
public:
  using Level = std::vector<std::size_t>;

  /** Samples that are processed together, by SIMD. */
  static constexpr int packet = 4;

  explicit SampleOrder(int samples)
  : samples_(samples), fractions_((samples + packet - 1) / packet * packet)
  {
    const float share = 1.0f / static_cast<float>(samples - 1);
    for (int l = 0; l < fractions_.size(); ++l)
      fractions_[l] = static_cast<float>(std::min(l, samples - 1)) * share;
    for (std::vector<Gap> gaps = {{0, last()}}; !gaps.empty();)
      gaps = halve(gaps);
  }

  /** \brief M. */
  int
  samples() const
  {
    return samples_;
  }

  /** \brief M - 1, the sample at the far end; that at the near one is 0. */
  std::size_t
  last() const
  {
    return static_cast<std::size_t>(samples_) - 1;
  }

  /** \brief Position of each sample along the segment, 0 to 1; the last one is repeated
   *  to fill the packets. */
  const Eigen::ArrayXf&
  fractions() const
  {
    return fractions_;
  }

  /** \brief All samples but the ends. */
  const std::vector<Level>&
  levels() const
  {
    return levels_;
  }

private:
  /** Two samples of earlier levels, with others between them. */
  struct Gap {
    std::size_t left, right;
  };

  /** A level of the samples in the middle of gaps.
   *  \return the gaps that remain */
  std::vector<Gap>
  halve(const std::vector<Gap>& gaps)
  {
    Level level;
    std::vector<Gap> smaller;
    for (const Gap& gap : gaps) {
      const std::size_t middle = gap.left + (gap.right - gap.left) / 2;
      if (middle == gap.left)
        continue;
      level.push_back(middle);
      smaller.push_back({gap.left, middle});
      smaller.push_back({middle, gap.right});
    }
    if (!level.empty())
      levels_.push_back(std::move(level));
    return smaller;
  }

  int samples_;
  Eigen::ArrayXf fractions_;
  std::vector<Level> levels_;
};

/** \brief A segment in float, for bounds: its samples are near those of
 *  segmentSample(), and `slack` covers the difference. */
struct SegmentSamples {
  Eigen::Vector3f from;
  Eigen::Vector3f along;
  float share;   ///< 1 / (M - 1)
  float spacing; ///< at least the distance of two neighboring samples
  float slack;

  SegmentSamples(const Eigen::Vector3f& p, const Eigen::Vector3f& q, int samples)
  : from(p)
  , along(q - p)
  , share(1.0f / static_cast<float>(samples - 1))
  , spacing(along.norm() * share * rounding::widening)
  , slack(
        rounding::ofSample(std::max(p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff())))
  {
  }

  /** \brief Position of a sample on the way from p to q, 0 to 1. */
  float
  fraction(std::size_t sample) const
  {
    return static_cast<float>(sample) * share;
  }

  Eigen::Vector3f
  at(std::size_t sample) const
  {
    return from + along * fraction(sample);
  }
};

} // namespace pcl_cid
