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
#include <vector>

namespace pcl_cid {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

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
  std::vector<std::size_t> samples;    ///< that are at work
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
                const Segment& segment,
                const SampleOrder& order)
  : field_(field)
  , segment_(segment)
  , order_(order)
  , samples_(segment.p, segment.q, order.samples())
  , scratch_(scratchOfThread())
  {
    high_.assign(order.last() + 1, infinity);
    concluded_.assign(order.last() + 1, 1);
    boundEnds();
  }

  /** One sample that is far enough decides; an upper bound below the limit at each
   *  shows that there is none. */
  std::optional<float>
  findAtLeast(float limit, std::size_t& hint)
  {
    lookUp(hint);
    for (const std::size_t l : {hint, std::size_t{0}, order_.last()})
      if (reaches(l, limit))
        return reached_;
    for (const SampleOrder::Level& level : order_.levels()) {
      boundLevel(level, [limit](float high) { return high >= limit; });
      for (const std::size_t l : at_work_)
        if (reaches(l, limit)) {
          hint = l;
          return reached_;
        }
    }
    return std::nullopt;
  }

  /** The largest upper bound; \a limit or more when one is that large. */
  float
  bound(float limit, std::size_t& hint)
  {
    lookUp(hint);
    float largest = std::max({high_[hint], high_.front(), high_.back()});
    for (const SampleOrder::Level& level : order_.levels()) {
      if (largest >= limit)
        break;
      boundLevel(level, [largest](float high) { return high > largest; });
      for (const std::size_t l : at_work_)
        if (high_[l] > largest) {
          largest = high_[l];
          hint = l;
        }
    }
    return largest;
  }

  /** The largest distance: first where the largest bound is, as far as samples were
   *  looked up, or at the hint; most other samples then fall short. */
  float
  maximum(std::size_t& hint)
  {
    hint = mostPromising(hint);
    evaluate(hint);
    keepThoseAbove(largest_);
    while (!at_work_.empty() && high_[at_work_.front()] > largest_) {
      const std::size_t l = takeHighest();
      evaluate(l);
      if (high_[l] == largest_)
        hint = l;
    }
    return largest_;
  }

private:
  struct Lower {
    const std::vector<float>& high;

    bool
    operator()(std::size_t l, std::size_t m) const
    {
      return high[l] < high[m];
    }
  };

  void
  boundEnds()
  {
    if (segment_.between_surface_points)
      high_.front() = high_.back() = 0.0f;
    else {
      lookUp(0);
      lookUp(order_.last());
    }
  }

  /** Bound the samples of a level by those around them, which are of earlier levels,
   *  then look up, side by side, those where that is not enough. */
  template <typename Predicate>
  void
  boundLevel(const SampleOrder::Level& level, const Predicate& is_worth_a_look)
  {
    at_work_.clear();
    for (const SampleOrder::Entry& entry : level) {
      high_[entry.sample] = samples_.between(entry, high_);
      if (is_worth_a_look(high_[entry.sample]))
        at_work_.push_back(entry.sample);
    }
    for (const std::size_t l : at_work_)
      lookUp(l);
  }

  void
  lookUp(std::size_t l)
  {
    high_[l] = field_.grid().high(samples_.at(l)) + samples_.slack;
    concluded_[l] = 0;
  }

  /** Whether d at a sample is at least the limit; `reached_` is then between the two.
   */
  bool
  reaches(std::size_t l, float limit)
  {
    if (high_[l] < limit)
      return false;
    reached_ = field_.grid().bounds(samples_.at(l)).low - samples_.slack;
    if (reached_ >= limit)
      return true;
    evaluate(l);
    reached_ = high_[l];
    return reached_ >= limit;
  }

  void
  evaluate(std::size_t l)
  {
    high_[l] = field_.distance(
        segmentSample(segment_.p, segment_.q, static_cast<int>(l), order_.samples()));
    largest_ = std::max(largest_, high_[l]);
  }

  /** The sample with the largest bound that was looked up. */
  std::size_t
  mostPromising(std::size_t top) const
  {
    for (std::size_t l = 0; l < high_.size(); ++l)
      if (!concluded_[l] && high_[l] > high_[top])
        top = l;
    return top;
  }

  void
  keepThoseAbove(float distance)
  {
    at_work_.clear();
    const auto keep = [&](std::size_t l) {
      if (high_[l] > distance)
        at_work_.push_back(l);
    };
    keep(0);
    keep(order_.last());
    for (const SampleOrder::Level& level : order_.levels())
      for (const SampleOrder::Entry& entry : level) {
        const std::size_t l = entry.sample;
        if (high_[l] > distance && concluded_[l]) {
          high_[l] = std::min(high_[l], samples_.between(entry, high_));
          if (high_[l] > distance)
            lookUp(l);
        }
        keep(l);
      }
    std::make_heap(at_work_.begin(), at_work_.end(), Lower{high_});
  }

  std::size_t
  takeHighest()
  {
    std::pop_heap(at_work_.begin(), at_work_.end(), Lower{high_});
    const std::size_t l = at_work_.back();
    at_work_.pop_back();
    return l;
  }

  const DistanceField& field_;
  const Segment& segment_;
  const SampleOrder& order_;
  SegmentSamples samples_;
  float largest_ = 0.0f; ///< of the exact distances so far
  float reached_ = 0.0f;
  Scratch& scratch_;
  std::vector<float>& high_ = scratch_.high;
  std::vector<std::uint8_t>& concluded_ = scratch_.concluded;
  std::vector<std::size_t>& at_work_ = scratch_.samples;
};

} // namespace

float
pointCID(const DistanceField& field,
         const Eigen::Vector3f& p,
         const Eigen::Vector3f& q,
         int samples,
         float limit)
{
  std::size_t middle = static_cast<std::size_t>(samples) / 2;
  return pointCID(field, {p, q, false}, orderOf(samples), limit, middle);
}

std::optional<float>
findCIDAtLeast(const DistanceField& field,
               const Segment& segment,
               const SampleOrder& order,
               float limit,
               std::size_t& hint)
{
  return SegmentSearch(field, segment, order).findAtLeast(limit, hint);
}

float
boundPointCID(const DistanceField& field,
              const Segment& segment,
              const SampleOrder& order,
              float limit,
              std::size_t& hint)
{
  return SegmentSearch(field, segment, order).bound(limit, hint);
}

float
pointCID(const DistanceField& field,
         const Segment& segment,
         const SampleOrder& order,
         float limit,
         std::size_t& hint)
{
  SegmentSearch search(field, segment, order); // Eq. 2
  if (limit < infinity)
    if (const std::optional<float> found = search.findAtLeast(limit, hint))
      return *found;
  return search.maximum(hint);
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
  const SampleOrder& order = orderOf(samples);
  std::size_t hint = order.last() / 2;
  double sum = 0.0; // Eq. 3
  for (const Eigen::Vector3f& p : first)
    for (const Eigen::Vector3f& q : second)
      sum += pointCID(field, {p, q, false}, order, infinity, hint);
  return sum / (static_cast<double>(first.size()) * static_cast<double>(second.size()));
}

} // namespace pcl_cid
