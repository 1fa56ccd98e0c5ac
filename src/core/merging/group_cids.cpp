/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID_g of every pair of groups: bounds first, exact values on demand.
 */

#include "group_cids.h"
#include "base/infinity.h"
#include "base/rounding.h"

#include "cid/segment_search.h"
#include "field/distance_grid.h"

#include <algorithm>
#include <utility>

namespace pcl_cid {
namespace {

/** The share of the progress that the rough bounds take. */
constexpr double bounds_share = 0.05;

} // namespace

/** How a lower bound of the CID of two points is found. */
struct GroupCIDs::Effort {
  std::size_t levels;     ///< of samples with a look-up each
  bool exact_at_farthest; ///< whether the best of them is evaluated
};

/** The middle sample alone shows that most groups are far apart. Each later step costs
 *  a fraction of the next one, and rules out many of the pairs. */
constexpr std::array<GroupCIDs::Effort, 3> GroupCIDs::efforts = {
    {{1, false}, {3, false}, {3, true}}};

GroupCIDs::GroupCIDs(const WorkingPoints& points,
                     std::vector<pcl::Indices> drawn,
                     const GroupMergingOptions& options,
                     Progress& progress)
: points_(points)
, drawn_(std::move(drawn))
, lattice_(options.group_samples)
, order_(options.samples)
, threads_(threadCount(options.execution.threads))
, progress_(progress)
, values_(drawn_.size() * drawn_.size(), 0.0)
, tried_(values_.size(), 1)
{
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < drawn_.size(); ++i)
    for (std::size_t j = i + 1; j < drawn_.size(); ++j)
      pairs.push_back({i, j});
  // The whole tree depends on every pair, so bounds would save nothing.
  const bool exactly = options.makesWholeTree();
  parallelForEach(pairs.size(),
                  threads_,
                  progress_,
                  {0.0, exactly ? 1.0 : bounds_share},
                  [&](std::size_t k) {
                    if (exactly)
                      evaluate(pairs[k]);
                    else
                      values_[place(pairs[k])] = lowerBound(pairs[k], efforts.front());
                  });
}

void
GroupCIDs::tighten(const std::vector<Pair>& pairs)
{
  parallelForEach(pairs.size(), threads_, progress_, share(), [&](std::size_t k) {
    tighten(pairs[k]);
  });
  tightened_ += pairs.size();
}

void
GroupCIDs::tighten(Pair pair)
{
  std::uint8_t& tried = tried_[place(pair)];
  if (tried == efforts.size()) {
    evaluate(pair);
    return;
  }
  values_[place(pair)] = lowerBound(pair, efforts[tried]);
  ++tried;
}

void
GroupCIDs::evaluate(Pair pair)
{
  SegmentSearch search(points_.field(), order_);
  std::size_t hint = order_.last() / 2;
  values_[place(pair)] = meanOf(pair, [&](pcl::index_t p, pcl::index_t q) {
    const Segment segment{position(p), position(q), points_.areOnSurface()};
    return costOf(p, q).of(search.pointCID(segment, infinity, hint));
  });
  tried_[place(pair)] = exact;
}

/** Eq. 3 of what pairs of points cost: of all pairs, where the lattice has no fewer. */
template <typename CostOfTwo>
double
GroupCIDs::meanOf(Pair pair, CostOfTwo costOfTwo) const
{
  const pcl::Indices& from_i = drawn_[pair.i];
  const pcl::Indices& from_j = drawn_[pair.j];
  const std::size_t all = from_i.size() * from_j.size();
  double sum = 0.0;
  if (all <= lattice_.size()) {
    for (const pcl::index_t p : from_i)
      for (const pcl::index_t q : from_j)
        sum += costOfTwo(p, q);
    return sum / static_cast<double>(all);
  }
  for (std::size_t k = 0; k < lattice_.size(); ++k)
    sum += costOfTwo(from_i[k * from_i.size() / lattice_.size()],
                     from_j[lattice_.row(k) * from_j.size() / lattice_.size()]);
  return sum / static_cast<double>(lattice_.size());
}

/** The mean of, for each pair of points, a certified lower bound of d at a sample that
 *  is far from the surface. Summed in the same order as the exact value, which rounding
 *  then keeps above it. */
double
GroupCIDs::lowerBound(Pair pair, const Effort& effort) const
{
  return meanOf(pair, [&](pcl::index_t p, pcl::index_t q) {
    const SegmentSamples segment(position(p), position(q), order_.samples());
    return costOf(p, q).of(lowerBound(segment, effort));
  });
}

float
GroupCIDs::lowerBound(const SegmentSamples& segment, const Effort& effort) const
{
  float largest = 0.0f;
  std::size_t farthest = order_.last() / 2;
  for (std::size_t k = 0; k < std::min(order_.levels().size(), effort.levels); ++k)
    for (const std::size_t l : order_.levels()[k]) {
      const float low = points_.field().grid().lowerBound(segment.at(l));
      if (low > largest) {
        largest = low;
        farthest = l;
      }
    }
  if (effort.exact_at_farthest)
    largest = std::max(largest, points_.field().distance(segment.at(farthest)));
  constexpr float loss = rounding::of_bound;
  return std::max(largest * (1.0f - loss) - segment.slack, 0.0f);
}

/** The share of the progress, as if all pairs were to be made exact. */
ProgressSpan
GroupCIDs::share() const
{
  const auto pairs = static_cast<double>(drawn_.size() * drawn_.size()) / 2.0;
  const double all = pairs * static_cast<double>(efforts.size());
  const double done = static_cast<double>(tightened_) / all;
  const double fraction = bounds_share + (1.0 - bounds_share) * std::min(done, 1.0);
  return {fraction, fraction};
}

} // namespace pcl_cid
