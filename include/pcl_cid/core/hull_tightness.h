/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How tightly hulls fit the scan that they represent.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Geometry>

namespace pcl_cid {

class Progress;

/** \brief How tightness is measured. */
struct TightnessOptions {
  /** Space that is farther than this from every point of the scan counts as free:
   *  metres, above 0. Choose it above the gaps between the points. */
  double free_distance = setting::free_distance.initial;
  /** Samples on the surface of each hull, and as many inside: at least 1. */
  std::size_t hull_samples = 4096;
  /** Samples in the bounding box of the scan: at least 1. */
  std::size_t box_samples = 1 << 18;
  /** Threads and progress; never change a figure. */
  ExecutionOptions execution;
};

/** \brief How far hulls stray from the scan, and how much free space they take. */
struct HullTightness {
  /** Largest and mean d(x; S) over samples x of the surface, metres: the *hull
   *  concavity*. The samples are even by area, one to each `area / hull_samples`. */
  double max_concavity = 0.0;
  double mean_concavity = 0.0;
  /** Share of the volume that is free space, 0 to 1. */
  double free_share = 0.0;
};

/** \brief The figures of a set of hulls. */
struct Tightness {
  /** Of each hull, in its own volume. */
  std::vector<HullTightness> hulls;
  /** Of all surfaces together, and of the volume of the hulls' union. */
  HullTightness all;
  /** Of the union of the hulls, within the bounding box of the scan, cubic metres. */
  double volume = 0.0;
  /** The part of it that is free space, cubic metres. */
  double free_volume = 0.0;
};

/** \brief Measures hulls against a scan; made once for a scan, used for any number of
 *  decompositions of it.
 *
 *  The volumes of the union are counted at the same points of the scan's bounding box
 *  each time. So they never fall when hulls grow: over the cuts of a merge tree, where
 *  a hull is replaced by one of more points, the free volume can only rise (up to the
 *  layer that thin hulls are thickened by, which a merge may take back). What a hull
 *  has outside that box (thickening, padding) is not counted.
 *
 *  Figures are estimates from evenly spread samples, the same on every run and for
 *  every number of threads. A volume is known to about the volume of the box over
 *  sqrt(`box_samples`), mostly better; the true largest concavity exceeds that of the
 *  samples by no more than the distance from anywhere on the surface to a sample.
 *  Thread safety: const calls may run concurrently. */
class PCL_CID_EXPORT TightnessMeter {
public:
  /** \param[in] scan the surface S, at least 1 point
   *  \param[in] options see TightnessOptions
   *  \throws CIDException when there is no point or an option is out of its range,
   *  CIDCancelled
   *  \note Cost: that of a DistanceField, and a query for each box sample. */
  TightnessMeter(const PointSet& scan, const TightnessOptions& options);

  /** \brief The same for all points of a prepared scan; its field is reused where its
   *  surface is exactly these points.
   *  \param[in] scan not null
   *  \throws CIDException when it is, or an option is out of its range, CIDCancelled */
  TightnessMeter(const PreparedScan::ConstPtr& scan, const TightnessOptions& options);

  /** \brief The figures of hulls in the frame of the input cloud of the scan.
   *  \throws CIDCancelled
   *  \note Cost: 2 `hull_samples` queries for each hull, and a test of each box sample
   *  with the hulls whose bounding box it is in. */
  Tightness
  measure(const std::vector<ConvexPart>& parts) const;

private:
  TightnessMeter(const PointSet& scan,
                 std::shared_ptr<const DistanceField> field,
                 const TightnessOptions& options);

  bool
  isFree(const Eigen::Vector3d& local) const;

  Eigen::Vector3d
  boxSample(std::size_t number) const;

  HullTightness
  tightnessOf(const TriangleMesh& local) const;

  void
  measureUnion(const std::vector<TriangleMesh>& local,
               Progress& progress,
               Tightness& tightness) const;

  TightnessOptions options_;
  Frame frame_;
  Eigen::AlignedBox3d box_;
  std::shared_ptr<const DistanceField> field_;
  std::vector<unsigned char> box_sample_is_free_;
};

} // namespace pcl_cid
