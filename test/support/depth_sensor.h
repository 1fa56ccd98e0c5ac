/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A simulated depth sensor that looks at a test room from several positions.
 */

#pragma once

#include <cstddef>
#include <cstdint>

#include "labelled_scan.h"
#include "room_scene.h"

namespace pcl_cid::test {

/** \brief How a room is looked at. Lengths in metres. */
struct SensorOptions {
  /// Draws positions, orientations and noise.
  std::uint64_t seed = 0;
  std::size_t points = 140000;
  /// Places that the sensor looks from, 1 to 255.
  unsigned positions = 4;
  /// Heights at which it stands.
  Range height{1.1, 1.8};
  /// It looks from this sine of the elevation, below -1 as far down as one can ...
  double min_elevation_sine = -2.0;
  /// ... up to this one.
  double max_elevation_sine = 0.5;
  /// Standard deviation along the ray at range r: noise r^2. 0 is a perfect sensor; a
  /// Kinect has about 0.0015 per metre.
  double noise = 0.0015;
  /// Surfaces nearer or farther than this are not seen.
  Range range{0.4, 10.0};
  /// Surfaces that the ray only grazes are not seen: least cosine of incidence.
  double min_incidence_cosine = 0.08;
};

/** \brief Looks at \a scene through a panorama of six square images, in an orientation
 *  drawn for each position, and merges what is seen in the room's frame. The density
 *  falls with the square of the range and with the angle of incidence.
 *
 *  The noise has draws of its own: the same options with and without noise give the
 *  same points in the same order, moved along their rays.
 *  \param[in] scene the room
 *  \param[in] options the sensor
 *  \return exactly options.points points, by position, image and row; the same on
 *  every machine
 *  \throw CIDException when an option is out of range, when no free place for the
 *  sensor is found, or when it sees nothing
 *  \note Cost: about a microsecond a point. */
LabelledScan
scanRoom(const RoomScene& scene, const SensorOptions& options);

} // namespace pcl_cid::test
