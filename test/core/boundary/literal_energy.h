/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The energy of labels near boundaries, word for word, in double precision.
 */

#pragma once

#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/label_cleaning.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid::test {

using Labels = std::vector<std::uint32_t>;

/** What cleanBoundaries() lowers, by searches of all points and the oracle's costs: for
 *  small clouds. All points must be worked on. */
class LiteralEnergy {
public:
  /** \param[in] propagated the labels of the points, as their seeds say */
  LiteralEnergy(const Grouping& grouping,
                const Labels& label_of_seed,
                const Labels& propagated,
                const CleaningSettings& settings);

  /** The labels that a point may have: its own alone unless it is free. */
  const std::vector<Labels>&
  options() const
  {
    return options_;
  }

  std::size_t
  freePoints() const;

  /** \param[in] labels of all points, each one of its options */
  double
  of(const Labels& labels) const;

  /** What rounding may change about an energy. */
  double
  tolerance() const;

private:
  struct Link {
    std::size_t p;
    std::size_t q;
    double pull;
  };

  std::vector<Labels> options_;
  std::vector<std::vector<double>> losses_; ///< of each option
  std::vector<Link> links_;
  double tolerance_of_cost_;
};

/** The smallest energy of all labelings by some options. */
double
leastEnergy(const LiteralEnergy& energy, const std::vector<Labels>& options);

} // namespace pcl_cid::test
