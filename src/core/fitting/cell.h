/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Some points, their hull, and the free places that it takes.
 */

#pragma once

#include "free_space.h"
#include "hull/fast_hull.h"

#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief What every step of the fitting works with. */
struct FittingScene {
  const Points& points;
  const DistanceField& field;
  const FreeSpace& space;
  /** Places that no hull may hold; null: all of space that is farther from the scan
   * than max_error. */
  const FreeSpace* deep;
  /** Hulls are grown by this before their places are counted, metres. */
  double robot_radius;
  /** The bound T, metres; infinite for none. */
  double max_error;
  /** Least width of a hull, metres. */
  double thickness;
  int threads;

  /** \brief Whether the bound on the error is kept. */
  bool
  keepsBound(const FastHull& hull) const;
};

/** \brief Points with their hull, and the places near it. */
struct Cell {
  pcl::Indices points;
  FastHull hull;
  std::vector<PlaceRange> near;
};

/** \brief The cell of some points, at least one. */
Cell
makeCell(pcl::Indices points, const FittingScene& scene);

/** \brief Divide cells in two, by planes, where that frees most places; cells that
 *  break the bound on the error come first, whatever their number.
 *  \param[in] cells at least one
 *  \param[in] most no more are made, but for the sake of the bound
 *  \throws CIDException when the bound needs more than most_cells_for_bound */
std::vector<Cell>
divideCells(std::vector<Cell> cells,
            std::size_t most,
            const FittingScene& scene,
            Progress& progress);

/** \brief Join neighbors until so many parts are left or no join keeps the bound:
 * always the two whose hull takes the fewest places that were free until then. */
std::vector<Cell>
mergeCells(const std::vector<Cell>& cells,
           std::size_t parts,
           const FittingScene& scene,
           Progress& progress,
           ProgressSpan span);

/** \brief Points that are inside of several hulls stay in one of them; the other hulls
 *  shrink. The points of each cell are in order then. */
std::vector<Cell>
giveAway(std::vector<Cell> cells, const FittingScene& scene, Progress& progress);

/** \brief Free places near any of the cells. */
std::size_t
placesTaken(const std::vector<Cell>& cells, const FreeSpace& space);

} // namespace pcl_cid
