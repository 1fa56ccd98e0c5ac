/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One point of each voxel of a scan, and which of them every other point follows.
 */

#include "base/parallel_for.h"
#include "base/sentence.h"
#include "voxel_neighbors.h"
#include "voxel_table.h"

#include <pcl_cid/core/voxel_points.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_cid {
namespace {

constexpr double farthest_of_all = std::numeric_limits<double>::max();
constexpr std::size_t most_points = std::numeric_limits<pcl::index_t>::max();
constexpr std::size_t voxel_grain = 2048; // points that a thread takes at once

[[noreturn]] void
refuseOtherScan()
{
  throw CIDException("is another scan than was shown before, or a part of it");
}

} // namespace

struct VoxelPoints::State {
  /** Which time the scan is shown. */
  enum class Stage { add, choose, follow };

  State(double size, unsigned int threads) : size(size), threads(threadCount(threads))
  {
    require(setting::voxel.withoutZero(), size);
  }

  /** Where a voxel begins. */
  Eigen::Vector3d
  cornerOf(const VoxelCell& cell) const
  {
    return size * (*first + Eigen::Vector3d(cell[0], cell[1], cell[2]));
  }

  /** \param[in] p finite */
  VoxelCell
  cellOf(const Eigen::Vector3d& p) const
  {
    constexpr double farthest = 1 << 30;
    constexpr double coarsest = 0x1p52; // beyond it, double has whole numbers alone
    const Eigen::Vector3d whole = (p / size).array().floor();
    const Eigen::Vector3d from_first = whole - *first;
    if (!(from_first.cwiseAbs().maxCoeff() < farthest) ||
        !(whole.cwiseAbs().maxCoeff() < coarsest))
      throw CIDException(sentence("the size of a voxel is ",
                                  size,
                                  "; it must be so large that points are less than ",
                                  static_cast<std::int64_t>(farthest),
                                  " voxels apart, and that coordinates, the largest "
                                  "is ",
                                  p.cwiseAbs().maxCoeff(),
                                  ", tell voxels apart"));
    return {static_cast<std::int32_t>(from_first.x()),
            static_cast<std::int32_t>(from_first.y()),
            static_cast<std::int32_t>(from_first.z())};
  }

  /** Call work(i) for each finite point, in parallel. */
  template <typename Work>
  void
  forEachFinite(const Block& points, const Work& work) const
  {
    Progress untold{{}};
    parallelFor(points.size(),
                voxel_grain,
                threads,
                untold,
                {},
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t i = begin; i < end; ++i)
                    if (points[i].allFinite())
                      work(i);
                });
  }

  /** The voxel of each point, -1 for those that are not finite. */
  pcl::Indices
  knownVoxelsOf(const Block& points) const
  {
    pcl::Indices numbers(points.size(), -1);
    forEachFinite(points, [&](std::size_t i) {
      numbers[i] = first ? table.find(cellOf(points[i])) : -1;
      if (numbers[i] < 0)
        refuseOtherScan();
    });
    return numbers;
  }

  /** The chosen point that is nearest to p, in whose voxel one was chosen. */
  pcl::index_t
  nearest(const Eigen::Vector3d& p) const
  {
    static const std::vector<VoxelCell> around = voxelsAround();
    static const std::vector<VoxelCell> farther_out = voxelsFartherOut();
    const VoxelCell own = cellOf(p);
    pcl::index_t best = table.find(own);
    if (best < 0)
      refuseOtherScan();
    const std::uint32_t neighbors = taken_around[static_cast<std::size_t>(best)];
    double least = (p - chosen[static_cast<std::size_t>(best)]).squaredNorm();
    const VoxelGaps gaps(p, cornerOf(own), size);
    if (gaps.squaredBeyond(1) > least)
      return best;
    const auto compare = [&](pcl::index_t other) {
      const double squared =
          (p - chosen[static_cast<std::size_t>(other)]).squaredNorm();
      if (squared < least || (squared == least && other < best)) {
        least = squared;
        best = other;
      }
    };
    std::size_t k = 0;
    for (std::uint32_t rest = neighbors; rest != 0; rest >>= 1, ++k)
      if ((rest & 1u) != 0 && gaps.squared(around[k]) <= least)
        compare(table.find(own + around[k]));
    if (gaps.squaredBeyond(2) > least)
      return best;
    for (const VoxelCell& offset : farther_out)
      if (gaps.squared(offset) <= least)
        if (const pcl::index_t other = table.find(own + offset); other >= 0)
          compare(other);
    return best;
  }

  void
  requireStage(Stage expected) const
  {
    if (stage != expected)
      throw CIDException("a scan is shown three times: to add(), to choose(), and, "
                         "after finish(), to follow()");
  }

  /** Whether a point is nearer to the mean of its voxel than another. Distances that
   *  are equal but for rounding are equal.
   *  \param[in] squared,least squares of the two distances */
  bool
  isNearer(double squared, double least) const
  {
    return squared < least - 1e-14 * size * std::sqrt(least);
  }

  /** Where a point is in its voxel. */
  Eigen::Vector3d
  beyondCorner(const Eigen::Vector3d& p, std::size_t number) const
  {
    return p - cornerOf(table.cell(number));
  }

  /** Bring the voxels into the order of their points, with all that follow() needs. */
  void
  reorder(const pcl::Indices& order)
  {
    VoxelTable ordered;
    ordered.reserve(order.size());
    Block points;
    points.reserve(order.size());
    pcl::Indices indices;
    indices.reserve(order.size());
    for (const pcl::index_t number : order) {
      const auto k = static_cast<std::size_t>(number);
      ordered.add(table.cell(k));
      points.push_back(chosen[k]);
      indices.push_back(source[k]);
    }
    table = std::move(ordered);
    chosen = std::move(points);
    source = std::move(indices);
  }

  void
  findTakenAround()
  {
    const std::vector<VoxelCell> around = voxelsAround();
    taken_around.assign(table.size(), 0);
    forEachFinite(chosen, [&](std::size_t voxel) {
      for (std::size_t k = 0; k < around.size(); ++k)
        if (table.find(table.cell(voxel) + around[k]) >= 0)
          taken_around[voxel] |= 1u << k;
    });
  }

  double size;
  int threads;
  std::optional<Eigen::Vector3d> first; ///< voxel of the first point, whole numbers
  VoxelTable table;

  Stage stage = Stage::add;
  pcl::index_t shown = 0; ///< points, the second time
  Block means; ///< of points, from the corner of their voxel; their sums at first
  std::vector<double> counts; ///< of points; of no use once there are means
  std::vector<double> least;  ///< squared distances of chosen points to means

  Block chosen;
  pcl::Indices source;
  std::vector<std::uint32_t> taken_around;
};

VoxelPoints::VoxelPoints(double size, unsigned int threads)
: state_(std::make_unique<State>(size, threads))
{
}

VoxelPoints::~VoxelPoints() = default;
VoxelPoints::VoxelPoints(VoxelPoints&& other) noexcept = default;
VoxelPoints&
VoxelPoints::operator=(VoxelPoints&& other) noexcept = default;

void
VoxelPoints::add(const Block& points)
{
  State& s = *state_;
  s.requireStage(State::Stage::add);
  if (!s.first)
    for (const Eigen::Vector3d& p : points)
      if (p.allFinite()) {
        s.first = (p / s.size).array().floor();
        break;
      }
  std::vector<VoxelCell> cells(points.size());
  Block beyond_corner(points.size());
  pcl::Indices numbers(points.size(), -1);
  s.forEachFinite(points, [&](std::size_t i) {
    cells[i] = s.cellOf(points[i]);
    beyond_corner[i] = points[i] - s.cornerOf(cells[i]);
    numbers[i] = s.table.find(cells[i]);
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      continue;
    const auto number =
        static_cast<std::size_t>(numbers[i] < 0 ? s.table.add(cells[i]) : numbers[i]);
    if (number == s.counts.size()) {
      s.means.emplace_back(Eigen::Vector3d::Zero());
      s.counts.push_back(0.0);
    }
    s.means[number] += beyond_corner[i];
    s.counts[number] += 1.0;
  }
}

pcl::Indices
VoxelPoints::choose(const Block& points)
{
  State& s = *state_;
  if (s.stage == State::Stage::add) {
    for (std::size_t k = 0; k < s.means.size(); ++k)
      s.means[k] /= s.counts[k];
    s.least = std::move(s.counts);
    s.least.assign(s.table.size(), farthest_of_all);
    s.chosen.resize(s.table.size());
    s.source.assign(s.table.size(), -1);
    s.stage = State::Stage::choose;
  }
  s.requireStage(State::Stage::choose);
  if (points.size() > most_points - static_cast<std::size_t>(s.shown))
    throw CIDException(sentence(
        "has more than ", most_points, " points, as many as indices of PCL reach"));
  pcl::Indices numbers = s.knownVoxelsOf(points);
  std::vector<double> squared(points.size());
  s.forEachFinite(points, [&](std::size_t i) {
    const auto k = static_cast<std::size_t>(numbers[i]);
    squared[i] = (s.beyondCorner(points[i], k) - s.means[k]).squaredNorm();
  });
  for (std::size_t i = 0; i < points.size(); ++i, ++s.shown) {
    if (numbers[i] < 0)
      continue;
    const auto k = static_cast<std::size_t>(numbers[i]);
    if (!s.isNearer(squared[i], s.least[k])) {
      numbers[i] = -1;
      continue;
    }
    s.least[k] = squared[i];
    s.chosen[k] = points[i];
    s.source[k] = s.shown;
  }
  return numbers;
}

pcl::Indices
VoxelPoints::finish()
{
  State& s = *state_;
  if (!s.first)
    s.stage = State::Stage::choose; // nothing from nothing
  s.requireStage(State::Stage::choose);
  if (std::count(s.source.begin(), s.source.end(), -1) > 0)
    refuseOtherScan();
  s.stage = State::Stage::follow;
  s.means = {};
  s.least = {};
  pcl::Indices order(s.table.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](pcl::index_t a, pcl::index_t b) {
    return s.source[static_cast<std::size_t>(a)] <
           s.source[static_cast<std::size_t>(b)];
  });
  s.reorder(order);
  s.findTakenAround();
  return order;
}

std::size_t
VoxelPoints::size() const
{
  return state_->table.size();
}

const pcl::Indices&
VoxelPoints::source() const
{
  return state_->source;
}

pcl::Indices
VoxelPoints::follow(const Block& points) const
{
  const State& s = *state_;
  s.requireStage(State::Stage::follow);
  pcl::Indices follows(points.size(), -1);
  s.forEachFinite(points, [&](std::size_t i) {
    if (!s.first)
      refuseOtherScan();
    follows[i] = s.nearest(points[i]);
  });
  return follows;
}

} // namespace pcl_cid
