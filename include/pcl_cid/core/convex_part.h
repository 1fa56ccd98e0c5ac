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
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <array>
#include <cstddef>
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

/** \brief Share of a hull's diagonal by which it may miss a point of its part, and by
 *  which a vertex may stick out of the plane of a face. */
constexpr double hull_tolerance = 1e-5;

/** \brief How hulls are made. */
struct ConvexPartOptions {
  /** Least width of a hull over all directions, metres, 1e-15 to 1e15. Thinner parts (a
   *  wall is one) are thickened, symmetric about their points. A hull cannot be thinner
   *  than 1e-5 of its diagonal, nor than 1e-10 of its coordinates, so that is the least
   *  when it is more. */
  double min_thickness = setting::min_thickness.initial;
  /** Most vertices of a hull, at least 4; 0 for any number. A hull with more is
   *  replaced by a simpler body around it. */
  std::size_t max_vertices = setting::max_vertices.initial;
  /** How far a hull reaches beyond the one without padding, at least, in all
   *  directions: metres, 0 or more. At most it is sqrt(3) times as far. */
  double padding = setting::padding.initial;
  /** Points of a part are linked when they are at most so far apart, metres; those that
   *  no links join to the bulk of the part are trimmed. 0: none is. A few times the
   *  spacing of the points. */
  double trim_distance = setting::trim_distance.initial;
};

/** \brief Refuse options that are out of their range.
 *  \throws CIDException with a sentence that says which, and what is allowed */
PCL_CID_EXPORT void
requireValid(const ConvexPartOptions& options);

/** \brief A part and its convex hull. */
struct ConvexPart {
  /** Indices of its points in the input cloud, ascending. */
  pcl::Indices indices;
  /** Indices of the stray points that were trimmed from it, ascending: the hull need
   *  not contain them. */
  pcl::Indices trimmed;
  /** Contains every point of `indices`, to within hull_tolerance. */
  TriangleMesh hull;
  /** Of the hull, cubic metres. */
  double volume = 0.0;
  /** Of the hull's surface, square metres. */
  double area = 0.0;
  /** Least width of the hull over all directions, metres. */
  double thickness = 0.0;
  /** The points alone were thinner than `min_thickness`. */
  bool thickened = false;
  /** qhull failed and the hull is the oriented bounding box (a tetrahedron around it
   *  for fewer than 8 vertices). */
  bool boxed = false;
};

/** \brief The hull of a part, computed by pcl::ConvexHull.
 *
 *  Works for 1, 2, collinear, coplanar and repeated points, too: what is thinner than
 *  `min_thickness` along a principal axis becomes a slab of that thickness, so qhull
 *  only ever sees points that fill space. findBrokenGuarantee() (hull_guarantees.h)
 *  checks what is promised.
 *
 *  Stray points: the links of `trim_distance` make clusters; a cluster is trimmed when
 *  the largest one has more than 100 times its points.
 *  \param[in] points local points with their frame and their indices in the input
 *  \param[in] members positions in \a points of the part's points; at least 1
 *  \param[in] options see ConvexPartOptions
 *  \throws CIDException when the part is empty or an option is out of its range
 *  \note Cost: O(n log n); with V vertices and T triangles of the hull, O(V T) for its
 *  thickness and O(max_vertices^2 T) when it is reduced. Thread safety: as qhull_r,
 *  safe for separate calls. */
PCL_CID_EXPORT ConvexPart
makeConvexPart(const PointSet& points,
               const pcl::Indices& members,
               const ConvexPartOptions& options);

/** \brief The hulls of all parts, part numbers ascending.
 *  \param[in] points local points with their frame and their indices in the input
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
