/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points of parts their hulls need, where there are too many to hold them all.
 */

#pragma once

#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Those points of parts that can be extreme, of points that are shown block by
 *  block.
 *
 *  The convex hull of what is kept of a part contains every point of it, to within a
 *  tenth of hull_tolerance of its size: it stands for them wherever only the hull
 *  matters, as in makeConvexPart(). Parts may be flat, straight, or a single point.
 *
 *  \code
 *    pcl_cid::ExtremePoints extremes(parts);
 *    for (const auto& block : blocks)
 *      extremes.add(block.points, block.part);
 *    const auto corners = extremes.of(0);
 *  \endcode
 *
 *  Runs of 1024 points of a part are reduced to the corners of their hulls, then two
 *  such sets to those of both, and so on: no point goes through more such steps than
 *  there are doublings of the run, so that what is rounded away does not add up. What
 *  is held of a part is one run, and the corners of a hull for each doubling.
 *
 *  The result depends on the points and their order, never on blocks or threads. One
 *  thread at a time. */
class PCL_CID_EXPORT ExtremePoints {
public:
  /** \brief Coordinates of points, in any frame. */
  using Block = std::vector<Eigen::Vector3d>;

  /** \param[in] parts how many there are
   *  \param[in] threads as setting::threads */
  explicit ExtremePoints(std::size_t parts,
                         unsigned int threads = setting::threads.initial);
  ~ExtremePoints();
  ExtremePoints(ExtremePoints&& other) noexcept;
  ExtremePoints&
  operator=(ExtremePoints&& other) noexcept;

  /** \brief Show points.
   *  \param[in] points finite where they are in a part
   *  \param[in] part number of the part of each, -1 for none
   *  \throws CIDException when there is not one for each point, or no such part
   *  \note Cost: that of a hull of 1024 points for as many, parts in parallel. */
  void
  add(const Block& points, const std::vector<int>& part);

  /** \brief What is kept of the points of a part so far, in no order that means
   *  anything; none when it has no points.
   *  \throws CIDException when there is no such part */
  Block
  of(std::size_t part) const;

private:
  struct Part;

  std::vector<Part> parts_;
  unsigned int threads_;
};

} // namespace pcl_cid
