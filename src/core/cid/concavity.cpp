/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Concavity-Induced Distance of two points and of two groups: Eq. 1 to 3.
 */

#include "base/infinity.h"
#include "base/progress.h"
#include "base/rounding.h"
#include "base/sentence.h"
#include "segment_search.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <vector>

namespace pcl_cid {
namespace {

/** A stretch of the segment between two samples whose distances are known. */
struct Stretch {
  int begin;
  int end;
  float at_begin;
  float at_end;
  float bound; ///< no sample inside has a larger distance

  bool
  operator<(const Stretch& other) const
  {
    return bound < other.bound;
  }
};

/** A 1-Lipschitz function with the values a and b at two places nowhere exceeds (a + b
 *  + length) / 2 between them; \a slack covers the rounding of all four. */
float
lipschitzBound(float a, float b, float length, float slack)
{
  return 0.5f * (a + b + length) + slack;
}

/** What rounding may add to a difference of two distances on this segment: the sample
 *  positions, the distances and the bound are each good to a few units in the last
 *  place of the largest number in them. */
float
roundingSlack(const Eigen::Vector3f& p, const Eigen::Vector3f& q, float distance)
{
  const float magnitude =
      std::max(p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff()) + distance;
  return rounding::ofSample(magnitude);
}

/** The largest distance over the samples, best first: look next where a larger one is
 *  still possible, until none can exceed the largest so far by more than \a
 *  tolerance. */
float
largestDistance(const DistanceField& field,
                const Eigen::Vector3f& p,
                const Eigen::Vector3f& q,
                int samples,
                float tolerance)
{
  const int last = samples - 1;
  const float length = (q - p).norm();
  const float step = length / static_cast<float>(last);
  const float at_p = field.distance(segmentSample(p, q, 0, samples));
  const float at_q = field.distance(segmentSample(p, q, last, samples));
  const float slack = roundingSlack(p, q, std::max(at_p, at_q) + length);

  float largest = std::max(at_p, at_q);
  std::vector<Stretch> open;
  const auto push = [&](int begin, int end, float at_begin, float at_end) {
    const float inside = step * static_cast<float>(end - begin);
    const float bound = lipschitzBound(at_begin, at_end, inside, slack);
    if (end - begin >= 2 && bound > largest + tolerance) {
      open.push_back({begin, end, at_begin, at_end, bound});
      std::push_heap(open.begin(), open.end());
    }
  };
  push(0, last, at_p, at_q);
  while (!open.empty()) {
    std::pop_heap(open.begin(), open.end());
    const Stretch widest = open.back();
    open.pop_back();
    if (widest.bound <= largest + tolerance)
      break;
    const int middle = widest.begin + (widest.end - widest.begin) / 2;
    const float at_middle = field.distance(segmentSample(p, q, middle, samples));
    largest = std::max(largest, at_middle);
    push(widest.begin, middle, widest.at_begin, at_middle);
    push(middle, widest.end, at_middle, widest.at_end);
  }
  return largest;
}

} // namespace

float
pointCID(const DistanceField& field,
         const Eigen::Vector3f& p,
         const Eigen::Vector3f& q,
         int samples,
         float limit)
{
  std::size_t middle = static_cast<std::size_t>(samples) / 2;
  const SampleOrder order(samples);
  return SegmentSearch(field, order).pointCID({p, q, false}, limit, middle); // Eq. 2
}

float
continuousPointCID(const DistanceField& field,
                   const Eigen::Vector3f& p,
                   const Eigen::Vector3f& q,
                   float tolerance)
{
  if (!(tolerance > 0.0f))
    throw CIDException(sentence("the tolerance of the continuous CID is ",
                                tolerance,
                                "; it must be above 0 metres"));
  // Eq. 1: half of the tolerance for the spacing of the finest samples (in between, d
  // exceeds the larger of two by at most half their spacing), half for the search.
  const float length = (q - p).norm();
  int intervals = 1;
  while (intervals < max_samples / 2 &&
         length / static_cast<float>(intervals) > tolerance)
    intervals *= 2;
  return largestDistance(field, p, q, intervals + 1, 0.5f * tolerance);
}

double
groupCID(const DistanceField& field,
         const Points& first,
         const Points& second,
         int samples,
         const ExecutionOptions& execution)
{
  if (first.empty() || second.empty())
    throw CIDException("the CID of two groups needs at least 1 point in each of them");
  const SampleOrder order(samples);
  SegmentSearch search(field, order);
  std::size_t hint = order.last() / 2;
  Progress progress(execution.progress);
  double sum = 0.0; // Eq. 3
  for (std::size_t i = 0; i < first.size(); ++i) {
    progress.check(static_cast<double>(i) / static_cast<double>(first.size()));
    for (const Eigen::Vector3f& q : second) {
      progress.poll();
      sum += search.pointCID({first[i], q, false}, infinity, hint);
    }
  }
  return sum / (static_cast<double>(first.size()) * static_cast<double>(second.size()));
}

} // namespace pcl_cid
