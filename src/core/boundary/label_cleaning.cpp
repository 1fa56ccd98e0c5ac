/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels with ragged boundaries mended: a small energy over the points near them.
 */

#include "boundary_points.h"
#include "label_costs.h"
#include "label_energy.h"
#include "neighbor_links.h"

#include "base/requirements.h"
#include "scan/local_spacing.h"
#include "scan/surface_normals.h"
#include "scan/working_set.h"

#include <pcl_cid/core/label_cleaning.h>

#include <utility>

namespace pcl_cid {
namespace {

/** Where the steps of the work end, as shares of it. */
constexpr double neighbors_end = 0.2;
constexpr double costs_end = 0.6;
constexpr double normals_end = 0.9;

/** A normal is fitted to this many points, its own included. */
constexpr std::size_t points_of_normal = 17;

void
requireUsable(const CleaningSettings& settings)
{
  require(cleaning_setting::reach, settings.reach);
  require(cleaning_setting::most_loss, settings.most_loss);
  require(cleaning_setting::pull, settings.pull);
  require(cleaning_setting::normal_scale, settings.normal_scale);
  require(cleaning_setting::color_scale, settings.color_scale);
  require(cleaning_setting::most_cycles, settings.most_cycles);
}

/** The progress of a step is this share of the whole. */
ExecutionOptions
share(const ExecutionOptions& execution, double begin, double end)
{
  ExecutionOptions part{execution.threads, {}};
  if (execution.progress)
    part.progress = [&execution, begin, end](double fraction) {
      return execution.progress(begin + (end - begin) * fraction);
    };
  return part;
}

std::vector<std::uint32_t>
labelsOfGroups(const std::vector<pcl::index_t>& group,
               const std::vector<std::uint32_t>& label_of_seed)
{
  std::vector<std::uint32_t> labels;
  labels.reserve(group.size());
  for (const pcl::index_t seed : group)
    labels.push_back(label_of_seed[static_cast<std::size_t>(seed)]);
  return labels;
}

/** Whether each point that is worked on is a seed. */
std::vector<bool>
seedMarks(const Grouping& grouping)
{
  const PreparedScan& scan = grouping.scan();
  std::vector<bool> is_seed(scan.working().size(), false);
  for (const pcl::index_t seed : grouping.seeds())
    is_seed[static_cast<std::size_t>(scan.workingIndex(seed, "seed"))] = true;
  return is_seed;
}

/** What neighbors pay goes into the energy. */
void
addNeighbors(const PreparedScan& scan,
             const std::vector<BoundaryPoint>& boundary,
             const std::vector<std::uint32_t>& labels,
             const NearestNeighbors& neighbors,
             const CleaningSettings& settings,
             const ExecutionOptions& execution,
             LabelEnergy& energy)
{
  const std::vector<Eigen::Vector3f> normals =
      surfaceNormals(scan.working().points(), points_of_normal, execution);
  const NeighborPull pull(
      settings, normals, scan.working().costs().ofPairs(), scan.settings().color);
  linkNeighbors(boundary, labels, neighbors, pull, energy);
}

/** Give the points of the boundary the labels that are best for all of them. */
void
relabel(const std::vector<BoundaryPoint>& boundary,
        const LabelEnergy& energy,
        int most_cycles,
        std::vector<std::uint32_t>& labels)
{
  std::vector<std::uint32_t> at_boundary;
  for (const BoundaryPoint& each : boundary)
    at_boundary.push_back(labels[each.point]);
  at_boundary = lowerEnergy(energy, std::move(at_boundary), most_cycles);
  for (std::size_t i = 0; i < boundary.size(); ++i)
    labels[boundary[i].point] = at_boundary[i];
}

/** The labels of the points that are worked on, mended. */
std::vector<std::uint32_t>
cleanedLabels(const Grouping& grouping,
              const std::vector<std::uint32_t>& label_of_seed,
              const CleaningSettings& settings,
              const ExecutionOptions& execution)
{
  const WorkingPoints& points = grouping.scan().working();
  const int threads = threadCount(execution.threads);
  const std::vector<pcl::index_t> group =
      grouping.groupsOfWorkingPoints({execution.threads, {}});
  std::vector<std::uint32_t> labels = labelsOfGroups(group, label_of_seed);
  const NearestNeighbors neighbors(points.points(),
                                   share(execution, 0.0, neighbors_end));
  Progress progress(execution.progress);
  const std::vector<BoundaryPoint> boundary =
      findBoundaryPoints(points,
                         labels,
                         seedMarks(grouping),
                         settings.reach * medianReach(neighbors),
                         threads,
                         progress,
                         {neighbors_end, neighbors_end});
  if (boundary.empty())
    return labels;
  LabelEnergy energy;
  energy.choices = labelCosts(grouping,
                              label_of_seed,
                              group,
                              boundary,
                              settings.most_loss,
                              threads,
                              progress,
                              {neighbors_end, costs_end});
  addNeighbors(grouping.scan(),
               boundary,
               labels,
               neighbors,
               settings,
               share(execution, costs_end, normals_end),
               energy);
  relabel(boundary, energy, settings.most_cycles, labels);
  progress.check(1.0);
  return labels;
}

} // namespace

std::vector<std::uint32_t>
cleanBoundaries(const Grouping& grouping,
                const std::vector<std::uint32_t>& label_of_seed,
                const CleaningSettings& settings,
                const ExecutionOptions& execution)
{
  requireUsable(settings);
  if (label_of_seed.size() != grouping.numberOfSeeds())
    throw CIDException(sentence("there are ",
                                label_of_seed.size(),
                                " labels for ",
                                grouping.numberOfSeeds(),
                                " seeds; there must be one for each"));
  const PreparedScan& scan = grouping.scan();
  if (label_of_seed.empty())
    return std::vector<std::uint32_t>(scan.cloudSize(), 0);
  return scan.workingSet().carryOn(
      cleanedLabels(grouping, label_of_seed, settings, execution),
      scan.cloudSize(),
      std::uint32_t{0});
}

} // namespace pcl_cid
