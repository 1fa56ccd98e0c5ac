/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The order in which a page knows the points of a scan.
 */

#include "places.h"

#include <pcl_cid/exceptions.h>

#include <numeric>
#include <random>
#include <string>
#include <utility>

namespace pcl_cid::studio {

Places::Places(const PointSet& points, std::size_t cloud_size)
: members_(points.size()), places_(cloud_size, none)
{
  std::iota(members_.begin(), members_.end(), 0u);
  std::mt19937_64 random; // the same order each time
  for (std::size_t i = members_.size(); i > 1; --i)
    std::swap(members_[i - 1], members_[random() % i]);
  points_.reserve(members_.size());
  for (std::size_t place = 0; place < members_.size(); ++place) {
    points_.push_back(points.source[members_[place]]);
    places_[static_cast<std::size_t>(points_[place])] =
        static_cast<std::uint32_t>(place);
  }
}

pcl::index_t
Places::requirePoint(std::uint32_t place) const
{
  if (place >= points_.size())
    throw CIDException("the place is " + std::to_string(place) + "; it must be 0 to " +
                       std::to_string(points_.size()) +
                       " - 1 (the points that are shown)");
  return points_[place];
}

std::vector<std::uint32_t>
Places::placesOf(const pcl::Indices& points) const
{
  std::vector<std::uint32_t> places;
  places.reserve(points.size());
  for (const pcl::index_t point : points)
    places.push_back(placeOf(point));
  return places;
}

} // namespace pcl_cid::studio
