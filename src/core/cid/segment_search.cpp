/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The CID of one segment: whether it reaches a limit, bounds of it, its value.
 */

#include "segment_search.h"
#include "base/infinity.h"
#include "base/rounding.h"

#include "field/distance_grid.h"
#include "sample_caps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace pcl_cid {
namespace {

/** Levels of samples that the search for the largest distance begins with. */
constexpr std::size_t first_levels = 3;

} // namespace

/** An upper bound of d at each sample of a segment, exact values where needed. */
class SearchOfSegment {
public:
  SearchOfSegment(SegmentSearch& memory, const Segment& segment)
  : field_(memory.field_)
  , segment_(segment)
  , order_(memory.order_)
  , samples_(segment.p, segment.q, order_.samples())
  , samples_a_metre_(1.0f / samples_.spacing)
  , caps_(samples_, order_, memory.caps_)
  , trail_(memory.trail_)
  , looks_(memory.looks_)
  {
  }

  /** One sample that is far enough decides: most often the hint, or one beside it. An
   *  upper bound below the limit at every sample shows that there is none. */
  std::optional<float>
  findAtLeast(float limit, std::size_t& hint)
  {
    const float low = lowerBound(hint);
    if (low >= limit)
      return low;
    start(limit);
    const float target = caps_.squareOf(limit);
    if (caps_[hint] >= target)
      lookUp(hint);
    for (const std::size_t l : {hint, std::size_t{0}, order_.last()})
      if (reaches(l, limit, target))
        return reached_;
    const std::size_t before = hint - std::min<std::size_t>(hint, 1);
    for (const std::size_t beside : {before, std::min(hint + 1, order_.last())}) {
      if (caps_[beside] >= target)
        lookUp(beside);
      if (reaches(beside, limit, target)) {
        hint = beside;
        return reached_;
      }
    }
    for (const SampleOrder::Level& level : order_.levels()) {
      lookUpAbove(level, target);
      for (const Look& look : found())
        if (reaches(look.sample, limit, target)) {
          hint = look.sample;
          return reached_;
        }
    }
    return std::nullopt;
  }

  /** An upper bound, from looks at the samples that may raise it; \a limit when some
   *  sample is that far from the surface. */
  float
  bound(float limit, UpperBound how, std::size_t& hint)
  {
    start(limit);
    lookUp(hint);
    const float target = caps_.squareOf(limit);
    float largest = 0.0f;
    for (const std::size_t l : {hint, std::size_t{0}, order_.last()}) {
      if (reaches(l, limit, target))
        return limit;
      largest = std::max(largest, orDistance(caps_[l]));
    }
    for (const SampleOrder::Level& level : order_.levels()) {
      lookUpAbove(level, largest);
      for (const Look& look : found()) {
        const bool reached = reaches(look.sample, limit, target);
        if (reached || orDistance(caps_[look.sample]) > largest)
          hint = look.sample;
        if (reached)
          return limit;
        largest = std::max(largest, orDistance(caps_[look.sample]));
      }
    }
    if (how == UpperBound::exact)
      return largestOfLooks();
    return mostOfLooks();
  }

  /** An upper bound of the CID, from the looks so far. */
  float
  mostOfLooks() const
  {
    return std::sqrt(orDistance(caps_.largest())) * (1.0f + rounding::of_product) +
           samples_.slack;
  }

  /** Bounds that tell whether the CID reaches a limit. Where it does not, the sample
   *  that may be the farthest one gives the lower bound. */
  DistanceBounds
  bounds(float limit, std::size_t& hint)
  {
    if (const std::optional<float> found = findAtLeast(limit, hint))
      return {*found, infinity};
    if (caps_.largest() > 0.0f)
      hint = caps_.find(caps_.largest());
    return {std::max(largest_, lowerBound(hint)), std::min(mostOfLooks(), limit)};
  }

  /** The largest distance: take a look where the bound is largest, and the exact
   *  distance where a look does not lower the bound, until no bound exceeds the largest
   *  distance found. */
  float
  maximum(std::size_t& hint)
  {
    if (segment_.p == segment_.q) // all samples are the same
      return evaluate(hint).distance;
    if (!started_) {
      start(infinity);
      lookUp(hint);
      const float target =
          caps_.squareOf(lowerBound(hint)); // smaller caps need no look
      for (std::size_t k = 0; k < std::min(first_levels, order_.levels().size()); ++k)
        lookUpAbove(order_.levels()[k], target);
    }
    for (;;) {
      const float highest = caps_.largest();
      if (!(highest >= caps_.squareOf(largest_)))
        return largest_;
      aim_ = std::sqrt(highest);
      const std::size_t l = caps_.find(highest);
      lookUp(l);
      if (caps_[l] < highest)
        continue;
      settle(l, evaluate(l));
      if (reached_ == largest_)
        hint = l;
    }
  }

private:
  using Look = SegmentSearch::Look;

  /** The looks of the last level. */
  struct Looks {
    Look* first;
    Look* last;

    Look*
    begin() const
    {
      return first;
    }

    Look*
    end() const
    {
      return last;
    }
  };

  Looks
  found()
  {
    return {looks_.data(), looks_.data() + found_};
  }

  /** The largest distance once looks help no more: evaluate the sample with the largest
   *  cap until no cap exceeds the largest distance found. */
  float
  largestOfLooks()
  {
    for (;;) {
      const float highest = caps_.largest();
      if (highest < caps_.squareOf(largest_))
        return largest_;
      const std::size_t l = caps_.find(highest);
      settle(l, evaluate(l));
    }
  }

  /** \param[in] aim caps above this are of no use, metres */
  void
  start(float aim)
  {
    started_ = true;
    aim_ = aim;
    if (trail_)
      caps_.reset(*trail_);
    else
      caps_.reset();
    for (const std::size_t end : {std::size_t{0}, order_.last()})
      if (segment_.between_surface_points)
        settle(end, {end == 0 ? segment_.p : segment_.q, 0.0f});
      else
        lookUp(end);
  }

  /** Take a look at those samples of a level whose caps are no smaller than a target,
   *  all in one batch. */
  void
  lookUpAbove(const SampleOrder::Level& level, float target)
  {
    if (looks_.size() < level.size())
      looks_.resize(level.size());
    Look* kept = looks_.data();
    for (const std::size_t l : level) { // branch-free
      kept->sample = l;
      kept += caps_[l] >= target;
    }
    found_ = static_cast<std::size_t>(kept - looks_.data());
    for (Look& look : found())
      look = lookAt(look.sample);
    for (const Look& look : found())
      take(look);
  }

  void
  lookUp(std::size_t l)
  {
    take(lookAt(l));
  }

  float
  lowerBound(std::size_t l) const
  {
    return field_.grid().lowerBound(samples_.at(l)) - samples_.slack;
  }

  Look
  lookAt(std::size_t l) const
  {
    const Eigen::Vector3f x = samples_.at(l);
    const Eigen::Vector3f& point = field_.grid().likelyNearest(x);
    return {l, point, (x - point).norm()};
  }

  void
  take(const Look& look)
  {
    if (trail_)
      trail_->set(look.sample, look.point);
    // Samples that are farther away are not within `aim_` of the point.
    const float reach = (aim_ + look.distance) * samples_a_metre_ + 1.0f;
    const std::size_t all = order_.last();
    caps_.lower(look.point,
                look.sample,
                reach < static_cast<float>(all) ? static_cast<std::size_t>(reach)
                                                : all);
  }

  /** Whether d at a sample is at least the limit; `reached_` then lies between the two.
   */
  bool
  reaches(std::size_t l, float limit, float target)
  {
    if (caps_[l] < target)
      return false;
    reached_ = lowerBound(l);
    if (reached_ < limit)
      settle(l, evaluate(l));
    return reached_ >= limit;
  }

  /** A cap, or the square of the largest distance so far if that is larger. The term
   *  added covers distances whose squares underflow. */
  float
  orDistance(float cap) const
  {
    return std::max(cap, largest_ * largest_ + std::numeric_limits<float>::min());
  }

  DistanceField::Nearest
  evaluate(std::size_t l) const
  {
    return field_.nearestPoint(
        segmentSample(segment_.p, segment_.q, static_cast<int>(l), order_.samples()));
  }

  void
  settle(std::size_t l, const DistanceField::Nearest& nearest)
  {
    reached_ = nearest.distance;
    largest_ = std::max(largest_, reached_);
    take({l, nearest.point, nearest.distance});
    caps_[l] = SampleCaps::settled;
  }

  const DistanceField& field_;
  const Segment& segment_;
  const SampleOrder& order_;
  SegmentSamples samples_;
  float samples_a_metre_; ///< infinity where all samples are the same
  SampleCaps caps_;
  SampleTrail* trail_; ///< null: none is followed
  bool started_ = false;
  float aim_ = infinity;
  float largest_ = 0.0f; ///< of the exact distances so far
  float reached_ = 0.0f; ///< the last distance, or a lower bound of it
  std::vector<Look>& looks_;
  std::size_t found_ = 0; ///< of them
};

std::size_t&
SegmentSearch::follow(std::size_t origin)
{
  const auto known =
      std::find_if(trails_.begin(), trails_.end(), [origin](const SampleTrail& trail) {
        return trail.isFrom(origin);
      });
  if (known != trails_.end()) {
    trail_ = &*known;
    return trail_->hint();
  }
  last_ = (last_ + 1) % trails_.size();
  trail_ = &trails_[last_];
  trail_->begin(origin, order_, field_.blocks().position(0));
  return trail_->hint();
}

DistanceBounds
SegmentSearch::bounds(const Segment& segment, float limit, std::size_t& hint)
{
  return SearchOfSegment(*this, segment).bounds(limit, hint);
}

float
SegmentSearch::upperBound(const Segment& segment,
                          float limit,
                          UpperBound how,
                          std::size_t& hint)
{
  return SearchOfSegment(*this, segment).bound(limit, how, hint);
}

float
SegmentSearch::pointCID(const Segment& segment, float limit, std::size_t& hint)
{
  SearchOfSegment search(*this, segment); // Eq. 2
  if (limit < infinity)
    if (const std::optional<float> found = search.findAtLeast(limit, hint))
      return *found;
  return search.maximum(hint);
}

} // namespace pcl_cid
