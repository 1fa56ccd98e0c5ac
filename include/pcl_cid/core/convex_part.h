/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * An approximately convex part of a cloud and its hull.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>
#include <pcl_cid/pcl_cid_export.h>

#include <array>
#include <cstdint>
#include <vector>

#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief A closed triangle mesh in the frame of the input cloud. */
struct TriangleMesh {
  /** Metres; double, so that UTM coordinates keep their millimetres. */
  std::vector<Eigen::Vector3d> vertices;
  /** Three vertices each, counter-clockwise seen from outside. */
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/** \brief How hulls are made. */
struct ConvexPartOptions {
  /** Least width of a hull over its face normals, metres, above 0. Thinner parts (a
   *  wall is one) are thickened, symmetric about their points. */
  double min_thickness = 0.005;
};

/** \brief A part and its convex hull. */
struct ConvexPart {
  /** Indices of its points in the input cloud, ascending. */
  pcl::Indices indices;
  /** Contains every point of the part, to within 1e-5 of the hull's diagonal. */
  TriangleMesh hull;
  /** Of the hull, cubic metres. */
  double volume = 0.0;
  /** Of the hull's surface, square metres. */
  double area = 0.0;
  /** Least width of the hull over its face normals, metres. */
  double thickness = 0.0;
  /** The points alone were thinner than `min_thickness`. */
  bool thickened = false;
  /** qhull failed and the hull is the oriented bounding box. */
  bool boxed = false;
};

/** \brief The hull of a part, computed by pcl::ConvexHull.
 *
 *  Works for 1, 2, collinear, coplanar and repeated points, too: what is thinner than
 *  `min_thickness` along a principal axis is first widened along it, so qhull only ever
 *  sees distinct points around zero that fill space.
 *  \param[in] points local points with their origin and their indices in the input
 *  \param[in] members positions in \a points of the part's points; at least 1
 *  \param[in] options see ConvexPartOptions
 *  \throws CIDException when the part is empty or min_thickness is not above 0
 *  \note Cost: O(n log n). Thread safety: as qhull_r, safe for separate calls. */
PCL_CID_EXPORT ConvexPart
makeConvexPart(const PointSet& points,
               const pcl::Indices& members,
               const ConvexPartOptions& options);

/** \brief The hulls of all parts, part numbers ascending.
 *  \param[in] points local points with their origin and their indices in the input
 *  \param[in] part number of the part of each of \a points, -1 for none; every number
 *  from 0 to the largest occurs
 *  \param[in] options see ConvexPartOptions
 *  \param[in] execution threads and progress; never changes the result
 *  \throws CIDException, CIDCancelled */
PCL_CID_EXPORT std::vector<ConvexPart>
makeConvexParts(const PointSet& points,
                const std::vector<int>& part,
                const ConvexPartOptions& options,
                const ExecutionOptions& execution);

} // namespace pcl_cid
