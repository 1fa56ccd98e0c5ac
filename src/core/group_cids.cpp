/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID_g of every pair of groups: bounds first, exact values on demand.
 */

#include "group_cids.h"

#include "distance_grid.h"

#include <pcl_cid/core/concavity.h>

#include <algorithm>
#include <utility>

namespace pcl_cid {
namespace {

/** Levels of samples that a lower bound of the CID of a pair looks at. */
constexpr std::size_t bound_levels = 3;

/** The share of the progress that the bounds take. */
constexpr double bounds_share = 0.2;

} // namespace

GroupCIDs::GroupCIDs(const DistanceField& field,
                     std::vector<Points> drawn,
                     const GroupMergingOptions& options,
                     Progress& progress)
: field_(field)
, drawn_(std::move(drawn))
, order_(options.samples)
, threads_(threadCount(options.execution.threads))
, progress_(progress)
, values_(drawn_.size() * drawn_.size(), 0.0)
, exact_(values_.size(), 0)
{
  parallelFor(drawn_.size(),
              1,
              threads_,
              progress_,
              {0.0, bounds_share},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                  for (std::size_t j = i + 1; j < drawn_.size(); ++j)
                    values_[place({i, j})] = lowerBound({i, j});
              });
}

void
GroupCIDs::makeExact(const std::vector<Pair>& pairs)
{
  parallelFor(pairs.size(),
              1,
              threads_,
              progress_,
              share(),
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k) {
                  const Pair pair = pairs[k];
                  values_[place(pair)] = groupCID(
                      field_, drawn_[pair.i], drawn_[pair.j], order_.samples());
                  exact_[place(pair)] = 1;
                }
              });
  made_exact_ += pairs.size();
}

/** Eq. 3 with, for each pair of points, the largest certified lower bound of d at some
 *  samples. Summed in the same order as the exact value, which rounding then keeps
 * above it. */
double
GroupCIDs::lowerBound(Pair pair) const
{
  const DistanceGrid& grid = field_.grid();
  double sum = 0.0;
  for (const Eigen::Vector3f& p : drawn_[pair.i])
    for (const Eigen::Vector3f& q : drawn_[pair.j]) {
      const SegmentSamples segment(p, q, order_.samples());
      float low = 0.0f;
      for (std::size_t k = 0; k < std::min(order_.levels().size(), bound_levels); ++k)
        for (const SampleOrder::Entry& entry : order_.levels()[k])
          low = std::max(low, grid.bounds(segment.at(entry.sample)).low);
      sum += std::max(low - segment.slack, 0.0f);
    }
  return sum / (static_cast<double>(drawn_[pair.i].size()) *
                static_cast<double>(drawn_[pair.j].size()));
}

/** Where the progress stands, if all pairs were to be made exact. */
ProgressSpan
GroupCIDs::share() const
{
  const double all = 0.5 * static_cast<double>(drawn_.size() * drawn_.size());
  const double done = static_cast<double>(made_exact_) / all;
  const double fraction = bounds_share + (1.0 - bounds_share) * std::min(done, 1.0);
  return {fraction, fraction};
}

} // namespace pcl_cid
