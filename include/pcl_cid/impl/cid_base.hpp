/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points in, core call, indices out: what the classes share.
 */

#pragma once

#include <pcl_cid/cid_base.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace detail {

/** \brief Coordinates of some points of a cloud, in the order of the indices. */
template <typename PointT>
Points
coordinates(const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices)
{
  Points points;
  points.reserve(indices.size());
  for (const pcl::index_t i : indices) {
    const PointT& point = cloud[static_cast<std::size_t>(i)];
    points.emplace_back(point.x, point.y, point.z);
  }
  return points;
}

} // namespace detail

template <typename PointT>
void
CIDBase<PointT>::beginCompute()
{
  if (!input_)
    throw CIDException("there is no input cloud; call setInputCloud first");
  if (!initCompute())
    throw CIDException("the input cloud and its indices do not fit together");
  for (const pcl::index_t index : *indices_)
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size())
      throw CIDException("the indices hold " + std::to_string(index) +
                         "; they must be 0 to " + std::to_string(input_->size()) +
                         " - 1 (the points of the input cloud)");
}

template <typename PointT>
PointSet
CIDBase<PointT>::gatherPoints() const
{
  pcl::Indices selected = *indices_;
  if (!std::is_sorted(selected.begin(), selected.end()))
    std::sort(selected.begin(), selected.end());
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  Points points = detail::coordinates(*input_, selected);
  return PointSet(std::move(points), std::move(selected));
}

template <typename PointT>
Preparation
CIDBase<PointT>::prepareCompute(const pcl::Indices& given_seeds)
{
  beginCompute();
  PointSet points = gatherPoints();
  PointSet surface;
  if (search_surface_) {
    pcl::Indices all(search_surface_->size());
    std::iota(all.begin(), all.end(), 0);
    surface = PointSet(detail::coordinates(*search_surface_, all), all, points.origin);
    if (surface.size() == 0)
      throw CIDException(
          "the search surface has no finite point; at least 1 is needed");
  }
  return prepare(
      std::move(points), surface.points, given_seeds, *this, execution(0.0, 0.0));
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDBase(T) template class PCL_CID_EXPORT pcl_cid::CIDBase<T>;
