/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Upright boxes, rectangles, cylinders and capsules: the solids of a test room.
 */

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::test {

/** \brief A frame in plan: where its origin lies and where its x axis points (unit
 *  length). Its y axis is 90 degrees to the left, z stays up. */
struct Pose {
  Eigen::Vector2d origin{0.0, 0.0};
  Eigen::Vector2d axis{1.0, 0.0};
};

enum class Shape { box, cylinder, capsule };

/** \brief A solid that stands upright, turned about z only. A box with one zero extent
 *  is a rectangle. */
struct Primitive {
  Shape shape = Shape::box;
  Eigen::Vector3d center{0.0, 0.0, 0.0};
  /// Half extents along the own axes in metres; cylinder and capsule have their radius
  /// in x and y, and a capsule is at least as high as it is wide (a ball: just so).
  Eigen::Vector3d half{0.0, 0.0, 0.0};
  /// The own x axis in plan, unit length.
  Eigen::Vector2d axis{1.0, 0.0};
  std::uint32_t instance = 0;
};

/** \brief Sums in a fixed order: Eigen's own dot product may reorder them with the
 *  width of the machine's vectors, and scans must be the same on every machine. */
inline double
dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/** \brief \a vector, given in the frame whose x axis is \a axis, in the outer frame. */
Eigen::Vector2d
rotated(const Eigen::Vector2d& vector, const Eigen::Vector2d& axis);

/** \brief \a inner, given in the frame \a outer, in the frame of \a outer. */
Pose
composed(const Pose& outer, const Pose& inner);

/** \brief A box from its six sides; low == high in one of them makes a rectangle. */
Primitive
makeBox(double x0, double x1, double y0, double y1, double z0, double z1);

/** \brief A vertical cylinder. */
Primitive
makeCylinder(double x, double y, double radius, double z0, double z1);

/** \brief A vertical cylinder with half balls for ends, within its length. */
Primitive
makeCapsule(double x, double y, double radius, double z0, double z1);

/** \brief \a primitive, given in the frame \a pose raised by \a z, in the outer frame.
 */
Primitive
moved(Primitive primitive, const Pose& pose, double z = 0.0);

/** \brief A point of the room in the primitive's own frame, and a direction too. */
Eigen::Vector3d
toLocal(const Primitive& primitive, const Eigen::Vector3d& point);
Eigen::Vector3d
directionToLocal(const Primitive& primitive, const Eigen::Vector3d& direction);

/** \brief A point of the primitive's own frame in the room. */
Eigen::Vector3d
toWorld(const Primitive& primitive, const Eigen::Vector3d& local);

/** \brief The point of a capsule's core (what is one radius inside of it) nearest to
 *  \a local, in its own frame. */
Eigen::Vector3d
nearestOfCore(const Primitive& capsule, const Eigen::Vector3d& local);

/** \brief Distance from \a point to the solid, 0 inside. */
double
distanceTo(const Primitive& primitive, const Eigen::Vector3d& point);

/** \brief Whether two solids come closer than \a gap in plan while their heights
 *  overlap; standing on each other is no overlap. Round solids count as their boxes. */
bool
overlap(const Primitive& a, const Primitive& b, double gap);

/** \brief Half extents of the box along x, y, z of the room around \a primitive. */
Eigen::Vector3d
boundingHalf(const Primitive& primitive);

/** \brief Where a ray meets a primitive. */
struct SurfaceHit {
  double range;            ///< from the origin, in lengths of the direction
  double incidence_cosine; ///< |cos| of the angle to the normal, for a unit direction
};

/** \brief The first meeting of a ray that starts outside of the solid.
 *  \param[in] primitive what may be hit
 *  \param[in] origin start of the ray
 *  \param[in] direction its direction, unit length
 *  \param[out] hit filled when the answer is true
 *  \return whether the ray meets the surface ahead of its origin */
bool
intersect(const Primitive& primitive,
          const Eigen::Vector3d& origin,
          const Eigen::Vector3d& direction,
          SurfaceHit& hit);

} // namespace pcl_cid::test
