/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * d(x; S): the distance from anywhere to the surface.
 */

#pragma once

#include <pcl_cid/core/point_set.h>
#include <pcl_cid/pcl_cid_export.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>

namespace pcl_cid {

/** \brief The distance d(x; S) = min over k of |x - p_k| to a finite set of points S,
 * the *search surface* of the paper (section III.A).
 *
 *  Exact: the float nearest to the minimum over all points of the float squared
 *  distance, whatever the search method. 1-Lipschitz in x.
 *  Cost: O(log |S|) a query. Thread safety: const calls may run concurrently. */
class PCL_CID_EXPORT DistanceField {
public:
  /** \brief Who answers a nearest-neighbour query. It is given the surface with
   *  setInputCloud(), must be exact, and safe for concurrent queries. */
  using Search = pcl::search::Search<pcl::PointXYZ>;

  /** \brief Build the field of a surface.
   *  \param[in] surface finite points, relative to a local origin (see PointSet),
   * metres \param[in] search null for pcl::search::KdTree, which is pcl::KdTreeFLANN
   *  \throws CIDException when the surface is empty */
  explicit DistanceField(const Points& surface, Search::Ptr search = nullptr);

  /** \brief d(x; S), in the unit of the coordinates. */
  float
  distance(const Eigen::Vector3f& x) const;

  /** \brief The index in the surface of a point at distance d(x; S) from x. */
  pcl::index_t
  nearest(const Eigen::Vector3f& x) const;

  /** \brief Number of points of the surface. */
  std::size_t
  size() const
  {
    return surface_->size();
  }

private:
  pcl::PointCloud<pcl::PointXYZ>::Ptr surface_;
  Search::Ptr search_;
};

} // namespace pcl_cid
