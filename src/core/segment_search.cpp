/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The CID of one segment: whether it reaches a limit, bounds of it, its value.
 */

#include "segment_search.h"

#include "distance_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_cid {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float epsilon = std::numeric_limits<float>::epsilon();

/** Levels of samples that the search for the largest distance begins with. */
constexpr std::size_t first_levels = 3;

/** The surface point that a look at a sample brought. */
struct Look {
  std::size_t sample;
  Eigen::Vector3f point;
  float distance; ///< of the two
};

/** What a search keeps from call to call: there are millions of them. */
struct Scratch {
  Eigen::ArrayXf squared_high; ///< by sample: an upper bound of d^2
  std::vector<Look> looks;
};

Scratch&
scratchOfThread()
{
  thread_local Scratch scratch;
  return scratch;
}

/** An upper bound of d at each sample of a segment, exact values where needed.
 *
 *  Any point n of the surface bounds d at all samples at once: d(x) <= |x - n|, and the
 *  square of that is a polynomial of degree 2 along the segment. Some points, and the
 *  smallest of their bounds says how far from the surface each sample can be. */
class SegmentSearch {
public:
  SegmentSearch(const DistanceField& field,
                const Segment& segment,
                const SampleOrder& order)
  : field_(field)
  , segment_(segment)
  , order_(order)
  , samples_(segment.p, segment.q, order.samples())
  , squared_length_(samples_.along.squaredNorm())
  , scratch_(scratchOfThread())
  {
  }

  /** One sample that is far enough decides, most often where it did for the segment
   *  before; an upper bound below the limit at each shows that there is none. */
  std::optional<float>
  findAtLeast(float limit, std::size_t& hint)
  {
    const DistanceField::Nearest at_hint = evaluate(hint);
    if (at_hint.distance >= limit)
      return at_hint.distance;
    start(limit);
    settle(hint, at_hint);
    const float target = squareOf(limit);
    for (const std::size_t end : {std::size_t{0}, order_.last()})
      if (reaches(end, limit, target))
        return reached_;
    for (const SampleOrder::Level& level : order_.levels()) {
      lookUpAbove(level, target);
      for (const Look& look : looks_)
        if (reaches(look.sample, limit, target)) {
          hint = look.sample;
          return reached_;
        }
    }
    return std::nullopt;
  }

  /** The largest upper bound; \a limit when one is that large. */
  float
  bound(float limit, std::size_t& hint)
  {
    start(limit);
    lookUp(hint);
    const float target = squareOf(limit);
    float largest = std::max({0.0f, high(hint), high(0), high(order_.last())});
    for (const SampleOrder::Level& level : order_.levels()) {
      if (largest >= target)
        return limit;
      lookUpAbove(level, largest);
      for (const Look& look : looks_)
        if (high(look.sample) > largest) {
          largest = high(look.sample);
          hint = look.sample;
        }
    }
    return std::sqrt(largest) * (1.0f + epsilon) + samples_.slack;
  }

  /** The largest distance: look where it can be largest, evaluate where looking does
   *  not help, until no sample can be farther than the farthest so far. */
  float
  maximum(std::size_t& hint)
  {
    if (segment_.p == segment_.q) // all samples are the same
      return evaluate(hint).distance;
    if (!started_) {
      start(infinity);
      lookUp(hint);
      for (std::size_t k = 0; k < std::min(first_levels, order_.levels().size()); ++k)
        lookUpAbove(order_.levels()[k], 0.0f);
    }
    for (;;) {
      const float highest = highs_.maxCoeff();
      if (!(highest >= squareOf(largest_)))
        return largest_;
      aim_ = std::sqrt(highest);
      const auto l = static_cast<std::size_t>(
          std::find(highs_.begin(), highs_.end(), highest) - highs_.begin());
      lookUp(l);
      if (high(l) < highest)
        continue;
      settle(l, evaluate(l));
      if (high(l) == settled && reached_ == largest_)
        hint = l;
    }
  }

private:
  /** The bound of a sample whose distance is known, and is part of `largest_`. */
  static constexpr float settled = -1.0f;

  float&
  high(std::size_t l)
  {
    return highs_[static_cast<Eigen::Index>(l)];
  }

  /** A squared bound below this shows that d is below a distance. */
  float
  squareOf(float distance) const
  {
    const float certain = std::max(distance - samples_.slack, 0.0f);
    return certain * certain * (1.0f - 4.0f * epsilon);
  }

  /** \param[in] aim bounds that are larger would be of no use, metres */
  void
  start(float aim)
  {
    started_ = true;
    aim_ = aim;
    highs_.setConstant(order_.fractions().size(), infinity);
    highs_.tail(order_.fractions().size() - order_.samples()) = settled;
    for (const std::size_t end : {std::size_t{0}, order_.last()})
      if (segment_.between_surface_points)
        settle(end, {end == 0 ? segment_.p : segment_.q, 0.0f});
      else
        lookUp(end);
  }

  /** Look up those samples of a level whose bounds are no smaller than a target, side
   *  by side. */
  void
  lookUpAbove(const SampleOrder::Level& level, float target)
  {
    looks_.clear();
    for (const SampleOrder::Entry& entry : level)
      if (high(entry.sample) >= target)
        looks_.push_back({entry.sample, Eigen::Vector3f::Zero(), 0.0f});
    for (Look& look : looks_)
      look = lookAt(look.sample);
    for (const Look& look : looks_)
      take(look);
  }

  void
  lookUp(std::size_t l)
  {
    take(lookAt(l));
  }

  Look
  lookAt(std::size_t l) const
  {
    const Eigen::Vector3f x = samples_.at(l);
    const Eigen::Vector3f& point = field_.grid().likelyNearest(x);
    return {l, point, (x - point).norm()};
  }

  /** Lower the bounds of the samples that a surface point is near to. At t from 0 to 1
   *  along the segment, |x - n|^2 = a + b t + c t^2; what rounding can take from it is
   *  less than 16 epsilon (a + c), or what float cannot tell from 0. */
  void
  take(const Look& look)
  {
    const Eigen::Vector3f from = samples_.from - look.point;
    const float b = 2.0f * samples_.along.dot(from);
    const float c = squared_length_;
    float a = from.squaredNorm();
    a += 16.0f * epsilon * (a + c) + std::numeric_limits<float>::min();

    // Farther samples are not within `aim_` of the point.
    constexpr Eigen::Index packet = SampleOrder::packet;
    Eigen::Index first = 0;
    Eigen::Index end = highs_.size();
    const float reach = (aim_ + look.distance) / samples_.spacing + 1.0f;
    if (reach < static_cast<float>(order_.samples())) {
      const auto samples = static_cast<Eigen::Index>(reach);
      const auto l = static_cast<Eigen::Index>(look.sample);
      first = std::max<Eigen::Index>(l - samples, 0) / packet * packet;
      end = std::min(end, (l + samples) / packet * packet + packet);
    }
    using Packet = Eigen::Array<float, packet, 1>;
    for (Eigen::Index k = first; k < end; k += packet) {
      const auto t = Packet::MapAligned(order_.fractions().data() + k);
      auto high = Packet::MapAligned(highs_.data() + k);
      high = high.min(a + t * (b + c * t));
    }
  }

  /** Whether d at a sample is at least the limit; `reached_` is then between the two.
   */
  bool
  reaches(std::size_t l, float limit, float target)
  {
    if (high(l) < target)
      return false;
    reached_ = field_.grid().bounds(samples_.at(l)).low - samples_.slack;
    if (reached_ < limit)
      settle(l, evaluate(l));
    return reached_ >= limit;
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
    high(l) = settled;
  }

  const DistanceField& field_;
  const Segment& segment_;
  const SampleOrder& order_;
  SegmentSamples samples_;
  float squared_length_;
  bool started_ = false;
  float aim_ = infinity;
  float largest_ = 0.0f; ///< of the exact distances so far
  float reached_ = 0.0f; ///< the last distance, or a lower bound of it
  Scratch& scratch_;
  Eigen::ArrayXf& highs_ = scratch_.squared_high;
  std::vector<Look>& looks_ = scratch_.looks;
};

} // namespace

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

} // namespace pcl_cid
