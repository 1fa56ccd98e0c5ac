/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Collects the pieces of a test room and refuses those that collide.
 */

#pragma once

#include <cstddef>
#include <vector>

#include "furniture.h"
#include "room_scene.h"

namespace pcl_cid::test {

/** \brief A room that grows piece by piece; each piece becomes an instance. */
class RoomBuilder {
public:
  explicit RoomBuilder(const Eigen::Vector3d& size);

  /** \brief Goes on with a room that has shell and furniture. */
  explicit RoomBuilder(RoomScene scene);

  const RoomScene&
  scene() const
  {
    return scene_;
  }

  /** \brief Adds \a piece without a test for collision: shell and openings. */
  void
  add(const Piece& piece, RoomClass room_class);

  /** \brief Tells of what small things can stand on in a bookcase. */
  void
  addShelves(const std::vector<Support>& shelves)
  {
    scene_.shelves.insert(scene_.shelves.end(), shelves.begin(), shelves.end());
  }

  /** \brief From here on pieces may touch all that was added before. */
  void
  closeShell()
  {
    shell_end_ = scene_.primitives.size();
  }

  /** \brief Adds \a piece if it lies within the room, out of the areas kept free, and
   *  at least \a gap in plan from what stands at the same height. */
  bool
  addIfFree(const Piece& piece, RoomClass room_class, double gap);

  /** \brief No later piece may reach into \a area. */
  void
  keepFree(const Primitive& area)
  {
    kept_free_.push_back(area);
  }

private:
  bool
  isInRoom(const Primitive& primitive) const;
  bool
  isFree(const Primitive& primitive, double gap) const;

  RoomScene scene_;
  std::size_t shell_end_ = 0;
  std::vector<Primitive> kept_free_;
};

} // namespace pcl_cid::test
