/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How many places that a robot could use hulls refuse, and what else they get wrong.
 */

#pragma once

#include "convex_body.h"
#include "seen_space.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/point_set.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::benchmarks {

/** \brief What counts as a place. */
struct PlaceOptions {
  /** How near to a point or a hull the robot cannot be, metres, above 0. */
  double robot_radius = 0.15;
  /** How many places are drawn, at least 1. */
  std::size_t places = 20000;
  /** Of the draw, which is the same on every machine. */
  std::uint64_t random_seed = 1;
  /** Which space is free. */
  SightOptions sight;
};

/** \brief Points that are farther than these from every hull are counted, metres. */
constexpr std::array<double, 3> miss_distances{0.001, 0.01, 0.03};

/** \brief The figures of a set of hulls. */
struct RefusalFigures {
  std::size_t hulls = 0;
  /** Share of the places that are nearer than the radius to a hull, 0 to 1. */
  double refused = 0.0;
  /** Points of the scan outside of all hulls by more than each of miss_distances. */
  std::array<std::size_t, miss_distances.size()> missed{};
  /** Of the hulls, and of their union, cubic metres. */
  double volume_sum = 0.0;
  double union_volume = 0.0;
  /** Of the union's part in free voxels of SeenSpace, cubic metres. */
  double free_volume = 0.0;
  /** Largest distance to the points from the center of a free voxel that is in a hull,
   *  metres; 0 where there is none. */
  double deepest = 0.0;
};

/** \brief Measures hulls against the free space of a scan; made once for a scan.
 *
 *  A place is drawn evenly in the bounding box of the scan and kept when it is in
 *  SeenSpace and at least the radius from every point. Refused shares, missed points
 *  and the deepest place are exact; volumes are estimates from a quarter of a million
 *  samples, spread evenly over the hulls. The same figures for every number of
 *  threads. */
class RefusedPlaces {
public:
  /** \param[in] scan at least 1 point
   *  \param[in] viewpoints in the coordinates of the scan's file; none: all of the
   *  bounding box counts as seen
   *  \param[in] options see PlaceOptions
   *  \throws CIDException when there is no point, there are too many voxels, or so
   *  little free space that no places are found */
  RefusedPlaces(const PointSet& scan,
                const std::vector<Eigen::Vector3d>& viewpoints,
                const PlaceOptions& options);

  /** \param[in] hulls in the coordinates of the scan's file */
  RefusalFigures
  measure(const std::vector<ConvexPart>& hulls) const;

  const SeenSpace&
  space() const
  {
    return space_;
  }

  /** \brief In the frame of the scan. */
  const Points&
  places() const
  {
    return places_;
  }

private:
  bool
  isPlace(const Eigen::Vector3f& x) const;

  Points
  drawPlaces() const;

  double
  refusedShare(const std::vector<ConvexBody>& bodies) const;

  void
  countMissed(const std::vector<ConvexBody>& bodies, RefusalFigures& figures) const;

  void
  measureVolumes(const std::vector<TriangleMesh>& hulls,
                 const std::vector<ConvexBody>& bodies,
                 RefusalFigures& figures) const;

  double
  deepestIn(const std::vector<ConvexBody>& bodies) const;

  PlaceOptions options_;
  PointSet scan_;
  DistanceField field_;
  SeenSpace space_;
  Points places_;
};

} // namespace pcl_cid::benchmarks
