/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * d(x; S): from the grid, or where it has no list, from the tree or the given search.
 */

#include "base/parallel_for.h"
#include "base/requirements.h"
#include "block_tree.h"
#include "build_count.h"
#include "distance_grid.h"

#include <pcl_cid/core/distance_field.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>
#include <vector>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <unistd.h>

namespace pcl_cid {
namespace {

std::atomic<std::size_t> fields_built{0};

DistanceField::SearchPtr
makeKdTree()
{
  const auto tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false);
  // FLANN sums its lower bounds in float and may pass over a point that is nearer by
  // the last bits. A slightly negative epsilon loosens its pruning by more than it
  // rounds.
  tree->setEpsilon(-1e-4f);
  return tree;
}

std::size_t
quarterOfMemory()
{
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page = sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0
             ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(page) / 4
             : std::size_t{1} << 30;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
cloudOf(const BlockTree& tree, std::size_t size)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->resize(size);
  for (std::size_t b = 0; b < tree.size(); ++b)
    for (int row = 0; row < tree.block(b).count; ++row)
      (*cloud)[static_cast<std::size_t>(tree.block(b).index[row])].getVector3fMap() =
          tree.block(b).point(row);
  return cloud;
}

} // namespace

std::size_t
fieldsBuilt()
{
  return fields_built;
}

DistanceField::DistanceField(const Points& surface) : DistanceField(surface, Options())
{
}

DistanceField::DistanceField(const Points& surface, const Options& options)
: size_(surface.size())
, has_own_search_(options.search != nullptr)
, search_(options.search)
{
  requirePoints(surface);
  Progress progress(options.execution.progress);
  const int threads = threadCount(options.execution.threads);
  const std::size_t budget =
      options.memory_budget > 0 ? options.memory_budget : quarterOfMemory();
  tree_ = std::make_unique<BlockTree>(surface, threads, progress);
  grid_ = std::make_unique<DistanceGrid>(*tree_, budget, threads, progress);
  ++fields_built;
}

DistanceField::~DistanceField() = default;

const DistanceField::Search&
DistanceField::search() const
{
  std::call_once(search_ready_, [this] {
    if (!search_)
      search_ = makeKdTree();
    search_->setInputCloud(cloudOf(*tree_, size_));
  });
  return *search_;
}

DistanceField::Nearest
DistanceField::nearestPoint(const Eigen::Vector3f& x) const
{
  BlockTree::Nearest found = grid_->nearest(x);
  if (found.slot < 0 && has_own_search_) {
    const Eigen::Vector3f point =
        (*search().getInputCloud())[static_cast<std::size_t>(nearest(x))]
            .getVector3fMap();
    const Eigen::Vector3f d = x - point;
    return {point, std::sqrt((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z())};
  }
  if (found.slot < 0)
    tree_->descend(1, padded(x), found);
  // When every squared distance overflows float, any point is as near as the others.
  return {tree_->position(std::max(found.slot, 0)), std::sqrt(found.squared_distance)};
}

float
DistanceField::distance(const Eigen::Vector3f& x) const
{
  return nearestPoint(x).distance;
}

DistanceBounds
DistanceField::bounds(const Eigen::Vector3f& x) const
{
  return grid_->look(x).bounds;
}

pcl::index_t
DistanceField::nearest(const Eigen::Vector3f& x) const
{
  pcl::Indices index(1);
  std::vector<float> squared_distance(1);
  const int found = search().nearestKSearch(
      pcl::PointXYZ(x.x(), x.y(), x.z()), 1, index, squared_distance);
  if (found != 1)
    throw CIDException("the search method found no neighbor; it must answer every "
                       "finite query on a surface of at least 1 point");
  return index[0];
}

} // namespace pcl_cid
