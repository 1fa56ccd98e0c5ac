/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The guarantees of a hull, checked on its mesh alone.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief How far a coordinate of a mesh may move when it is written as a float,
 *  metres: half of the last place of its largest coordinate. */
PCL_CID_EXPORT double
floatRounding(const TriangleMesh& mesh);

/** \brief The same for a coordinate of this size. */
PCL_CID_EXPORT double
floatRounding(double size);

/** \brief The first guarantee of a hull that does not hold.
 *
 *  1. A closed surface of triangles like a sphere's (V - E + F = 2): each edge occurs
 *     once in either direction, no vertex is unused, no triangle is degenerate (lower
 *     than 1e-7 of the diagonal), normals point outward.
 *  2. Convex: no vertex is more than hull_tolerance outside the plane of a face.
 *  3. Every point is inside, by at least `padding`, to within hull_tolerance.
 *  4. At least `min_thickness` (1 - hull_tolerance) thick in every direction.
 *  5. At most `max_vertices` vertices.
 *
 *  None of the code that makes hulls is used. Rounding coordinates, in a file or by a
 *  shift to a far origin, moves a plane by more than the rounding where it is
 *  extrapolated from a narrow triangle; what \a rounding explains is no violation.
 *  \param[in] hull the mesh, from makeConvexPart() or read from a file
 *  \param[in] points what it must contain, in the same frame; may be empty
 *  \param[in] options what the hull was made with
 *  \param[in] rounding how far each coordinate of the hull or of a point may be off,
 *  metres: floatRounding() for a mesh from a float file. The rounding of double is
 *  always allowed for.
 *  \return a sentence that names the guarantee and the figures; nothing when all hold
 *  \throws CIDException when an option is out of its range
 *  \note Cost: O(F (V + n)) for n points, O(F^2) when no ball of the minimum thickness
 *  about the centroid shows that the hull is thick. */
PCL_CID_EXPORT std::optional<std::string>
findBrokenGuarantee(const TriangleMesh& hull,
                    const std::vector<Eigen::Vector3d>& points,
                    const ConvexPartOptions& options,
                    double rounding = 0.0);

/** \brief A point that a hull does not contain, the third guarantee. */
struct PCL_CID_EXPORT PointOutside {
  std::size_t point; ///< its place among those that were asked about
  double excess;     ///< how far it is too far out, metres
  double padding;    ///< that was asked for, metres
  double tolerance;  ///< that was allowed for, metres

  /** \brief The sentence of findBrokenGuarantee().
   *  \param[in] name what the point goes by, such as its index in a file */
  std::string
  sentenceAbout(std::size_t name) const;
};

/** \brief Whether a hull contains points: only the third guarantee, for points that
 *  come piece by piece. Arguments and errors are those of findBrokenGuarantee().
 *  \param[in] hull one whose surface is known to be right
 *  \return the first point outside; nothing when there is none
 *  \note Cost: O(F n). */
PCL_CID_EXPORT std::optional<PointOutside>
findPointOutside(const TriangleMesh& hull,
                 const std::vector<Eigen::Vector3d>& points,
                 const ConvexPartOptions& options,
                 double rounding = 0.0);

} // namespace pcl_cid
