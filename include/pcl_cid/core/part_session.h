/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts of a scan while a person chooses them.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/part_action.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Groups of a scan and their merge tree; no choice changes them. */
struct Decomposition {
  /** See Grouping::groups(). */
  std::vector<pcl::index_t> groups;
  MergeTree tree; ///< the whole one
};

/** \brief A part that was chosen. */
struct ChosenPart {
  std::vector<int> groups; ///< ascending, at least one
  std::size_t size = 0;    ///< points of these
  /** CID_g of the merge that it comes from, metres; nothing for a single group and for
   *  what was joined by hand. */
  std::optional<double> height;
  bool splits = false; ///< it was joined of two
  bool dropped = false;
  bool exact = false; ///< its hull shall not be made simpler

  /** \brief What it goes by. */
  int
  number() const
  {
    return groups.front();
  }
};

/** \brief The parts of a scan while a person chooses them (Algorithm 2, and *ours*): a
 *  cut of the merge tree, and what was split, joined and dropped after it.
 *
 *  All state follows from the scan, the settings and the actions, to the bit. An action
 *  that throws changes nothing. A copy costs next to nothing: all that is large is
 *  shared.
 *  \note Thread safety: const calls may run concurrently. Memory: 4 bytes a point for
 *  each decomposition that can be taken back. */
class PCL_CID_EXPORT PartSession {
public:
  /** \param[in] scan not null
   *  \param[in] grouping how points are compared with seeds
   *  \param[in] group_samples see MergingSettings
   *  \throws CIDException when there is no scan, or a setting is out of its range */
  explicit PartSession(PreparedScan::ConstPtr scan,
                       const GroupingSettings& grouping = {},
                       std::size_t group_samples = setting::group_samples.initial);

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

  /** \brief Do something.
   *  \throws CIDException when it is not possible: there is no such part, a part is one
   *  group and cannot be split, there are not so many groups, nothing is left to take
   *  back or to do again; CIDCancelled
   *  \note Cost: part_action::Decompose that of Grouping::propose() and mergeGroups();
   *  all else O(K), and the points are not touched. */
  void
  apply(const PartAction& action, const ExecutionOptions& execution = {});

  /** \brief Null before part_action::Decompose; the same object as long as the groups
   *  are the same. */
  const std::shared_ptr<const Decomposition>&
  decomposition() const;

  /** \brief All parts, dropped ones too, by number. */
  std::vector<ChosenPart>
  parts() const;

  /** \brief How many steps can be taken back, and done again: each is an action, or
   *  cuts one after another, as a slider makes them. */
  std::size_t
  undoable() const
  {
    return done_.size();
  }

  std::size_t
  redoable() const
  {
    return undone_.size();
  }

private:
  struct State;
  class Editor;
  using States = std::vector<std::shared_ptr<const State>>;

  void
  move(States& from, States& to, const char* what);

  PreparedScan::ConstPtr scan_;
  GroupingSettings grouping_;
  MergingSettings merging_;
  std::shared_ptr<const State> state_; ///< never null
  States done_;                        ///< what was before each step
  States undone_;                      ///< the next one is the last
  bool is_cutting_ = false;            ///< the last action was a cut
};

} // namespace pcl_cid
