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

/** The points that are worked on, as their seeds label them. */
struct LabelledPoints {
  const Grouping& grouping;
  const std::vector<std::uint32_t>& label_of_seed;
  std::vector<pcl::index_t> group;
  std::vector<std::uint32_t> labels;

  const WorkingPoints&
  points() const
  {
    return grouping.scan().working();
  }
};

/** What labels cost the points of the boundary, and what neighbors pay. */
LabelEnergy
energyNear(const std::vector<BoundaryPoint>& boundary,
           const LabelledPoints& labelled,
           const NearestNeighbors& neighbors,
           const CleaningSettings& settings,
           const ExecutionOptions& execution)
{
  LabelEnergy energy;
  Progress progress(execution.progress);
  energy.choices = labelCosts(labelled.grouping,
                              labelled.label_of_seed,
                              labelled.group,
                              boundary,
                              settings.most_loss,
                              threadCount(execution.threads),
                              progress,
                              {neighbors_end, costs_end});
  const std::vector<Eigen::Vector3f> normals =
      surfaceNormals(labelled.points().points(),
                     neighbors,
                     partOf(execution, costs_end, normals_end),
                     linkedPoints(boundary, neighbors));
  const NeighborPull pull(settings,
                          normals,
                          labelled.points().costs().ofPairs(),
                          labelled.grouping.scan().settings().color);
  linkNeighbors(boundary, labelled.labels, neighbors, pull, energy);
  return energy;
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

/** Mend the labels of the points that are worked on. */
void
clean(LabelledPoints& labelled,
      const CleaningSettings& settings,
      const ExecutionOptions& execution)
{
  const NearestNeighbors neighbors(labelled.points().points(),
                                   partOf(execution, 0.0, neighbors_end),
                                   NearestNeighbors::most);
  Progress progress(execution.progress);
  const std::vector<BoundaryPoint> boundary =
      findBoundaryPoints(labelled.points(),
                         labelled.labels,
                         seedMarks(labelled.grouping),
                         settings.reach * medianReach(neighbors),
                         threadCount(execution.threads),
                         progress,
                         {neighbors_end, neighbors_end});
  if (!boundary.empty())
    relabel(boundary,
            energyNear(boundary, labelled, neighbors, settings, execution),
            settings.most_cycles,
            labelled.labels);
  progress.check(1.0);
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
  LabelledPoints labelled{grouping, label_of_seed, {}, {}};
  labelled.group = grouping.groupsOfWorkingPoints({execution.threads, {}});
  labelled.labels = labelsOfGroups(labelled.group, label_of_seed);
  clean(labelled, settings, execution);
  return scan.workingSet().carryOn(labelled.labels, scan.cloudSize(), std::uint32_t{0});
}

} // namespace pcl_cid
