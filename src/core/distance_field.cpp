/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * d(x; S) on pcl::KdTreeFLANN.
 */

#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/exceptions.h>

#include <cmath>
#include <utility>

#include <pcl/search/kdtree.h>

namespace pcl_cid {
namespace {

DistanceField::Search::Ptr
makeKdTree()
{
  const auto tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false);
  // FLANN sums its lower bounds in float and may pass over a point that is nearer by
  // the last bits. A slightly negative epsilon loosens its pruning by more than it
  // rounds.
  tree->setEpsilon(-1e-4f);
  return tree;
}

} // namespace

DistanceField::DistanceField(const Points& surface, Search::Ptr search)
: surface_(pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>())
, search_(search ? std::move(search) : makeKdTree())
{
  if (surface.empty())
    throw CIDException("the search surface has no finite point; at least 1 is needed");
  surface_->reserve(surface.size());
  for (const Eigen::Vector3f& p : surface)
    surface_->emplace_back(p.x(), p.y(), p.z());
  search_->setInputCloud(surface_);
}

pcl::index_t
DistanceField::nearest(const Eigen::Vector3f& x) const
{
  thread_local pcl::Indices index(1);
  thread_local std::vector<float> squared_distance(1);
  const int found = search_->nearestKSearch(
      pcl::PointXYZ(x.x(), x.y(), x.z()), 1, index, squared_distance);
  if (found != 1)
    throw CIDException("the search method found no neighbour; it must answer every "
                       "finite query on a surface of at least 1 point");
  return index[0];
}

float
DistanceField::distance(const Eigen::Vector3f& x) const
{
  const pcl::PointXYZ& p = (*surface_)[nearest(x)];
  const float dx = x.x() - p.x;
  const float dy = x.y() - p.y;
  const float dz = x.z() - p.z;
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

} // namespace pcl_cid
