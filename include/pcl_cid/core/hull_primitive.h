/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Boxes, balls and rods in the place of hulls.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/pcl_cid_export.h>

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief A simple body of which collision checkers know a formula. */
struct HullPrimitive {
  enum class Kind {
    box,
    sphere,
    cylinder, ///< about the third axis
    capsule   ///< a cylinder about the third axis with half a ball on either end
  };

  Kind kind = Kind::box;
  /** In the frame of the hull. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** Its axes as columns, a right-handed basis. */
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  /** From end to end along each axis, metres: the first is the diameter of what is
   *  round, the third the length of a cylinder or a capsule, its ends included. */
  Eigen::Vector3d extents = Eigen::Vector3d::Zero();

  double
  radius() const
  {
    return 0.5 * extents.x();
  }

  /** \brief Length of a capsule without its ends. */
  double
  straightLength() const
  {
    return extents.z() - extents.x();
  }
};

/** \brief "box", "sphere", "cylinder", "capsule". */
PCL_CID_EXPORT const char*
nameOf(HullPrimitive::Kind kind);

/** \brief Cubic metres. */
PCL_CID_EXPORT double
volumeOf(const HullPrimitive& primitive);

/** \brief A convex mesh around a primitive: the box itself; what is round, with faces
 *  that are outside of it by at most 1 % of its radius. */
PCL_CID_EXPORT TriangleMesh
meshAround(const HullPrimitive& primitive);

/** \brief Share of a hull's volume by which a primitive in its place may be larger. */
constexpr double primitive_share = 0.1;

/** \brief Which primitives may stand for hulls. */
struct PrimitiveOptions {
  std::vector<HullPrimitive::Kind> kinds = {HullPrimitive::Kind::box,
                                            HullPrimitive::Kind::sphere,
                                            HullPrimitive::Kind::cylinder,
                                            HullPrimitive::Kind::capsule};
  /** 0 or more. */
  double share = primitive_share;
  /** Asked besides, with meshAround() in the frame of the parts, from several threads
   *  at a time; empty: none is refused. */
  std::function<bool(const TriangleMesh& body)> may_replace;
};

/** \brief A primitive for each hull that is nearly one.
 *
 *  The smallest that is found of each kind holds the hull, and is hull_tolerance of the
 *  hull's diagonal larger on all sides, by which a hull may miss its points: it holds
 *  every point of its part, and the padding and the thickness of its hull are its own.
 *  The smallest of these that may replace the hull does.
 *  \param[in] parts their hulls closed and convex
 *  \param[in] frame of the scan that they are parts of
 *  \param[in] options see PrimitiveOptions
 *  \param[in] execution threads and progress; never change the result
 *  \return one for each part, in its frame; none where no primitive is good enough
 *  \throws CIDException when the share is below 0 or not a number, CIDCancelled
 *  \note Cost: O(F V) for V vertices and F faces. */
PCL_CID_EXPORT std::vector<std::optional<HullPrimitive>>
fitPrimitives(const std::vector<ConvexPart>& parts,
              const Frame& frame,
              const PrimitiveOptions& options = {},
              const ExecutionOptions& execution = {});

} // namespace pcl_cid
