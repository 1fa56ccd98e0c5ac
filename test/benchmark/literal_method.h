/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID the literal way: Eq. 2 with one tree query a sample.
 */

#pragma once

#include "benchmark_cloud.h"

#include <pcl/kdtree/kdtree_flann.h>

namespace pcl_cid::benchmarks {

/** \brief CID_p as one would write it down from the paper: Eq. 2, each d(x; S) one
 *  pcl::KdTreeFLANN::nearestKSearch. What our times are compared with. */
class LiteralMethod {
public:
  /** \brief Build the tree. Points that are not finite are not part of the surface.
   *  \param[in] samples M, at least 2 */
  LiteralMethod(const Cloud::ConstPtr& surface, int samples);

  /** \brief CID_p of two points. Safe for concurrent calls. */
  float
  pointCID(const pcl::PointXYZ& p, const pcl::PointXYZ& q) const;

private:
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
  int samples_;
};

} // namespace pcl_cid::benchmarks
