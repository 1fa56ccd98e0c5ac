/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 1 on a prepared scan by nothing but its definitions, in float.
 */

#pragma once

#include "grouping/soft_draw.h"

#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/prepared_scan.h>

#include <vector>

namespace pcl_cid::test {

/** What a grouping says of its points. */
struct GroupingState {
  std::vector<pcl::index_t> groups;
  std::vector<float> cids;
  float coverage;

  explicit GroupingState(const Grouping& grouping)
  : groups(grouping.groups()), cids(grouping.cids()), coverage(grouping.coverage())
  {
  }

  GroupingState(std::vector<pcl::index_t> groups,
                std::vector<float> cids,
                float coverage)
  : groups(std::move(groups)), cids(std::move(cids)), coverage(coverage)
  {
  }

  /** To the bit. */
  bool
  operator==(const GroupingState& other) const;
};

/** Each point with its nearest seed: every distance to every point of the surface,
 * every sample, every pair. The library must agree to the bit. */
class LiteralGrouping {
public:
  LiteralGrouping(const PreparedScan& scan, int samples);

  /** \param[in] seed an index of the cloud */
  void
  add(pcl::index_t seed);

  GroupingState
  state() const;

  /** r_k. */
  float
  coverage() const;

  /** "argmax D_min": an index of the cloud, -1 when no candidate gains.
   *  \param[in] draw null: the farthest */
  pcl::index_t
  next(const SoftDraw* draw) const;

private:
  float
  distance(const Eigen::Vector3f& x) const;

  float
  costOf(std::size_t seed, std::size_t point) const;

  const PreparedScan& scan_;
  const Points& points_;
  int samples_;
  Points surface_;
  std::vector<char> isolated_, no_candidate_;
  std::vector<std::size_t> seeds_;
  std::vector<pcl::index_t> group_;
  std::vector<float> cid_;
};

} // namespace pcl_cid::test
