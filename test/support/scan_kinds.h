/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The kinds of scans of a test room: how its points are chosen, and what their sensors
 * do to them.
 */

#pragma once

#include <cstddef>
#include <cstdint>

#include "labelled_scan.h"
#include "room_scene.h"

namespace pcl_cid::test {

enum class ScanKind {
  even,          ///< points drawn evenly by area
  sensor,        ///< a depth sensor from 3 to 6 places, as scanVariousRoom()
  merged,        ///< 3 to 5 scans of different density and exposure, not quite aligned
  mesh_vertices, ///< spaced as the vertices of a simplified mesh
  single_view,   ///< one image of a depth camera
  lidar          ///< a scanner on a tripod, which does not see what is below it
};

/** \brief The points of a scan of this kind, exactly on the surfaces.
 *  \return exactly \a points points; the same on every machine
 *  \throw CIDException when \a points is 0 or the sensor finds no place or no surface
 */
LabelledScan
choosePoints(const RoomScene& scene,
             ScanKind kind,
             std::size_t points,
             std::uint64_t seed);

/** \brief What makes a scan worse than the room. */
struct ScanErrors {
  /// Standard deviation of each point along its ray at range r: noise + per_square r^2,
  /// in metres; without sensors, noise along each axis.
  double noise = 0.0;
  double per_square = 0.0;
  /// Standard deviation of each axis of the shift of a position's scan, in metres; it
  /// is turned about z by up to half as many radians as well.
  double misalignment = 0.0;
  /// Standard deviation of each channel of a color, of 255.
  double color_noise = 0.0;
  /// Each position's colors are brightened or darkened by up to this share, and each of
  /// its channels by up to half of it.
  double exposure = 0.0;
};

/** \brief What is usual for this kind. */
ScanErrors
usualErrors(ScanKind kind);

/** \brief Moves points and, with their scan, its position; changes colors, if any.
 *  \param[in,out] scan points without noise
 *  \param[in] errors how far
 *  \param[in] seed of the draws, the same on every machine */
void
disturb(LabelledScan& scan, const ScanErrors& errors, std::uint64_t seed);

} // namespace pcl_cid::test
