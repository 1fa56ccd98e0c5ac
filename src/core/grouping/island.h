/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A piece of a group away from its seed.
 */

#pragma once

#include "base/infinity.h"
#include "scan/surface_graph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief A group that an island may go to. */
struct Offer {
  float cost = infinity;
  pcl::index_t group = -1;

  bool
  operator<(const Offer& right) const
  {
    return std::tie(cost, group) < std::tie(right.cost, right.group);
  }

  void
  renumber(const std::vector<pcl::index_t>& number)
  {
    if (group >= 0)
      group = number[static_cast<std::size_t>(group)];
  }
};

/** \brief Where an island meets another one. */
struct Meeting {
  using Vertex = SurfaceGraph::Vertex;

  Vertex other;        ///< the island
  std::uint32_t begin; ///< of the vertices beside it, in Island::borders
  /** What the other one offered last, which most often is what it offers again. */
  pcl::index_t seed = -1;
  float low = 0.0f; ///< at most the least cost of the seed and these vertices
  bool is_exact = false;

  bool
  tells(pcl::index_t of_seed, float limit) const
  {
    return seed == of_seed && (is_exact || low >= limit);
  }
};

/** \brief A piece without a seed, where it meets others, and what it is offered. */
struct Island {
  using Vertex = SurfaceGraph::Vertex;

  std::vector<Vertex> vertices;  ///< the lowest first
  std::vector<Meeting> meetings; ///< ascending
  std::vector<Vertex> borders;   ///< the vertices beside other islands, by meeting
  Offer of_mainland{};           ///< the best one
  Offer best{};                  ///< so far, of mainland or of islands that have joined
  bool is_open = false;          ///< it may be offered more

  Meeting&
  meetingWith(Vertex other)
  {
    return *std::lower_bound(
        meetings.begin(), meetings.end(), other, [](const Meeting& each, Vertex name) {
          return each.other < name;
        });
  }

  /** \param[in] sides an island and a vertex beside it, ascending */
  void
  meet(const std::vector<std::pair<Vertex, Vertex>>& sides)
  {
    for (const auto& [other, vertex] : sides) {
      if (meetings.empty() || meetings.back().other != other)
        meetings.push_back({other, static_cast<std::uint32_t>(borders.size())});
      borders.push_back(vertex);
    }
  }

  std::size_t
  endOf(const Meeting& meeting) const
  {
    return &meeting == &meetings.back() ? borders.size() : (&meeting + 1)->begin;
  }

  std::size_t
  bytes() const
  {
    return sizeof(*this) + sizeof(Vertex) * vertices.capacity() +
           sizeof(Meeting) * meetings.capacity() + sizeof(Vertex) * borders.capacity();
  }
};

} // namespace pcl_cid
