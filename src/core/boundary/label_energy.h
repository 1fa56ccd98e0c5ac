/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What labels cost points and neighbors, as whole numbers.
 */

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief Metres as a whole number of 2^-20 metres, rounded to the nearest. */
inline std::int64_t
wholeUnits(double metres)
{
  return std::llround(metres * 0x1p20);
}

/** \brief The sum of what each of some sites pays for its label, and of what pairs of
 *  them pay for different ones. Whole numbers: no order of the sums matters. */
struct LabelEnergy {
  /** A label that a site may have. */
  struct Choice {
    std::uint32_t label;
    std::int64_t cost; ///< 0 or more
  };

  /** Two sites, first < second. */
  struct Link {
    std::size_t first;
    std::size_t second;
    std::int64_t half; ///< of what different labels cost; above 0
  };

  std::vector<std::vector<Choice>> choices; ///< of each site, by label, at least 1
  std::vector<Link> links;                  ///< no pair twice
};

/** \brief The energy of labels, each of which must be a choice of its site. */
std::int64_t
energyOf(const LabelEnergy& energy, const std::vector<std::uint32_t>& labels);

/** \brief Lower the energy by alpha expansion: label by label, in ascending order, the
 *  best set of sites takes the label, the smallest of equally good ones; until no label
 *  gains any. With two labels that is the minimum, with more it is at most twice that.
 *  \param[in] labels to begin with, each a choice of its site
 *  \param[in] most_cycles through all labels, 0 or more
 *  \return labels whose energy is at most that of the given ones
 *  \note Cost: one minimum cut for a label, over the sites that may take it, whenever
 *  something near them has changed since the last one. */
std::vector<std::uint32_t>
lowerEnergy(const LabelEnergy& energy,
            std::vector<std::uint32_t> labels,
            int most_cycles);

} // namespace pcl_cid
