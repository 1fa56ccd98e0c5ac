/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * d(x; S): the distance from anywhere to the surface.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <memory>
#include <mutex>

#include <pcl/memory.h>
#include <pcl/types.h>

namespace pcl {
struct PointXYZ;
namespace search {
template <typename PointT>
class Search;
} // namespace search
} // namespace pcl

namespace pcl_cid {

class BlockTree;
class DistanceGrid;

/** \brief Certified bounds: low <= d(x; S) <= high, metres. */
struct DistanceBounds {
  float low;
  float high;
};

/** \brief The distance d(x; S) = min over k of |x - p_k| to a finite set of points S,
 *  the surface of the paper (section III.A); PCL's *search surface*.
 *
 *  distance() is exact: the square root of the smallest float squared distance over all
 *  points, to the bit the same however it is found. An adaptive grid knows, for nearly
 *  all of space, which few points can be nearest; elsewhere a tree of the points
 *  answers, or the search method that is given. bounds() are certified and several
 *  times cheaper.
 *
 *  Cost: building is O(|S| log |S|) and takes about 150 bytes a point, less where a
 *  budget says so. Thread safety: const calls may run concurrently. */
class PCL_CID_EXPORT DistanceField {
public:
  /** \brief What answers nearest-neighbor queries. It is given the surface with
   *  setInputCloud(), must be exact, and safe for concurrent queries. */
  using Search = pcl::search::Search<pcl::PointXYZ>;
  using SearchPtr = pcl::shared_ptr<Search>;

  struct Options {
    /** Answers where the grid does not, and nearest(). Null: the tree of the grid, and
     *  pcl::search::KdTree, which is pcl::KdTreeFLANN, for nearest(). */
    SearchPtr search;
    /** Bytes that the grid may take; 0 for a quarter of the machine's memory. Less
     *  memory makes queries slower and changes no answer. */
    std::size_t memory_budget = 0;
    /** Threads and progress of the building; never change an answer. */
    ExecutionOptions execution;
  };

  /** \brief Build the field of a surface.
   *  \param[in] surface finite points, relative to a local origin (see PointSet),
   *  metres
   *  \param[in] options see Options
   *  \throws CIDException when the surface is empty, CIDCancelled */
  DistanceField(const Points& surface, const Options& options);
  explicit DistanceField(const Points& surface);
  ~DistanceField();
  DistanceField(const DistanceField&) = delete;
  DistanceField&
  operator=(const DistanceField&) = delete;

  /** \brief A surface point that is nearest to x. */
  struct Nearest {
    Eigen::Vector3f point;
    float distance; ///< d(x; S)
  };

  /** \brief d(x; S), in the unit of the coordinates. */
  float
  distance(const Eigen::Vector3f& x) const;

  /** \brief d(x; S), and a point of S at that distance; which one of several is
   *  unspecified. */
  Nearest
  nearestPoint(const Eigen::Vector3f& x) const;

  /** \brief Certified bounds of d(x; S), without a search. */
  DistanceBounds
  bounds(const Eigen::Vector3f& x) const;

  /** \brief The index in the surface of a point at distance d(x; S) from x. */
  pcl::index_t
  nearest(const Eigen::Vector3f& x) const;

  /** \brief Number of points of the surface. */
  std::size_t
  size() const
  {
    return size_;
  }

  /** \brief The surface in blocks of neighbors. */
  const BlockTree&
  blocks() const
  {
    return *tree_;
  }

  /** \brief The grid of bounds. */
  const DistanceGrid&
  grid() const
  {
    return *grid_;
  }

private:
  const Search&
  search() const;

  std::size_t size_;
  std::unique_ptr<BlockTree> tree_;
  std::unique_ptr<DistanceGrid> grid_;
  bool has_own_search_; ///< a search method was given
  mutable SearchPtr search_;
  mutable std::once_flag search_ready_; ///< pcl::KdTreeFLANN is built when first asked
};

} // namespace pcl_cid
