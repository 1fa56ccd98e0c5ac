/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 1 on a prepared scan by nothing but its definitions, in float.
 */

#include "literal_grouping.h"

#include "grouping/connected_groups.h"

#include "cid/working_points.h"
#include "scan/working_set.h"

#include <pcl_cid/core/concavity.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl_cid::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

bool
sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

} // namespace

bool
GroupingState::operator==(const GroupingState& other) const
{
  return groups == other.groups && sameBits(cids, other.cids) &&
         sameBits({coverage}, {other.coverage});
}

LiteralGrouping::LiteralGrouping(const PreparedScan& scan, int samples)
: scan_(scan)
, points_(scan.working().points())
, samples_(samples)
, isolated_(points_.size(), 0)
, no_candidate_(points_.size(), scan.candidates().empty() ? 0 : 1)
, group_(points_.size(), -1)
, cid_(points_.size(), std::numeric_limits<float>::infinity())
{
  const BlockTree& tree = scan.field().blocks();
  for (std::size_t b = 0; b < tree.size(); ++b)
    for (int row = 0; row < tree.block(b).count; ++row)
      surface_.push_back(tree.block(b).point(row));
  for (const pcl::index_t i : scan.isolated())
    isolated_[static_cast<std::size_t>(i)] = 1;
  for (const pcl::index_t i : scan.candidates())
    no_candidate_[static_cast<std::size_t>(i)] = 0;
}

void
LiteralGrouping::add(pcl::index_t seed)
{
  const auto number = static_cast<pcl::index_t>(seeds_.size());
  seeds_.push_back(static_cast<std::size_t>(scan_.workingIndex(seed, "seed")));
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (const float cost = costOf(seeds_.back(), i); cost < cid_[i]) {
      cid_[i] = cost;
      group_[i] = number;
    }
}

GroupingState
LiteralGrouping::state() const
{
  std::vector<pcl::index_t> group = group_;
  for (std::size_t k = 0; k < seeds_.size(); ++k) // a seed keeps its point
    group[seeds_[k]] = static_cast<pcl::index_t>(k);
  if (scan_.graph()) {
    Progress silent(nullptr);
    ConnectedGroups connected(*scan_.graph(), scan_.working(), samples_);
    group = connected.connect(
        pcl::Indices(seeds_.begin(), seeds_.end()), std::move(group), 1, silent);
  }
  const WorkingSet& set = scan_.workingSet();
  return {set.carryOn(group, scan_.cloudSize(), pcl::index_t{-1}),
          set.carryOn(cid_, scan_.cloudSize(), nan),
          coverage()};
}

float
LiteralGrouping::coverage() const
{
  float coverage = 0.0f;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!isolated_[i])
      coverage = std::max(coverage, cid_[i]);
  return coverage;
}

pcl::index_t
LiteralGrouping::next(const SoftDraw* draw) const
{
  float largest = -1.0f;
  pcl::index_t next = -1;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const float value = cid_[i] * (draw ? draw->factor(i) : 1.0f);
    if (value > largest && !isolated_[i] && !no_candidate_[i] &&
        cid_[i] > costOf(i, i)) {
      largest = value;
      next = scan_.workingSet().cloudIndexOf(static_cast<pcl::index_t>(i));
    }
  }
  return next;
}

float
LiteralGrouping::distance(const Eigen::Vector3f& x) const
{
  float smallest = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& p : surface_) {
    const Eigen::Vector3f d = x - p;
    smallest = std::min(smallest, (d.x() * d.x() + d.y() * d.y()) + d.z() * d.z());
  }
  return std::sqrt(smallest);
}

float
LiteralGrouping::costOf(std::size_t seed, std::size_t point) const
{
  float cid = 0.0f; // Eq. 2
  for (int l = 0; l < samples_; ++l)
    cid = std::max(cid,
                   distance(segmentSample(points_[seed], points_[point], l, samples_)));
  return scan_.working().costs().between(seed, point).of(cid);
}

} // namespace pcl_cid::test
