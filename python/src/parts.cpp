/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * From a request to convex parts.
 */

#include "parts.h"

#include <pcl_cid/io/mesh_export.h>

namespace pcl_cid::python {
namespace {

void
configure(const PartRequest& request, PartMaker& maker)
{
  maker.resetMergeCut();
  if (request.cut.rule == MergeCut::Rule::parts)
    maker.setNumberOfParts(static_cast<int>(request.cut.count));
  if (request.cut.rule == MergeCut::Rule::threshold)
    maker.setMergeThreshold(request.cut.height);
  if (request.cut.rule == MergeCut::Rule::merges)
    maker.setNumberOfMerges(static_cast<int>(request.cut.count));
  maker.setGroupSampleSize(request.settings.group_samples);
  maker.setMinPoints(request.settings.min_points);
  maker.setHullOptions(request.settings.hulls);
  maker.setMergingRule(request.rule);
  maker.setRobotRadius(request.settings.robot_radius);
  maker.setViewpoints(request.viewpoints);
  if (request.max_error)
    maker.setMaxError(*request.max_error);
}

std::vector<ConvexPart>
fittedParts(const Scan& scan, PartMaker& maker, const ExecutionOptions& execution)
{
  const PreparedScan& prepared = *scan.prepared();
  const std::vector<int> part = maker.fitParts(prepared, partOf(execution, 0.0, 0.9));
  return maker.makeParts(prepared, part, partOf(execution, 0.9, 1.0));
}

std::vector<ConvexPart>
mergedParts(const Scan& scan,
            const Seeding& seeding,
            const PartSettings& settings,
            PartMaker& maker,
            const ExecutionOptions& execution)
{
  const std::vector<int> cut = mergeAndCut(scan,
                                           seeding,
                                           settings.groups,
                                           settings.seeds,
                                           maker,
                                           partOf(execution, 0.0, 0.9));
  seeding.keep(maker);
  const SmoothPatches::ConstPtr& patches = maker.getPatches();
  const auto groups =
      patches ? std::make_shared<const std::vector<pcl::index_t>>(patches->groups())
              : seeding.groups(partOf(execution, 0.9, 0.9));
  return maker.makeParts(*scan.prepared(),
                         maker.partOfEachPoint(*groups, cut),
                         partOf(execution, 0.9, 1.0));
}

} // namespace

std::vector<int>
mergeAndCut(const Scan& scan,
            const Seeding& seeding,
            GroupRule groups,
            const std::optional<int>& seeds,
            PartMaker& maker,
            const ExecutionOptions& execution)
{
  if (groups == GroupRule::cid)
    return maker.cutGroups(seeding.grouping(), execution);
  return maker.cutPatches(scan.prepared(),
                          seeds.value_or(setting::seeds.initial),
                          scan.settings().grouping.samples,
                          execution);
}

std::vector<ConvexPart>
makeParts(const Scan& scan,
          const PartRequest& request,
          const ExecutionOptions& execution)
{
  const std::shared_ptr<const Seeding> seeding = scan.seeding();
  const bool by_hull = request.rule == MergingRule::hull;
  const double made = request.fewest_vertices ? 0.7 : 1.0; // of the progress
  PartMaker maker = by_hull ? PartMaker() : seeding->partMaker();
  configure(request, maker);
  const ExecutionOptions making = partOf(execution, 0.0, made);
  std::vector<ConvexPart> parts =
      by_hull ? fittedParts(scan, maker, making)
              : mergedParts(scan, *seeding, request.settings, maker, making);
  if (request.fewest_vertices)
    maker.simplifyParts(scan.prepared(),
                        partOf(execution, made, 0.8),
                        partOf(execution, 0.8, 1.0),
                        parts);
  moveToFile(scan.frame(), parts);
  return parts;
}

} // namespace pcl_cid::python
