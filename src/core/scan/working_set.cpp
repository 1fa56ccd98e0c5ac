/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points that the method works on, and how results carry over to all
 * others.
 */

#include "working_set.h"

#include "base/parallel_for.h"
#include "base/requirements.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

/** \a count of 0 .. \a total - 1, each subset equally likely once \a always is taken:
 *  selection by a partial Fisher-Yates shuffle. Ascending. */
pcl::Indices
drawPositions(std::size_t count,
              std::size_t total,
              const pcl::Indices& always,
              RandomGenerator& generator)
{
  pcl::Indices order(total);
  std::iota(order.begin(), order.end(), 0);
  pcl::Indices wanted = always;
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  std::size_t chosen = 0;
  for (const pcl::index_t position : wanted) // ascending: each is still in its place
    std::swap(order[chosen++], order[static_cast<std::size_t>(position)]);
  for (; chosen < count; ++chosen)
    std::swap(order[chosen], order[chosen + drawBelow(generator, total - chosen)]);
  order.resize(chosen);
  std::sort(order.begin(), order.end());
  return order;
}

} // namespace

WorkingSet::WorkingSet(PointSet points,
                       const SurfacePoints& surface,
                       const DistanceField::Options& options,
                       std::size_t subsample,
                       const pcl::Indices& always,
                       RandomGenerator& generator)
: all_(std::move(points))
{
  requirePoints(all_.points);
  if (subsample > 0 && subsample < all_.size()) {
    position_ = drawPositions(subsample, all_.size(), always, generator);
    for (const pcl::index_t position : position_)
      drawn_.push_back(all_.points[static_cast<std::size_t>(position)]);
  }
  makeField(surface, options);
  if (!position_.empty())
    findFollowed(surface.given.empty() && surface.filling.empty(), options.execution);
}

void
WorkingSet::makeField(const SurfacePoints& surface,
                      const DistanceField::Options& options)
{
  const auto make = [&](const Points& s) {
    field_ = std::make_unique<DistanceField>(s, options);
  };
  if (!surface.given.empty()) {
    make(surface.given);
  }
  else if (surface.filling.empty()) {
    make(points());
  }
  else {
    Points filled = points();
    filled.insert(filled.end(), surface.filling.begin(), surface.filling.end());
    make(filled);
  }
}

void
WorkingSet::findFollowed(bool surface_is_drawn, const ExecutionOptions& execution)
{
  std::unique_ptr<DistanceField> of_drawn;
  if (!surface_is_drawn)
    of_drawn = std::make_unique<DistanceField>(drawn_);
  const DistanceField& near = surface_is_drawn ? *field_ : *of_drawn;
  follows_.resize(all_.size());
  Progress progress(execution.progress);
  parallelFor(all_.size(),
              256,
              threadCount(execution.threads),
              progress,
              {0.0, 0.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                  follows_[i] = near.nearest(all_.points[i]);
              });
  // A duplicate of a drawn point may be as near; a drawn point must follow itself.
  for (std::size_t k = 0; k < position_.size(); ++k)
    follows_[static_cast<std::size_t>(position_[k])] = static_cast<pcl::index_t>(k);
}

pcl::index_t
WorkingSet::indexOf(pcl::index_t position) const
{
  if (position_.empty())
    return position;
  const auto found = std::lower_bound(position_.begin(), position_.end(), position);
  if (found == position_.end() || *found != position)
    return -1;
  return static_cast<pcl::index_t>(found - position_.begin());
}

} // namespace pcl_cid
