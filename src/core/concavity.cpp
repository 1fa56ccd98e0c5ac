/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Concavity-Induced Distance of two points and of two groups: Eq. 1 to 3.
 */

#include "distance_grid.h"
#include "segment_samples.h"
#include "validation.h"

#include <pcl_cid/core/concavity.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
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
  return 16.0f * std::numeric_limits<float>::epsilon() * magnitude;
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
  thread_local std::vector<Stretch> open;
  open.clear();
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

const SampleOrder&
orderOf(int samples)
{
  thread_local SampleOrder order(min_samples);
  if (order.samples() != samples)
    order = SampleOrder(samples);
  return order;
}

/** What a search keeps from call to call: there are millions of them. */
struct Scratch {
  std::vector<float> high;             ///< by sample: an upper bound of d
  std::vector<std::uint8_t> concluded; ///< by sample: `high` was not looked up
  std::vector<std::size_t> open;       ///< samples that may exceed the largest so far
  Points feet;                         ///< surface points nearest to evaluated samples
};

Scratch&
scratchOfThread()
{
  thread_local Scratch scratch;
  return scratch;
}

/** The samples of one segment: an upper bound of d at each, exact values where needed.
 */
class SegmentSearch {
public:
  SegmentSearch(const DistanceField& field,
                const Eigen::Vector3f& p,
                const Eigen::Vector3f& q,
                const SampleOrder& order)
  : field_(field)
  , p_(p)
  , q_(q)
  , order_(order)
  , segment_(p, q, order.samples())
  , scratch_(scratchOfThread())
  {
    high_.resize(order.entries().size());
    concluded_.assign(order.entries().size(), 0);
    open_.clear();
    feet_.clear();
  }

  /** One sample that is too far decides; an upper bound at each shows that there is
   * none. \return a distance on the segment that is at least \a limit, if there is one
   */
  std::optional<float>
  findAtLeast(float limit)
  {
    for (const SampleOrder::Entry& entry : order_.entries()) {
      const std::size_t l = entry.sample;
      if (conclude(entry, limit))
        continue;
      lookUp(l);
      if (high_[l] < limit)
        continue;
      const float low = field_.grid().bounds(segment_.at(l)).low - segment_.slack;
      if (low >= limit)
        return low;
      evaluate(l);
      if (high_[l] >= limit)
        return high_[l];
    }
    return std::nullopt;
  }

  /** The largest distance, once no sample reaches \a limit: about where the largest
   * bound is; most other samples then fall short. */
  float
  maximum(float limit)
  {
    evaluate(mostPromising(limit));
    keepThoseAboveLargest();
    while (!open_.empty()) {
      const std::size_t l = takeHighest();
      if (high_[l] <= largest_)
        break;
      if (!isNearKnownFoot(l))
        evaluate(l);
    }
    return largest_;
  }

private:
  static constexpr std::size_t most_feet = 8; ///< recent ones; older ones are far away

  struct Lower {
    const std::vector<float>& high;

    bool
    operator()(std::size_t l, std::size_t m) const
    {
      return high[l] < high[m];
    }
  };

  /** Whether the samples on both sides already keep this one below the limit. */
  bool
  conclude(const SampleOrder::Entry& entry, float limit)
  {
    if (entry.isEnd())
      return false;
    high_[entry.sample] = segment_.between(entry, high_);
    concluded_[entry.sample] = high_[entry.sample] < limit;
    return concluded_[entry.sample] != 0;
  }

  void
  lookUp(std::size_t l)
  {
    high_[l] = field_.grid().high(segment_.at(l)) + segment_.slack;
  }

  void
  evaluate(std::size_t l)
  {
    const DistanceField::Foot foot =
        field_.foot(segmentSample(p_, q_, static_cast<int>(l), order_.samples()));
    high_[l] = foot.distance;
    largest_ = std::max(largest_, high_[l]);
    feet_.push_back(foot.point);
  }

  /** The sample with the largest bound that was looked up; the middle without a limit,
   *  when hardly any was. */
  std::size_t
  mostPromising(float limit) const
  {
    std::size_t top = high_.size() / 2;
    if (limit < std::numeric_limits<float>::infinity())
      for (std::size_t l = 0; l < high_.size(); ++l)
        if (!concluded_[l] && high_[l] > high_[top])
          top = l;
    return top;
  }

  void
  keepThoseAboveLargest()
  {
    for (const SampleOrder::Entry& entry : order_.entries()) {
      const std::size_t l = entry.sample;
      if (high_[l] > largest_ && concluded_[l]) {
        high_[l] = std::min(high_[l], segment_.between(entry, high_));
        if (high_[l] > largest_)
          lookUp(l);
      }
      if (high_[l] > largest_)
        open_.push_back(l);
    }
    std::make_heap(open_.begin(), open_.end(), Lower{high_});
  }

  std::size_t
  takeHighest()
  {
    std::pop_heap(open_.begin(), open_.end(), Lower{high_});
    const std::size_t l = open_.back();
    open_.pop_back();
    return l;
  }

  /** Whether a surface point that is known already is near enough: then d is no larger
   *  than what was found. Neighbouring samples often share their nearest point. */
  bool
  isNearKnownFoot(std::size_t l) const
  {
    const Eigen::Vector3f x = segment_.at(l);
    const std::size_t recent = std::min(feet_.size(), most_feet);
    for (std::size_t k = 1; k <= recent; ++k)
      if ((x - feet_[feet_.size() - k]).norm() * 1.000002f + segment_.slack <= largest_)
        return true;
    return false;
  }

  const DistanceField& field_;
  const Eigen::Vector3f& p_;
  const Eigen::Vector3f& q_;
  const SampleOrder& order_;
  SegmentSamples segment_;
  float largest_ = 0.0f; ///< of the exact distances so far

  Scratch& scratch_;
  std::vector<float>& high_ = scratch_.high;
  std::vector<std::uint8_t>& concluded_ = scratch_.concluded;
  std::vector<std::size_t>& open_ = scratch_.open;
  Points& feet_ = scratch_.feet;
};

} // namespace

float
pointCID(const DistanceField& field,
         const Eigen::Vector3f& p,
         const Eigen::Vector3f& q,
         int samples,
         float limit)
{
  return pointCID(field, p, q, orderOf(samples), limit);
}

float
pointCID(const DistanceField& field,
         const Eigen::Vector3f& p,
         const Eigen::Vector3f& q,
         const SampleOrder& order,
         float limit)
{
  SegmentSearch search(field, p, q, order); // Eq. 2
  if (const std::optional<float> found = search.findAtLeast(limit))
    return *found;
  return search.maximum(limit);
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
         int samples)
{
  if (first.empty() || second.empty())
    throw CIDException("the CID of two groups needs at least 1 point in each of them");
  double sum = 0.0; // Eq. 3
  for (const Eigen::Vector3f& p : first)
    for (const Eigen::Vector3f& q : second)
      sum += pointCID(field, p, q, samples);
  return sum / (static_cast<double>(first.size()) * static_cast<double>(second.size()));
}

} // namespace pcl_cid
