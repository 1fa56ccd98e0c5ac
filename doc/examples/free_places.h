/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where a robot can be, and two places of it far apart.
 */

#pragma once

#include "scan_hulls.h"

#include <functional>
#include <vector>

#include <pcl/kdtree/kdtree_flann.h>

namespace planning {

using Place = Eigen::Vector3d;
using Places = std::vector<Place>;

/** \brief What a camera at the origin saw. */
class View {
public:
  /** \param[in] scan finite points */
  explicit View(const Cloud& scan);

  /** \brief Whether a ray of the camera went past a place: there is a point in the same
   * direction, farther away. */
  bool
  saw(const Place& place) const;

private:
  /** The points, moved to a distance of 1. */
  Cloud::Ptr directions_ = pcl::make_shared<Cloud>();
  std::vector<double> ranges_;
  pcl::KdTreeFLANN<pcl::PointXYZ> nearest_;
};

/** \brief A box, and which places in it are free. */
struct FreeSpace {
  Eigen::AlignedBox3d box;
  std::function<bool(const Place&)> isFree;
};

/** \brief Whether the straight way between two places is free, looked at in steps. */
bool
isStraightWayFree(const FreeSpace& space,
                  const Place& from,
                  const Place& to,
                  double step);

/** \brief The largest set of places of a grid that free ways along the grid connect;
 *  none where no place is free.
 *  \param[in] spacing of the grid
 *  \param[in] step of looking along a way */
Places
connectedPlaces(const FreeSpace& space, double spacing, double step);

/** \brief Where to go. */
struct Task {
  Place start;
  Place goal;
};

/** \brief A task that can be done and is not trivial: of the places of a grid, start
 * and goal are joined by free ways along the grid, far apart, and the straight way
 * between them is not free (if there is such a goal).
 *  \param[in] spacing of the grid
 *  \param[in] step of looking along a way
 *  \throws std::runtime_error when no place of the grid is free */
Task
chooseTask(const FreeSpace& space, double spacing, double step);

} // namespace planning
