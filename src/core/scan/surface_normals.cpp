/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which way the surface faces at every point, but for the sign.
 */

#include "surface_normals.h"

#include "base/infinity.h"
#include "base/parallel_for.h"
#include "base/rounding.h"
#include "field/block_tree.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <Eigen/Eigenvalues>

namespace pcl_cid {
namespace {

/** Blocks that a thread takes at a time. */
constexpr std::size_t blocks_for_normals = 8;

/** Points spread in a line when the second of their variances is below this share of
 *  the first: what coordinates in float leave of it is far smaller. */
constexpr double least_breadth = 1e-10;

/** \brief The points nearest to a place, found block by block. */
class NearestPoints {
public:
  NearestPoints(const BlockTree& tree, std::size_t count) : tree_(tree), count_(count)
  {
  }

  /** \param[in] home the block that the place is in */
  const std::vector<std::pair<float, std::int32_t>>&
  find(const Eigen::Vector3f& p, std::size_t home)
  {
    found_.assign(count_, {infinity, -1});
    look(home, p);
    descend(1, home, padded(p));
    return found_;
  }

private:
  void
  look(std::size_t number, const Eigen::Vector3f& p)
  {
    const PointBlock& block = tree_.block(number);
    const auto squared = block.squaredDistances(p);
    for (int row = 0; row < block.count; ++row) {
      const std::pair<float, std::int32_t> each(squared[row], block.index[row]);
      if (!(each < found_.back()))
        continue;
      found_.pop_back();
      found_.insert(std::upper_bound(found_.begin(), found_.end(), each), each);
    }
  }

  void
  descend(std::size_t node, std::size_t home, const Eigen::Array4f& p)
  {
    if (tree_.box(node).squaredDistance(p) > found_.back().first * rounding::widening)
      return;
    if (tree_.isBlock(node)) {
      if (node != tree_.nodeOfBlock(home))
        look(node - tree_.size(), p.matrix().head<3>());
      return;
    }
    const std::size_t near = tree_.box(2 * node + 1).squaredDistance(p) <
                                     tree_.box(2 * node).squaredDistance(p)
                                 ? 2 * node + 1
                                 : 2 * node;
    descend(near, home, p);
    descend(near ^ 1, home, p);
  }

  const BlockTree& tree_;
  std::size_t count_;
  std::vector<std::pair<float, std::int32_t>> found_; ///< nearest first
};

Eigen::Vector3f
normalOf(const Points& points,
         const std::vector<std::pair<float, std::int32_t>>& nearest)
{
  const auto at = [&](std::int32_t index) -> Eigen::Vector3d {
    return points[static_cast<std::size_t>(index)].cast<double>();
  };
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& [squared, index] : nearest)
    mean += at(index);
  mean /= static_cast<double>(nearest.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& [squared, index] : nearest)
    spread += (at(index) - mean) * (at(index) - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Eigen::Vector3d& variances = axes.eigenvalues(); // ascending
  if (!(variances[1] > least_breadth * variances[2]))
    return Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = axes.eigenvectors().col(0).normalized().cast<float>();
  Eigen::Index largest = 0; // the first of equal ones
  normal.cwiseAbs().maxCoeff(&largest);
  return normal[largest] < 0.0f ? Eigen::Vector3f(-normal) : normal;
}

} // namespace

std::vector<Eigen::Vector3f>
surfaceNormals(const Points& points,
               std::size_t neighbors,
               const ExecutionOptions& execution)
{
  return surfaceNormals(
      points, neighbors, std::vector<bool>(points.size(), true), execution);
}

std::vector<Eigen::Vector3f>
surfaceNormals(const Points& points,
               std::size_t neighbors,
               const std::vector<bool>& wanted,
               const ExecutionOptions& execution)
{
  std::vector<Eigen::Vector3f> normals(points.size(), Eigen::Vector3f::Zero());
  if (points.size() < 3)
    return normals;
  const int threads = threadCount(execution.threads);
  Progress progress(execution.progress);
  const BlockTree tree(points, threads, progress);
  const auto fit = [&](std::size_t begin, std::size_t end) {
    NearestPoints nearest(tree, std::min(neighbors, points.size()));
    for (std::size_t number = begin; number < end; ++number) {
      const PointBlock& block = tree.block(number);
      for (int row = 0; row < block.count; ++row) {
        const auto point = static_cast<std::size_t>(block.index[row]);
        if (wanted[point])
          normals[point] = normalOf(points, nearest.find(block.point(row), number));
      }
    }
  };
  parallelFor(tree.size(), blocks_for_normals, threads, progress, {0.0, 1.0}, fit);
  return normals;
}

} // namespace pcl_cid
