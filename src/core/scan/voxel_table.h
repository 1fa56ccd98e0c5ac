/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The voxels that hold points, found by their cell.
 */

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Where a voxel is, counted in voxels from that of the first point. */
using VoxelCell = std::array<std::int32_t, 3>;

/** \brief Numbers of voxels by their cells: 0, 1, ... in the order in which they are
 *  added.
 *
 *  Open addressing over numbers alone, the cells standing in a row: 18 to 24 bytes a
 *  voxel, a third of what the nodes of a map take. */
class VoxelTable {
public:
  std::size_t
  size() const
  {
    return cells_.size();
  }

  const VoxelCell&
  cell(std::size_t number) const
  {
    return cells_[number];
  }

  void
  reserve(std::size_t voxels)
  {
    cells_.reserve(voxels);
    while (!hasRoomFor(voxels))
      grow();
  }

  /** \return the number of the voxel, -1 when there is none */
  pcl::index_t
  find(const VoxelCell& cell) const
  {
    return slots_.empty() ? -1 : slots_[slotOf(cell)];
  }

  /** \return the number of the voxel, which is added when there is none */
  pcl::index_t
  add(const VoxelCell& cell)
  {
    if (!hasRoomFor(cells_.size() + 1))
      grow();
    pcl::index_t& number = slots_[slotOf(cell)];
    if (number < 0) {
      number = static_cast<pcl::index_t>(cells_.size());
      cells_.push_back(cell);
    }
    return number;
  }

private:
  /** At most two of three slots are taken: few steps lead to a free one. */
  bool
  hasRoomFor(std::size_t voxels) const
  {
    return 3 * voxels <= 2 * slots_.size();
  }

  /** Where a voxel is, or would be. */
  std::size_t
  slotOf(const VoxelCell& cell) const
  {
    const std::size_t last = slots_.size() - 1; // a power of two less one
    std::size_t slot = hashOf(cell) & last;
    while (slots_[slot] >= 0 &&
           !areEqual(cells_[static_cast<std::size_t>(slots_[slot])], cell))
      slot = (slot + 1) & last;
    return slot;
  }

  /** As ==, which calls a function of the C library: a third of all time. */
  static bool
  areEqual(const VoxelCell& a, const VoxelCell& b)
  {
    return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0;
  }

  static std::size_t
  hashOf(const VoxelCell& cell)
  {
    std::uint64_t hash = 0;
    for (const std::int32_t along : cell) {
      hash = (hash ^ static_cast<std::uint32_t>(along)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }

  void
  grow()
  {
    constexpr std::size_t fewest = 64;
    slots_.assign(slots_.empty() ? fewest : 2 * slots_.size(), -1);
    for (std::size_t k = 0; k < cells_.size(); ++k)
      slots_[slotOf(cells_[k])] = static_cast<pcl::index_t>(k);
  }

  std::vector<VoxelCell> cells_;
  std::vector<pcl::index_t> slots_; ///< numbers; -1 where there is none
};

} // namespace pcl_cid
