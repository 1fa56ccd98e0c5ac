/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which pairs of points represent two groups: Eq. 4 with spread draws.
 */

#pragma once

#include "base/random.h"
#include <pcl_cid/core/point_set.h>

#include <cstddef>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Draw points that are spread over all of a group: it is halved at its widest
 *  side, again and again, into as many cells of equal numbers of points (but for one)
 *  as are wanted, and one point is drawn from each. Cells that lie next to each other
 *  come one after the other.
 *  \param[in] points all points
 *  \param[in] members of the group
 *  \param[in] count wanted; all members when there are no more
 *  \param[in,out] generator advanced */
pcl::Indices
drawSpread(const Points& points,
           pcl::Indices members,
           std::size_t count,
           RandomGenerator& generator);

/** \brief A rank-1 lattice of n points in a square of n x n cells: point k is in column
 *  k and row k step() mod n, so one is in each column and one in each row, and they are
 *  spread over the square as evenly as multiples of the golden ratio are (Korobov's
 *  lattices; those of the Fibonacci numbers are the best known). */
class PairLattice {
public:
  /** \param[in] size n, at least 1 */
  explicit PairLattice(std::size_t size);

  std::size_t
  size() const
  {
    return size_;
  }

  /** \brief A number next to n over the golden ratio that shares no factor with n. */
  std::size_t
  step() const
  {
    return step_;
  }

  std::size_t
  row(std::size_t column) const
  {
    return column * step_ % size_;
  }

private:
  std::size_t size_;
  std::size_t step_ = 0;
};

} // namespace pcl_cid
