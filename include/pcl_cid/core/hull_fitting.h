/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts whose hulls leave free space free.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief How parts are chosen by their hulls. */
struct HullFittingSettings {
  /** Parts, K': at least 1. Fewer come out where that takes no place more, or where
   *  there are fewer points. The default leaves the number to the bound. */
  std::size_t parts = 1;
  /** T: no hull may hold a place that is farther from the scan's points(), CID_h <= T;
   *  metres, above 0. The default is no bound. */
  double max_error = std::numeric_limits<double>::infinity();
  /** Radius of the robot that the places are for, metres, 0 or more. A place is refused
   *  when a hull is nearer than this. */
  double robot_radius = setting::robot_radius.initial;
  /** Where the scan was taken from, in the frame of the input cloud. Only places that
   *  were seen from one of them count as free then, as nobody knows of the others;
   *  without viewpoints all count. */
  std::vector<Eigen::Vector3d> viewpoints;
  /** Least width of a hull (ConvexPartOptions), which the bound T makes allowance for:
   *  metres; raised to hull_tolerance of the scan's diagonal. */
  double min_thickness = setting::min_thickness.initial;

  bool
  hasBound() const
  {
    return max_error != std::numeric_limits<double>::infinity();
  }
};

/** \brief Parts of a scan, chosen by their hulls. */
struct HullFitting {
  /** The part of each of the scan's points(), numbered from 0 without gaps, in the
   * order of their first points. */
  std::vector<int> part;
  std::size_t parts = 0;
  /** Free places that were looked at, and those that the hulls refuse. */
  std::size_t free_places = 0;
  std::size_t refused_places = 0;
};

/** \brief Choose parts so that their hulls refuse as few free places as can be found
 *  (*ours*), where Algorithm 2 compares groups by average CID and never looks at the
 *  hull.
 *
 *  The scan is divided into many small cells, by planes, where that frees most places.
 *  Then neighbors are joined: always the two whose common hull takes the fewest places
 *  that were free until then, as long as CID_h keeps the bound. Points inside of
 * several hulls are given to one of them. This is done five times, each time from the
 * parts of the time before, and the best result is kept.
 *
 *  Free places are those of a grid that are at least `robot_radius` (and at least
 *  setting::free_distance) from every point, and were seen from a viewpoint. The bound
 * T is certified for all of space without viewpoints (hullCID); with them it holds for
 *  the places of a grid of at most T / 3.
 *  \param[in] scan all of its points() are parted, subsample or not
 *  \param[in] settings see HullFittingSettings
 *  \param[in] execution threads and progress; never change the result
 *  \throws CIDException for a setting out of its range, when a viewpoint is not finite,
 *  and when the bound needs more than 20000 hulls; CIDCancelled
 *  \note Cost: that of some ten thousand hulls of few points; about that of 100 seeds
 *  and their merges. Thread safety: may run concurrently on one scan. */
PCL_CID_EXPORT HullFitting
fitHulls(const PreparedScan& scan,
         const HullFittingSettings& settings,
         const ExecutionOptions& execution = {});

} // namespace pcl_cid
