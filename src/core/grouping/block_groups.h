/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest seed of every point, block by block, decided as late as possible.
 */

#pragma once

#include "contender.h"
#include "soft_draw.h"

#include "base/parallel_for.h"
#include "cid/segment_search.h"
#include "cid/working_points.h"
#include "field/distance_grid.h"

#include <cstdint>
#include <optional>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief D_min of Algorithm 1 and its argument for every point: exactly what comparing
 *  all pairs would give, with most pairs never looked at. Where pairs have a cost, that
 *  replaces the CID throughout: it never falls when the CID grows.
 *
 *  A new seed is first compared with whole blocks of points, down a tree of blocks. For
 *  a point p within R of the center c of its block, sample l of the segment from the
 *  seed s to p is within R l / (M - 1) of that of the segment to c, and d is
 *  1-Lipschitz, so bounds at the samples of one segment bound the CIDs of all points of
 *  the block. Where the seed may win it becomes a *rival* in the block, with an
 *  interval for its CIDs.
 *
 *  Points are compared one by one only when something depends on them: when they may be
 *  the farthest one, and in decideAll(). Most rivals are out by then, beaten by seeds
 *  that came later. Which comparisons are made depends on threads and on the order in
 *  which seeds came and went; their result does not.
 *
 *  Seeds go by an *id*, in the order in which they came, and have a *rank*, their
 *  number in the grouping: at equal cost the lower rank wins. A copy is independent.
 *  Every call takes the threads and the progress of the work that it is a part of. */
class BlockGroups {
public:
  /** How a call runs. */
  struct Work {
    int threads; ///< as from threadCount()
    Progress& progress;
  };

  /** \param[in] points must outlive this
   *  \param[in] samples M */
  BlockGroups(const WorkingPoints& points, int samples);

  /** \brief These do not count in coverage() and are not proposed. */
  void
  setIsolated(const pcl::Indices& isolated);

  /** \brief Only these are proposed; without this call, all points are. */
  void
  setCandidates(const pcl::Indices& candidates);

  /** \brief Back to no seeds; the marks of points stay. */
  void
  clear() noexcept;

  /** \brief The seeds by rank, indices among the points. */
  pcl::Indices
  seeds() const;

  std::size_t
  numberOfSeeds() const
  {
    return ranked_.size();
  }

  /** \brief Compare a new seed with all points.
   *  \param[in] rank its number; those from there on move up by one
   *  \param[in] to_come about how many seeds will follow: the more, the more effort
   *  pays off now
   *  \param[in] span the share of the progress */
  void
  addSeed(pcl::index_t seed,
          std::size_t rank,
          std::size_t to_come,
          Work work,
          ProgressSpan span);

  /** \brief Take seeds away: their points go to the seeds that remain.
   *  \param[in] ranks ascending; not all of the seeds
   *  \param[in] exactly see decideAll()
   *  \pre decideAll() was the last call that changed anything */
  void
  removeSeeds(const std::vector<std::size_t>& ranks, bool exactly, Work work);

  /** A point, and the value that makes it the farthest. */
  struct Farthest {
    float value = -1.0f;     ///< D_min, times the factor of a draw
    pcl::index_t point = -1; ///< -1: there is none
  };

  /** \brief r_k, the largest D_min of all points that are not isolated. */
  float
  coverage(Work work, ProgressSpan span);

  /** \brief argmax of D_min over the points that would gain by being a seed; the lowest
   *  index of equal ones. */
  Farthest
  farthest(Work work, ProgressSpan span);

  /** \brief One of these points at random, by the soft rule. */
  Farthest
  draw(const SoftDraw& draw, Work work, ProgressSpan span);

  /** \brief Decide which seed every point belongs to.
   *  \param[in] exactly also its D_min, which costs more */
  void
  decideAll(bool exactly, Work work, ProgressSpan span);

  /** \brief The rank of the seed of each point, once all are decided: that of the
   *  smallest cost, but a seed keeps its own point. */
  std::vector<pcl::index_t>
  groups(Work work) const;

  /** \brief D_min of each point, once all are decided exactly. */
  std::vector<float>
  cids(Work work) const;

private:
  /** A seed that may win points of a block. */
  struct Rival {
    std::int32_t id;
    float low;        ///< no point of the block has a smaller cost to it
    float high;       ///< nor a larger one
    std::size_t hint; ///< the sample of the segments that is farthest, about
  };

  /** What is known of a point: low <= D_min <= high once it is decided. */
  struct State {
    float low;
    float high;           ///< at least D_min over all seeds, decided or not
    std::int32_t group;   ///< id of the argmin over the seeds it was compared with
    std::int32_t decided; ///< it was compared with the seeds whose ids are below this
    std::int32_t tried;   ///< those below this are not tried again for `high`

    bool
    isExact() const
    {
      return low == high;
    }
  };

  /** The state of a point before any comparison. */
  static const State unknown;

  /** A point that is compared. */
  struct Target {
    Eigen::Vector3f position;
    std::size_t index; ///< among the points
  };

  struct Seed {
    Target point;
    std::size_t rank;
  };

  /** A seed while it is compared with blocks. */
  struct Newcomer {
    Target point;
    std::int32_t id;
    bool is_last; ///< of all ranks
  };

  /** A seed that a point is close to. */
  struct Closeness {
    std::int32_t id = -1; ///< of the seed; -1: none
    float cid = 0.0f;     ///< at least the CID of the two
  };

  /** Which argmax is asked for. */
  struct Query {
    bool seeds; ///< the points that may become seeds; else those that count in r_k
    const SoftDraw* draw = nullptr; ///< whose factors D_min is multiplied by

    /** The largest of these factors. */
    float
    most() const
    {
      return draw ? SoftDraw::largest_factor : 1.0f;
    }
  };

  /** What a thread needs while it compares. */
  struct Scratch {
    explicit Scratch(const BlockGroups& groups)
    : search(groups.points_.field(), groups.order_)
    {
    }

    SegmentSearch search;
    std::vector<Contender> contenders;
    Eigen::ArrayXf caps;
  };

  /** What a point is excluded from. */
  enum Mark : std::uint8_t { isolated = 1, no_candidate = 2, no_gain = 4 };

  const BlockTree&
  tree() const
  {
    return points_.tree();
  }

  static std::size_t
  slotOf(std::size_t block, int row)
  {
    return block * PointBlock::capacity + static_cast<std::size_t>(row);
  }

  Target
  target(std::size_t block, int row) const
  {
    return {tree().block(block).point(row),
            static_cast<std::size_t>(tree().block(block).index[row])};
  }

  const Seed&
  seed(std::int32_t id) const
  {
    return seeds_[static_cast<std::size_t>(id)];
  }

  /** One past the last id. */
  std::int32_t
  endOfIds() const
  {
    return static_cast<std::int32_t>(seeds_.size());
  }

  PairCost
  costOf(std::int32_t id, const Target& point) const
  {
    return points_.costs().between(seed(id).point.index, point.index);
  }

  Segment
  segmentTo(std::int32_t id, const Target& point) const
  {
    return {seed(id).point.position, point.position, points_.areOnSurface()};
  }

  // block_groups.cpp
  void
  setRanks();

  bool
  isDecided(const State& state, bool exactly) const
  {
    return state.decided == endOfIds() && (!exactly || state.isExact());
  }

  bool
  orphan(std::size_t block, const std::vector<bool>& removed);

  void
  adopt(std::size_t block, bool exactly, Scratch& scratch);

  void
  decideBlock(std::size_t block, bool exactly, Scratch& scratch);

  void
  updateAllNodes();

  // block_comparison.cpp
  float
  beatenAt(std::size_t node, const Newcomer& seed) const;

  bool
  compareNode(std::size_t node, const Newcomer& seed, std::size_t& hint) const;

  void
  compareBlock(std::size_t node,
               const Newcomer& seed,
               std::size_t hint,
               Scratch& scratch);

  void
  compareBelow(std::size_t node,
               const Newcomer& seed,
               std::size_t hint,
               Scratch& scratch);

  // point_contenders.cpp
  Contender
  contender(std::int32_t id, float low, std::size_t hint) const
  {
    return {id, seed(id).rank, low, false, hint};
  }

  static void
  sortFrom(std::int32_t first, std::vector<Contender>& contenders);

  float
  atMost(std::size_t block, const State& state) const;

  void
  decide(std::size_t block, int row, bool exactly, Scratch& scratch);

  void
  collectContenders(std::size_t block,
                    const Target& point,
                    const State& state,
                    Scratch& scratch) const;

  std::optional<Contender>
  nearestOfFew(const Target& point, bool exactly, float& high, Scratch& scratch) const;

  Contender
  nearestOfMany(const Target& point,
                std::int32_t likely,
                float high,
                Scratch& scratch) const;

  float
  boundAtHint(const Contender& contender, const Target& point) const;

  DistanceBounds
  compare(Contender& contender,
          const Target& point,
          float limit,
          bool exactly,
          SegmentSearch& search) const;

  void
  keepHints(std::size_t block, const std::vector<Contender>& contenders);

  // farthest_point.cpp
  void
  updateAbove(std::size_t node);

  bool
  gains(std::size_t block, int row) const;

  Closeness
  fallsShort(std::size_t block, int row, float floor, Scratch& scratch);

  Closeness
  closenessOf(const Target& point, const State& state) const;

  void
  shareWithNeighbors(std::size_t block, int row, const Closeness& closest);

  Farthest
  farthestOfBlock(std::size_t block, float floor, const Query& query, Scratch& scratch);

  std::vector<std::size_t>
  blocksAbove(float floor) const;

  std::vector<std::size_t>
  mostPromising(const std::vector<std::size_t>& blocks) const;

  Farthest
  farthestOfBlocks(const std::vector<std::size_t>& blocks,
                   const Query& query,
                   Work work,
                   ProgressSpan span,
                   Farthest best);

  Farthest
  argmax(const Query& query, Work work, ProgressSpan span);

  const WorkingPoints& points_;
  SampleOrder order_;
  float slack_;             ///< covers the rounding of the coordinates of two samples
  std::vector<Seed> seeds_; ///< by id; those that were taken away stay in their place
  std::vector<std::int32_t> ranked_;       ///< ids by rank
  std::size_t to_come_ = 0;                ///< seeds that will follow
  std::vector<State> states_;              ///< by slot
  std::vector<std::vector<Rival>> rivals_; ///< by block
  std::vector<std::int32_t> likely_;       ///< by block: the last seed found close
  std::vector<float> upper_;        ///< by node: at least D_min of each of its points
  std::vector<std::uint8_t> marks_; ///< by slot: of Mark
  std::vector<std::uint8_t> exact_; ///< by block: all is decided, and exactly
};

} // namespace pcl_cid
