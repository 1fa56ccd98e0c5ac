/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What can be seen of a session, to compare two of them.
 */

#pragma once

#include <pcl_cid/core/label_session.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid::test {

/** All that can be seen of a session. */
struct SessionState {
  std::vector<std::uint32_t> labels;
  std::vector<pcl::index_t> groups;
  std::vector<SessionSeed> seeds;
  std::vector<NamedInstance> instances;
  std::vector<bool> painted;

  explicit SessionState(const LabelSession& session)
  : labels(session.labels())
  , groups(session.groups())
  , seeds(session.seeds())
  , instances(session.instances())
  {
    for (std::size_t i = 0; i < labels.size(); ++i)
      painted.push_back(session.isPainted(static_cast<pcl::index_t>(i)));
  }

  pcl::index_t
  seedOf(std::size_t point) const
  {
    const pcl::index_t group = groups[point];
    return group < 0 ? -1 : seeds[static_cast<std::size_t>(group)].point;
  }

  bool
  operator==(const SessionState& other) const
  {
    return labels == other.labels && groups == other.groups && seeds == other.seeds &&
           instances == other.instances && painted == other.painted;
  }
};

} // namespace pcl_cid::test
