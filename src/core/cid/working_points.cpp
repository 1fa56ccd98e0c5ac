/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points that Algorithms 1 and 2 work on: in blocks, with the costs of their pairs.
 */

#include "working_points.h"

#include "base/parallel_for.h"
#include "base/requirements.h"

namespace pcl_cid {
namespace {

std::unique_ptr<BlockTree>
makeTree(const Points& points,
         WorkingPoints::Place place,
         int threads,
         Progress& progress)
{
  requirePoints(points);
  if (place == WorkingPoints::Place::are_surface)
    return nullptr;
  return std::make_unique<BlockTree>(points, threads, progress);
}

/** The costs, once checked against the points. */
const PairCosts*
valid(const PairCosts* costs, std::size_t points)
{
  if (costs)
    requireCosts(*costs, points);
  return costs;
}

} // namespace

WorkingPoints::WorkingPoints(const DistanceField& field,
                             const Points& points,
                             Place place,
                             const PairCosts* costs,
                             int threads,
                             Progress& progress)
: field_(field)
, points_(points)
, on_surface_(place != Place::anywhere)
, own_tree_(makeTree(points, place, threads, progress))
, costs_(valid(costs, points.size()), tree(), threads, progress)
, slots_(points.size())
{
  findSlots(threads, progress);
}

void
WorkingPoints::findSlots(int threads, Progress& progress)
{
  const BlockTree& blocks = tree();
  parallelFor(blocks.size(), 256, threads, progress, {}, [&](auto begin, auto end) {
    for (std::size_t b = begin; b < end; ++b)
      for (int row = 0; row < blocks.block(b).count; ++row)
        slots_[static_cast<std::size_t>(blocks.block(b).index[row])] =
            static_cast<std::int32_t>(b) * PointBlock::capacity + row;
  });
}

} // namespace pcl_cid
