/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Seeds and the group of every point: a result that can be changed.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <memory>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

class BlockGroups;
class ConnectedGroups;

/** \brief Seeds, and the seed that each point belongs to.
 *
 *  The seeds of a proposal are in the order in which they were chosen, and nested: the
 *  first k of them are what k seeds would have been. */
struct SeedProposal {
  /** Index of each seed among the points. */
  pcl::Indices seeds;
  /** Number (0, 1, ...) of the seed with the smallest CID_p (or cost, where pairs have
   *  one) to each point; -1 for a point that was not grouped. At equal CID the earlier
   *  seed keeps the point. The point of a seed always belongs to that seed. */
  std::vector<pcl::index_t> group;
  /** The smallest CID_p (or cost) of each point to any of the seeds, metres: that to
   *  its seed, except that the point of a seed may be nearer to another one. NaN for a
   *  point that was not grouped. Empty when it was not asked for. */
  std::vector<float> cid;
  /** r_k for each seed: the largest entry of `cid` once that seed was taken in. Never
   *  grows; the last one is a guarantee: every point that is not isolated is within it
   *  of its seed. */
  std::vector<float> coverage;
};

/** \brief How points are compared with seeds. */
struct GroupingSettings {
  /** M: samples on a segment (Eq. 2). */
  int samples = setting::samples.initial;
  SeedingRule seeding = setting::seeding.initial;
  /** Whether every verb leaves exact CIDs behind. A first propose() takes about 50 %
   *  longer then; adding or removing a seed later, a third less time. Otherwise a
   *  point's CID is made exact when something depends on it. Results are the same. */
  bool keep_cid = false;
};

/** \brief Why Algorithm 1 stopped. */
enum class ProposalStop {
  seeds,    ///< there are as many seeds as were asked for
  coverage, ///< every point is close enough to its seed
  no_gain   ///< no candidate is left that would gain by being a seed
};

/** \brief Seeds and groups on a prepared scan (Algorithm 1 and section IV.A). Seeds can
 *  be proposed, added and taken away at any time.
 *
 *  After any sequence of these the state equals, to the bit, one run from scratch with
 *  the same seeds in the same order; adding a seed costs about as much as the points it
 *  wins, taking one away as the points it had. To undo addSeeds(), remove what was
 *  added; to undo removeSeeds(), insert each seed at its old number, lowest first.
 *
 *  Points go by their index in the input cloud, seeds by their number, 0 for the first.
 *
 *  \code
 *    pcl_cid::Grouping grouping(scan);
 *    grouping.propose(100);
 *    grouping.addSeeds({1234});
 *    const std::vector<pcl::index_t> group = grouping.groups();
 *  \endcode
 *
 *  A verb that throws changes nothing. (Except when memory runs out in a verb without a
 *  progress callback: then no seeds are left.) Copies are independent and share the
 *  scan. Const calls may run concurrently.
 *  \note Memory: about 30 bytes a point; up to 100 more, shared by copies, where groups
 *  are made connected.
 */
class PCL_CID_EXPORT Grouping {
public:
  using ConstPtr = std::shared_ptr<const Grouping>;

  /** \brief No seeds yet.
   *  \param[in] scan not null
   *  \throws CIDException when a setting is out of its range */
  explicit Grouping(PreparedScan::ConstPtr scan, const GroupingSettings& settings = {});
  Grouping(const Grouping& other);
  Grouping(Grouping&& other) noexcept;
  Grouping&
  operator=(Grouping other) noexcept;
  ~Grouping();

  const PreparedScan&
  scan() const
  {
    return *scan_;
  }

  const PreparedScan::ConstPtr&
  sharedScan() const
  {
    return scan_;
  }

  const GroupingSettings&
  settings() const
  {
    return settings_;
  }

  /** \brief Algorithm 1 (CID-FPS), from the start of the scan or on from the seeds that
   *  there are: again and again the candidate with the largest CID to its seed becomes
   *  the next one; at equal CID the one of lowest index. A duplicate of a seed never
   *  does.
   *  \param[in] seeds K, all in all: at least 1
   *  \param[in] coverage stop as soon as coverage() is at most this, metres, 0 or more
   *  \throws CIDException for a value out of its range, CIDCancelled
   *  \note Cost: the new seeds times N CID evaluations, nearly all given up after one
   *  or two samples. */
  ProposalStop
  propose(std::size_t seeds,
          float coverage = setting::coverage.initial,
          const ExecutionOptions& execution = {});

  /** \brief Given seeds join, after all others.
   *  \param[in] seeds finite, selected points that are no seeds yet
   *  \throws CIDException, CIDCancelled */
  void
  addSeeds(const pcl::Indices& seeds, const ExecutionOptions& execution = {});

  /** \brief Given seeds join, before the seed of a number; that one and those after it
   *  move up.
   *  \param[in] number 0 to numberOfSeeds() */
  void
  insertSeeds(const pcl::Indices& seeds,
              std::size_t number,
              const ExecutionOptions& execution = {});

  /** \brief Take seeds away: their points go to the seeds that remain. With none left,
   *  nothing is grouped.
   *  \param[in] numbers of the seeds, in any order, each once
   *  \throws CIDException when there is no such seed, CIDCancelled */
  void
  removeSeeds(std::vector<std::size_t> numbers, const ExecutionOptions& execution = {});

  std::size_t
  numberOfSeeds() const;

  /** \brief The seeds, by number. */
  pcl::Indices
  seeds() const;

  /** \brief The largest CID of a point that is not isolated to its seed, metres; NaN
   *  without seeds. */
  float
  coverage() const
  {
    return coverage_;
  }

  /** \brief The number of the seed of each point of the cloud, -1 for a point that is
   *  not finite or not selected, and for all without seeds. The point of a seed always
   *  belongs to that seed. */
  std::vector<pcl::index_t>
  groups(const ExecutionOptions& execution = {}) const;

  /** \brief The smallest CID (or cost) of each point of the cloud to any of the seeds,
   *  metres; NaN where there is none.
   *  \note Where they are not kept, they are made exact on a copy first. */
  std::vector<float>
  cids(const ExecutionOptions& execution = {}) const;

  /** \brief Seeds, groups, and the coverage after each seed; CIDs where they are kept.
   *
   *  \note After a removal or an insertion, the coverage after each of the seeds from
   *  there on, but the last, is not known: NaN. */
  SeedProposal
  proposal(const ExecutionOptions& execution = {}) const;

  /** \brief How many times a seed was compared with all points since this grouping, or
   *  the one it was copied from, was made: what its seeds have cost. */
  std::size_t
  comparisons() const
  {
    return comparisons_;
  }

  /** \brief The number of the seed of each point that is worked on (see
   *  PreparedScan::working()). */
  std::vector<pcl::index_t>
  groupsOfWorkingPoints(const ExecutionOptions& execution = {}) const;

private:
  class Verb;

  void
  clear() noexcept;

  pcl::Indices
  newSeeds(const pcl::Indices& seeds) const;

  PreparedScan::ConstPtr scan_;
  GroupingSettings settings_;
  std::unique_ptr<BlockGroups> groups_;
  /** Shared with copies, whose islands are much the same; null where groups need not be
   *  connected. */
  std::shared_ptr<ConnectedGroups> connected_;
  std::vector<float> coverages_; ///< r_k for the first seeds, as far as it is known
  float coverage_;
  std::size_t comparisons_ = 0;
};

} // namespace pcl_cid
