/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest seed of every point, block by block, decided as late as possible.
 */

#pragma once

#include "base/parallel_for.h"
#include "cid/node_costs.h"
#include "cid/segment_search.h"
#include "field/block_tree.h"
#include "field/distance_grid.h"
#include <pcl_cid/core/soft_draw.h>

#include <pcl_cid/core/seed_proposal.h>

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace pcl_cid {

/** \brief D_min of Algorithm 1 and its argument for every point: exactly what comparing
 *  all pairs would give, with most pairs never looked at. Where pairs have a cost, that
 *  stands in the place of the CID throughout: it never falls when the CID grows.
 *
 *  A new seed is first compared with whole blocks of points, down a tree of blocks. For
 *  a point p within R of the centre c of its block, sample l of the segment from the
 *  seed s to p is within R l / (M - 1) of that of the segment to c, and d is
 *  1-Lipschitz, so bounds at the samples of one segment bound the CIDs of all points of
 *  the block. Where the seed may win it becomes a *rival* in the block, with an
 *  interval for its CIDs.
 *
 *  Points are compared one by one only when something depends on them: when they may be
 *  the farthest one, and at the end. Most rivals are out by then, beaten by seeds that
 *  came later. Which comparisons are made depends on threads; their result does not. */
class BlockGroups {
public:
  /** \param[in] points the points that are grouped; often those of the surface */
  BlockGroups(const DistanceField& field,
              const Points& points,
              const GroupingOptions& options,
              Progress& progress);

  /** \brief Go on from what an earlier run decided. */
  void
  restore(const SeedProposal& proposal);

  /** \brief Only these may become seeds; without this call, all points may. */
  void
  setCandidates(const pcl::Indices& candidates);

  /** \brief Compare a new seed with all points.
   *  \param[in] to_come how many seeds will follow, about: what is found out now is
   *  worth the more
   *  \param[in] span the share of the progress */
  void
  addSeed(pcl::index_t seed, std::size_t to_come, ProgressSpan span);

  struct Farthest {
    float value = -1.0f;     ///< D_min, times the factor of a draw
    pcl::index_t point = -1; ///< -1: there is none
  };

  /** \brief r_k, the largest D_min of all points that are not isolated. */
  float
  coverage(ProgressSpan span);

  /** \brief argmax of D_min over the points that would gain by being a seed; the lowest
   *  index of equal ones. */
  Farthest
  farthest(ProgressSpan span);

  /** \brief One of these points at random, by the soft rule. */
  Farthest
  draw(const SoftDraw& draw, ProgressSpan span);

  /** \brief Decide every point.
   *  \param[in] keep_cid also the exact CIDs, which costs more
   *  \param[out] proposal its group and, when kept, cid; else cid is empty */
  void
  finish(ProgressSpan span, bool keep_cid, SeedProposal& proposal);

private:
  struct Rival {
    std::int32_t number; ///< of the seed
    float low;           ///< no point of the block has a smaller cost to it
    float high;          ///< nor a larger one
    std::size_t hint;    ///< the sample of the segments that is farthest, about
  };

  /** What is known of a point. */
  struct State {
    float high;           ///< at least D_min over all seeds
    float cid;            ///< D_min over the first `decided` seeds
    std::int32_t group;   ///< argmin over them
    std::int32_t decided; ///< number of seeds that it was compared with
    std::int32_t tried;   ///< number of seeds that are not tried again for `high`
  };

  /** A seed that a point may belong to. */
  struct Contender {
    std::int32_t number; ///< of the seed
    float low;           ///< at most the cost of the two
    bool settled;        ///< it is the cost, or enough is known without it
    Rival* rival;        ///< null for the seed that the point belonged to so far

    /** The smaller CID wins; at equal CID the earlier seed. */
    bool
    operator<(const Contender& other) const
    {
      return low < other.low || (low == other.low && number < other.number);
    }

    /** From which cost on the other one is better than this. */
    float
    limitAgainst(const Contender& other) const
    {
      constexpr float infinity = std::numeric_limits<float>::infinity();
      return number < other.number ? std::nextafter(other.low, infinity) : other.low;
    }
  };

  /** A point that is compared. */
  struct Target {
    Eigen::Vector3f position;
    std::size_t index; ///< among the points
  };

  /** A seed: the same. */
  using Seed = Target;

  /** A seed that a point is close to. */
  struct Closeness {
    std::int32_t number = -1; ///< of the seed; -1: none
    float cid = 0.0f;         ///< at least the CID of the two
  };

  /** What an argmax is of. */
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

  /** What a point is left out of. */
  enum Mark : std::uint8_t { isolated = 1, barred = 2 };

  std::size_t
  slotOf(std::size_t block, int row) const
  {
    return block * PointBlock::capacity + static_cast<std::size_t>(row);
  }

  Target
  target(std::size_t block, int row) const
  {
    return {tree_.block(block).point(row),
            static_cast<std::size_t>(tree_.block(block).index[row])};
  }

  Seed
  seedAt(pcl::index_t point) const
  {
    const auto index = static_cast<std::size_t>(point);
    return {tree_.position(slot_of_point_[index]), index};
  }

  void
  mark(const pcl::Indices& points, std::uint8_t marks);

  bool
  compareNode(std::size_t node, const Seed& seed, std::size_t& hint) const;

  void
  compareBlock(std::size_t node, const Seed& seed, std::size_t hint);

  void
  compareBelow(std::size_t node, const Seed& seed, std::size_t hint);

  void
  updateAbove(std::size_t node);

  static void
  sortFrom(std::int32_t first, std::vector<Contender>& contenders);

  float
  atMost(std::size_t block, const State& state) const;

  Closeness
  fallsShort(std::size_t block, int row, float floor);

  Closeness
  closenessOf(const Target& point, const State& state) const;

  void
  shareWithNeighbors(std::size_t block, int row, const Closeness& closest);

  const Seed&
  seedOf(const Contender& contender) const
  {
    return seeds_[static_cast<std::size_t>(contender.number)];
  }

  PairCost
  costOf(const Contender& contender, const Target& point) const
  {
    return costs_.between(seedOf(contender).index, point.index);
  }

  Segment
  segmentTo(const Contender& contender, const Target& point) const
  {
    return {seedOf(contender).position, point.position, !own_tree_};
  }

  float
  boundAtHint(const Contender& contender, const Target& point) const;

  float
  compare(const Contender& contender,
          const Target& point,
          float limit,
          bool keep_cid) const;

  void
  decide(std::size_t block, int row, bool keep_cid);

  std::vector<Contender>&
  contenders(std::size_t block, const Target& point, State& state);

  std::optional<Contender>
  nearestOfFew(const Target& point, bool keep_cid, std::vector<Contender>& open) const;

  Contender
  nearestOfMany(const Target& point,
                std::int32_t likely,
                float high,
                std::vector<Contender>& open) const;

  bool
  gains(std::size_t block, int row) const;

  Farthest
  settle(std::size_t block, float floor, const Query& query);

  std::vector<std::size_t>
  blocksAbove(float floor) const;

  std::vector<std::size_t>
  mostPromising(const std::vector<std::size_t>& blocks) const;

  Farthest
  settleAll(const std::vector<std::size_t>& blocks,
            const Query& query,
            ProgressSpan span,
            Farthest best);

  Farthest
  argmax(const Query& query, ProgressSpan span);

  const DistanceField& field_;
  const DistanceGrid& grid_;
  int threads_;
  std::unique_ptr<BlockTree> own_tree_; ///< of points that are not the surface
  const BlockTree& tree_;
  NodeCosts costs_;
  SampleOrder order_;
  float slack_; ///< covers the rounding of the coordinates of any two samples
  Progress& progress_;
  std::vector<Seed> seeds_;
  std::size_t to_come_ = 0;                ///< seeds that will follow
  std::vector<State> states_;              ///< by slot
  std::vector<std::vector<Rival>> rivals_; ///< by block
  std::vector<std::int32_t> likely_;       ///< by block: whom a point was close to last
  std::vector<float> upper_; ///< by node: at least D_min of each of its points
  std::vector<std::int32_t> slot_of_point_;
  std::vector<std::uint8_t> marks_; ///< by slot: of Mark
};

} // namespace pcl_cid
