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
#include <cstdint>
#include <cstring>
#include <numeric>
#include <type_traits>
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

/** \brief The color of a point with `rgb` or `rgba`, whichever it is registered with.
 */
template <typename PointT>
ColorRGB
colorOf(const PointT& point)
{
  using Tag =
      std::conditional_t<pcl::traits::has_field<PointT, pcl::fields::rgb>::value,
                         pcl::fields::rgb,
                         pcl::fields::rgba>;
  static_assert(sizeof(typename pcl::traits::datatype<PointT, Tag>::type) ==
                    sizeof(std::uint32_t),
                "pcl_cid needs colors of 4 bytes, packed as PCL packs them");
  std::uint32_t packed;
  std::memcpy(&packed,
              reinterpret_cast<const char*>(&point) +
                  pcl::traits::offset<PointT, Tag>::value,
              sizeof(packed));
  return unpackColor(packed);
}

} // namespace detail

template <typename PointT>
void
CIDBase<PointT>::setInputCloud(const PointCloudConstPtr& cloud)
{
  Base::setInputCloud(cloud);
  forgetScan();
}

template <typename PointT>
void
CIDBase<PointT>::setIndices(const pcl::IndicesPtr& indices)
{
  Base::setIndices(indices);
  forgetScan();
}

template <typename PointT>
void
CIDBase<PointT>::setIndices(const pcl::IndicesConstPtr& indices)
{
  Base::setIndices(indices);
  forgetScan();
}

template <typename PointT>
void
CIDBase<PointT>::setIndices(const PointIndicesConstPtr& indices)
{
  Base::setIndices(indices);
  forgetScan();
}

template <typename PointT>
void
CIDBase<PointT>::setIndices(std::size_t row_start,
                            std::size_t col_start,
                            std::size_t nb_rows,
                            std::size_t nb_cols)
{
  Base::setIndices(row_start, col_start, nb_rows, nb_cols);
  forgetScan();
}

template <typename PointT>
auto
CIDBase<PointT>::preparedInput() const -> const PointCloud&
{
  if (!input_)
    throw CIDException("there is no input cloud; call setInputCloud first");
  if (getPreparedScan() && getPreparedScan()->cloudSize() != input_->size())
    throw CIDException("the input cloud has " + std::to_string(input_->size()) +
                       " points; it must be the one that was prepared, which has " +
                       std::to_string(getPreparedScan()->cloudSize()));
  return *input_;
}

template <typename PointT>
std::vector<ColorRGB>
CIDBase<PointT>::gatherColors(const PointSet& points) const
{
  std::vector<ColorRGB> colors;
  if (getColorWeight() == 0.0f)
    return colors;
  const ColorsConstPtr given = getColors();
  if (given && given->size() != input_->size())
    throw CIDException("there are " + std::to_string(given->size()) +
                       " colors; there must be one for each of the " +
                       std::to_string(input_->size()) + " points of the input cloud");
  colors.reserve(points.size());
  for (const pcl::index_t source : points.source) {
    const auto i = static_cast<std::size_t>(source);
    if (given)
      colors.push_back((*given)[i]);
    else if constexpr (pcl::traits::has_color_v<PointT>)
      colors.push_back(detail::colorOf((*input_)[i]));
    else
      throw CIDException("the color weight is " + std::to_string(getColorWeight()) +
                         ", but the point type has no rgb or rgba; call setColors, or "
                         "set the weight to 0");
  }
  return colors;
}

template <typename PointT>
std::optional<SensorPose>
CIDBase<PointT>::sensorPose(const Frame& frame) const
{
  const Eigen::Vector3d position =
      input_->sensor_origin_.template head<3>().template cast<double>();
  SensorPose pose;
  pose.position = frame.toLocal(position).template cast<float>();
  pose.down = (input_->sensor_orientation_.normalized() * pose.down).normalized();
  if (!pose.position.allFinite() || !pose.down.allFinite())
    return std::nullopt;
  return pose;
}

template <typename PointT>
pcl::Indices
CIDBase<PointT>::selectedPoints() const
{
  if (!input_)
    throw CIDException("there is no input cloud; call setInputCloud first");
  pcl::Indices selected;
  if (use_indices_ && indices_)
    selected = *indices_;
  else {
    selected.resize(input_->size());
    std::iota(selected.begin(), selected.end(), 0);
  }
  for (const pcl::index_t index : selected)
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size())
      throw CIDException("the indices hold " + std::to_string(index) +
                         "; they must be 0 to " + std::to_string(input_->size()) +
                         " - 1 (the points of the input cloud)");
  if (!std::is_sorted(selected.begin(), selected.end()))
    std::sort(selected.begin(), selected.end());
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  return selected;
}

template <typename PointT>
RawScan
CIDBase<PointT>::gatherScan() const
{
  pcl::Indices selected = selectedPoints();
  RawScan scan;
  Points points = detail::coordinates(*input_, selected);
  scan.points = PointSet(std::move(points), std::move(selected));
  scan.cloud_size = input_->size();
  if (search_surface_) {
    pcl::Indices all(search_surface_->size());
    std::iota(all.begin(), all.end(), 0);
    scan.surface =
        PointSet(detail::coordinates(*search_surface_, all), all, scan.points.frame)
            .points;
    if (scan.surface.empty())
      throw CIDException(
          "the search surface has no finite point; at least 1 is needed");
  }
  scan.colors = gatherColors(scan.points);
  scan.sensor = sensorPose(scan.points.frame);
  return scan;
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDBase(T) template class PCL_CID_EXPORT pcl_cid::CIDBase<T>;
