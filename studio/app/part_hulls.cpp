/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls of the parts that a person looks at.
 */

#include "part_hulls.h"

#include "abstract/abstracted_scan.h"
#include "abstract/file_points.h"

#include <pcl_cid/core/hull_simplification.h>

namespace pcl_cid::studio {
namespace {

/** Which of the points of a scan are in each group. */
std::vector<pcl::Indices>
membersOfGroups(const PartSession& session)
{
  const Decomposition& decomposition = *session.decomposition();
  const pcl::Indices& source = session.scan().points().source;
  std::vector<pcl::Indices> members(decomposition.tree.numberOfGroups());
  for (std::size_t i = 0; i < source.size(); ++i) {
    const pcl::index_t group =
        decomposition.groups[static_cast<std::size_t>(source[i])];
    members[static_cast<std::size_t>(group)].push_back(static_cast<pcl::index_t>(i));
  }
  return members;
}

} // namespace

PartHulls::PartHulls(const tools::LoadedScan& scan,
                     const tools::AbstractSettings& settings)
: scan_(scan), settings_(settings)
{
}

const ConvexPart&
PartHulls::hullOf(const ChosenPart& part, const PartSession& session)
{
  return find(part, session).part;
}

const HullTightness&
PartHulls::tightnessOf(const ChosenPart& part, const PartSession& session)
{
  Hull& hull = find(part, session);
  if (!meter_) {
    TightnessOptions options;
    options.free_distance = settings_.free_distance;
    options.execution.threads = settings_.threads;
    meter_ = std::make_unique<TightnessMeter>(session.sharedScan(), options);
  }
  if (!hull.tightness)
    hull.tightness = meter_->measure({hull.part}).hulls.front();
  return *hull.tightness;
}

PartHulls::Hull&
PartHulls::find(const ChosenPart& part, const PartSession& session)
{
  use(session);
  const Key key{part.groups, part.exact};
  auto found = hulls_.find(key);
  if (found == hulls_.end())
    found = hulls_.emplace(key, Hull{make(part, session), {}}).first;
  return found->second;
}

/** Forget hulls of other groups. */
void
PartHulls::use(const PartSession& session)
{
  if (decomposition_ == session.decomposition())
    return;
  hulls_.clear();
  members_of_group_ = membersOfGroups(session);
  decomposition_ = session.decomposition();
}

ConvexPart
PartHulls::make(const ChosenPart& part, const PartSession& session) const
{
  pcl::Indices members;
  for (const int group : part.groups) {
    const pcl::Indices& more = members_of_group_[static_cast<std::size_t>(group)];
    members.insert(members.end(), more.begin(), more.end());
  }
  std::sort(members.begin(), members.end());
  const PointSet& points = session.scan().points();
  tools::AbstractedScan one;
  one.hull_options = settings_.hullOptions();
  one.is_exact = {part.exact};
  one.parts = {makeConvexPart(points, members, one.optionsOf(0))};
  coverFilePoints(scan_, one);
  if (settings_.fewest_vertices && !part.exact)
    simplifyHulls(one.parts, points.frame, nullptr);
  ConvexPart& made = one.parts.front();
  made.indices = pcl::Indices();
  made.trimmed = pcl::Indices();
  return std::move(made);
}

} // namespace pcl_cid::studio
