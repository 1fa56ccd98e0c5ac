/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What neighbors near a boundary pay for different labels.
 */

#pragma once

#include "boundary_points.h"
#include "cid/pair_cost.h"
#include "label_energy.h"
#include "scan/nearest_neighbors.h"

#include <pcl_cid/core/label_cleaning.h>

#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief What two neighbors pay for different labels: less where normals or colors
 *  differ. */
class NeighborPull {
public:
  /** \param[in] normals of the points, 0 where there is none
   *  \param[in] costs whose colors count; may be null
   *  \param[in] color_weight what those colors are multiplied by
   *  \note The first three arguments are kept by reference. */
  NeighborPull(const CleaningSettings& settings,
               const std::vector<Eigen::Vector3f>& normals,
               const PairCosts* costs,
               float color_weight);

  /** \brief In metres, symmetric to the bit. */
  double
  between(std::size_t p, std::size_t q) const;

private:
  double
  difference(std::size_t p, std::size_t q) const;

  const CleaningSettings& settings_;
  const std::vector<Eigen::Vector3f>& normals_;
  const Cue* colors_; ///< null without any
  double color_weight_;
};

/** \brief The points of the boundary and their neighbors, but for points that have
 *  none. */
std::vector<bool>
linkedPoints(const std::vector<BoundaryPoint>& boundary,
             const NearestNeighbors& neighbors);

/** \brief Link neighbors to each other, of whom one is among the nearest of the other:
 *  two points of the boundary by a link, one of them and any other by what labels that
 *  are not the other's cost it more.
 *  \param[in] labels of all points
 *  \param[in,out] energy its sites are \a boundary, with their choices */
void
linkNeighbors(const std::vector<BoundaryPoint>& boundary,
              const std::vector<std::uint32_t>& labels,
              const NearestNeighbors& neighbors,
              const NeighborPull& pull,
              LabelEnergy& energy);

} // namespace pcl_cid
