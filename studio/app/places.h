/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The order in which a page knows the points of a scan.
 */

#pragma once

#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid::studio {

/** \brief Places of points (doc/studio_protocol.md): a random order, so that the first
 *  ones are a thinned scan. */
class Places {
public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  /** \param[in] points those that have a place
   *  \param[in] cloud_size points of the cloud that they are from */
  Places(const PointSet& points, std::size_t cloud_size);

  std::size_t
  size() const
  {
    return members_.size();
  }

  /** \brief The point at a place, as an index of the point set. */
  std::size_t
  member(std::size_t place) const
  {
    return members_[place];
  }

  /** \brief The point at a place, as an index of the cloud. */
  pcl::index_t
  point(std::size_t place) const
  {
    return points_[place];
  }

  /** \brief The same for what a page says.
   *  \throws CIDException when there is no such place */
  pcl::index_t
  requirePoint(std::uint32_t place) const;

  /** \brief The place of a point of the cloud, or none. */
  std::uint32_t
  placeOf(pcl::index_t point) const
  {
    return point < 0 ? none : places_[static_cast<std::size_t>(point)];
  }

  std::vector<std::uint32_t>
  placesOf(const pcl::Indices& points) const;

private:
  std::vector<std::uint32_t> members_; ///< by place
  pcl::Indices points_;                ///< by place
  std::vector<std::uint32_t> places_;  ///< by point of the cloud
};

} // namespace pcl_cid::studio
