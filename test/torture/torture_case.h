/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A small, nasty cloud with settings, all drawn from one number.
 */

#pragma once

#include <pcl_cid/cid_convex_abstraction.h>

#include <cstdint>
#include <ostream>
#include <string>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_cid::test {

using TorturePoint = pcl::PointXYZRGB;
using TortureCloud = pcl::PointCloud<TorturePoint>;

/** How parts are chosen by their hulls: settings that a user could give, good or not.
 */
struct FittingCase {
  bool is_checked; ///< else nothing is done with it
  /** The viewpoints may be no positions, and the bound too small for the thickness. */
  HullFittingSettings settings;
  bool has_parts;       ///< else the bound alone says how many, if there is one
  unsigned int threads; ///< of the second run
};

/** What a run is given. The same number makes the same case, on every machine. */
struct TortureCase {
  std::uint64_t number;
  std::string kind; ///< of cloud
  TortureCloud::Ptr cloud;
  TortureCloud::Ptr surface; ///< null: the points themselves
  pcl::IndicesPtr indices;   ///< null: all points
  PreparationSettings preparation;
  int seeds;
  float coverage;
  int samples;
  SeedingRule seeding;
  MergeCut cut;
  bool stop_at_cut;
  int group_samples;
  int min_points;
  ConvexPartOptions hull;
  bool own_search; ///< a KdTree for the surface
  FittingCase fitting;

  explicit TortureCase(std::uint64_t number);

  /** An object with all of it. */
  CIDConvexAbstraction<TorturePoint>
  abstraction(unsigned int threads) const;
};

/** The settings on lines, then the points. */
std::ostream&
operator<<(std::ostream& out, const TortureCase& one);

} // namespace pcl_cid::test
