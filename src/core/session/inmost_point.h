/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The point of a region that is farthest from what is outside.
 */

#pragma once

#include "field/block_tree.h"

#include <pcl_cid/core/execution.h>

#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief The point of a region that is farthest from all points outside; of several
 *  the one of lowest index. */
struct InmostPoint {
  pcl::index_t point = -1;
  /** To the nearest point outside, metres squared; infinite where there is none. */
  float squared_distance = -1.0f;
};

/** \brief Finds inmost points, by exact distances. It knows of each node of the tree
 *  whether all of its points are in one region, which a search then passes over. */
class InmostPoints {
public:
  /** \param[in] points must outlive this
   *  \param[in] tree of these points; must outlive this */
  InmostPoints(const Points& points, const BlockTree& tree);

  /** \brief That of each region.
   *  \param[in] regions disjoint, none empty, each ascending; points by their index
   *  among all
   *  \note Cost: about N log N. */
  std::vector<InmostPoint>
  of(const std::vector<pcl::Indices>& regions, unsigned int threads);

private:
  /** What a node has points of, where it is not one region. */
  static constexpr std::int32_t several = -1;

  void
  mark(const std::vector<pcl::Indices>& regions);

  std::int32_t
  regionOfBlock(std::size_t number) const;

  InmostPoint
  inmostOf(const pcl::Indices& region) const;

  void
  descend(std::size_t node,
          const Eigen::Array4f& p,
          std::int32_t own,
          float enough,
          float& nearest) const;

  void
  scan(std::size_t number,
       const Eigen::Array4f& p,
       std::int32_t own,
       float& nearest) const;

  const Points& points_;
  const BlockTree& tree_;
  std::vector<std::int32_t> region_;         ///< by point; 0 for none
  std::vector<std::int32_t> region_of_node_; ///< or several
};

} // namespace pcl_cid
