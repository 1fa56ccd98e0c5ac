/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points of parts their hulls need, where there are too many to hold them all.
 */

#include "base/parallel_for.h"
#include "base/sentence.h"
#include "fast_hull.h"
#include "principal_box.h"

#include <pcl_cid/core/extreme_points.h>
#include <pcl_cid/exceptions.h>

#include <cstdint>
#include <utility>

#include <pcl/types.h>

namespace pcl_cid {
namespace {

using Block = ExtremePoints::Block;

constexpr std::size_t run_length = 1024;

/** The points along the axes of their box, stretched until that is a cube: a hull keeps
 *  its corners, and rounding spoils that of a thin plate no more than that of a ball.
 *  What is flat but for rounding cannot be stretched; there, copies of all points on
 *  either side fill space. Point i is a copy of the one at i modulo their number, and
 *  what is extreme among them is so among its copies. */
Block
spaceFilling(const Block& points)
{
  constexpr double flat = 1e-12; // share of the largest extent
  const PrincipalBox box = principalBox(points);
  const double largest = box.extents.maxCoeff();
  Block filling;
  filling.reserve(8 * points.size());
  for (const Eigen::Vector3d& p : points)
    filling.push_back(box.toLocal(p));
  for (int axis = 0; axis < 3; ++axis) {
    if (box.extents[axis] > flat * largest) {
      for (Eigen::Vector3d& p : filling)
        p[axis] /= box.extents[axis];
      continue;
    }
    const std::size_t count = filling.size();
    for (std::size_t i = 0; i < count; ++i) {
      filling.push_back(filling[i] + Eigen::Vector3d::Unit(axis));
      filling[i] -= Eigen::Vector3d::Unit(axis);
    }
  }
  return filling;
}

/** The corners of the hull of points; all of them where rounding spoils it. */
Block
cornersAmong(const Block& points)
{
  const std::vector<std::uint32_t> corners = fastHull(spaceFilling(points)).corners;
  if (corners.empty())
    return points;
  std::vector<bool> is_corner(points.size(), false);
  for (const std::uint32_t corner : corners)
    is_corner[corner % points.size()] = true;
  Block kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_corner[i])
      kept.push_back(points[i]);
  return kept;
}

void
requirePart(std::size_t part, std::size_t parts)
{
  if (part >= parts)
    throw CIDException(sentence(
        "there is no part ", part, "; there are ", parts, ", numbered from 0"));
}

void
append(const Block& more, Block& points)
{
  points.insert(points.end(), more.begin(), more.end());
}

} // namespace

struct ExtremePoints::Part {
  Block run;                 ///< not yet reduced
  std::vector<Block> levels; ///< at k nothing, or the corners of 2^k runs

  void
  add(const Eigen::Vector3d& p)
  {
    run.push_back(p);
    if (run.size() == run_length)
      reduceRun();
  }

  /** As one is added to a binary number. */
  void
  reduceRun()
  {
    Block corners = cornersAmong(run);
    run.clear();
    std::size_t level = 0;
    for (; level < levels.size() && !levels[level].empty(); ++level) {
      append(std::exchange(levels[level], {}), corners);
      corners = cornersAmong(corners);
    }
    if (level == levels.size())
      levels.emplace_back();
    levels[level] = std::move(corners);
  }
};

ExtremePoints::ExtremePoints(std::size_t parts, unsigned int threads)
: parts_(parts), threads_(threads)
{
}

ExtremePoints::~ExtremePoints() = default;
ExtremePoints::ExtremePoints(ExtremePoints&& other) noexcept = default;
ExtremePoints&
ExtremePoints::operator=(ExtremePoints&& other) noexcept = default;

void
ExtremePoints::add(const Block& points, const std::vector<int>& part)
{
  if (part.size() != points.size())
    throw CIDException(sentence("there are ",
                                part.size(),
                                " numbers of parts; there must be one for each of ",
                                points.size(),
                                " points"));
  std::vector<pcl::Indices> members(parts_.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] < 0)
      continue;
    const auto number = static_cast<std::size_t>(part[i]);
    requirePart(number, parts_.size());
    members[number].push_back(static_cast<pcl::index_t>(i));
  }
  Progress untold{{}};
  parallelForEach(parts_.size(), threadCount(threads_), untold, {}, [&](std::size_t k) {
    for (const pcl::index_t i : members[k])
      parts_[k].add(points[static_cast<std::size_t>(i)]);
  });
}

Block
ExtremePoints::of(std::size_t part) const
{
  requirePart(part, parts_.size());
  Block kept = parts_[part].run;
  for (const Block& level : parts_[part].levels)
    append(level, kept);
  return kept.empty() ? kept : cornersAmong(kept);
}

} // namespace pcl_cid
