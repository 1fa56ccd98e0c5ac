/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The samples of a segment: in which order to look at them, and which to pass
 * over.
 */

#pragma once

#include <pcl_cid/core/concavity.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace pcl_cid {

/** \brief The samples 0 .. M - 1 of a segment by bisection: both ends, the middle, the
 *  quarters, and so on. What is far from the surface is met early, and each sample
 *  after the ends lies between two that are known. */
class SampleOrder {
public:
  struct Entry {
    std::size_t sample;
    std::size_t left;  ///< the nearest known sample before it; itself for an end
    std::size_t right; ///< and after it

    bool
    isEnd() const
    {
      return left == right;
    }
  };

  explicit SampleOrder(int samples)
  {
    const auto last = static_cast<std::size_t>(samples - 1);
    entries_.push_back({0, 0, 0});
    entries_.push_back({last, last, last});
    std::queue<std::pair<std::size_t, std::size_t>> open;
    open.push({0, last});
    while (!open.empty()) {
      const auto [left, right] = open.front();
      open.pop();
      if (right - left < 2)
        continue;
      const std::size_t middle = left + (right - left) / 2;
      entries_.push_back({middle, left, right});
      open.push({left, middle});
      open.push({middle, right});
    }
  }

  /** \brief M. */
  int
  samples() const
  {
    return static_cast<int>(entries_.size());
  }

  const std::vector<Entry>&
  entries() const
  {
    return entries_;
  }

private:
  std::vector<Entry> entries_;
};

/** \brief A segment in float, for bounds: its samples are near those of
 *  segmentSample(), and `slack` covers the difference. */
struct SegmentSamples {
  Eigen::Vector3f from;
  Eigen::Vector3f along;
  float share;   ///< 1 / (M - 1)
  float spacing; ///< at least the distance of two neighbouring samples
  float slack;

  SegmentSamples(const Eigen::Vector3f& p, const Eigen::Vector3f& q, int samples)
  : from(p)
  , along(q - p)
  , share(1.0f / static_cast<float>(samples - 1))
  , spacing(along.norm() * share * 1.00001f)
  , slack(8.0f * std::numeric_limits<float>::epsilon() *
          std::max(p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff()))
  {
  }

  /** \brief Where on the way from p to q a sample is, 0 to 1. */
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

  /** \brief An upper bound of d at a sample from bounds at the two that enclose it: d
   *  is 1-Lipschitz, so it is at most the mean of both and of their distance. */
  float
  between(const SampleOrder::Entry& entry, const std::vector<float>& high) const
  {
    return 0.5f * (high[entry.left] + high[entry.right] +
                   spacing * static_cast<float>(entry.right - entry.left));
  }
};

/** \brief pointCID() with the order of the samples at hand. */
float
pointCID(const DistanceField& field,
         const Eigen::Vector3f& p,
         const Eigen::Vector3f& q,
         const SampleOrder& order,
         float limit);

} // namespace pcl_cid
