/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan while a person labels it: the paper's "interactive labeling tool" without its
 * window.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/label_action.h>
#include <pcl_cid/core/label_cleaning.h>
#include <pcl_cid/core/named_instance.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief A seed of a session. */
struct SessionSeed {
  pcl::index_t point; ///< of the cloud
  /** Empty: it was proposed, and not answered. Such a seed is a *question*. */
  std::optional<std::uint32_t> label;

  bool
  operator==(const SessionSeed& other) const
  {
    return point == other.point && label == other.label;
  }
};

/** \brief What to ask next. */
struct Question {
  pcl::index_t seed;    ///< a question
  std::size_t size = 0; ///< points of its group
  std::size_t left = 0; ///< questions there are, this one included
};

/** \brief A scan while a person labels it (section IV.A, and *ours*): seeds with their
 *  labels, points that were painted, instances with their classes, and every action
 *  that led there.
 *
 *  The label of a point is the one that it was painted with, or else that of its seed;
 *  0 where that is a question. All state follows from the scan, the settings and the
 *  actions, to the bit: after undo it is what it was before, and another session that
 *  does the same actions is equal to this one.
 *
 *  An action that throws changes nothing. (Except when memory runs out: then do the
 *  actions again in a new session.)
 *  \note Thread safety: const calls may run concurrently. Memory: that of a Grouping
 *  and 13 bytes a point; each action that can be taken back has what it changed. */
class PCL_CID_EXPORT LabelSession {
public:
  /** \param[in] scan not null
   *  \throws CIDException when a setting is out of its range */
  explicit LabelSession(PreparedScan::ConstPtr scan,
                        const GroupingSettings& settings = {});
  LabelSession(LabelSession&& other) noexcept;
  LabelSession&
  operator=(LabelSession&& other) noexcept;
  ~LabelSession();

  const PreparedScan&
  scan() const
  {
    return grouping_.scan();
  }

  const Grouping&
  grouping() const
  {
    return grouping_;
  }

  /** \brief Do something.
   *  \return the points whose label or seed is another one now, ascending
   *  \throws CIDException when it is not possible: what it names is not there, a point
   *  is not finite or not selected, nothing is left to take back or to do again;
   *  CIDCancelled
   *  \note Cost: a seed that comes or goes as Grouping::addSeeds() and removeSeeds()
   *  and Grouping::groups(); all else is linear in the points. */
  pcl::Indices
  apply(const LabelAction& action, const ExecutionOptions& execution = {});

  /** \brief Do many actions, one after another, and look at the labels once.
   *  \return how many were done: all, or those before the first that is not possible
   *  \throws CIDCancelled; what was done stays done */
  std::size_t
  replay(const std::vector<LabelAction>& actions,
         const ExecutionOptions& execution = {});

  /** \brief How many actions can be taken back, and done again. */
  std::size_t
  undoable() const;
  std::size_t
  redoable() const;

  /** \brief The label of each point of the cloud; 0 for a point that is not finite or
   *  not selected. */
  const std::vector<std::uint32_t>&
  labels() const
  {
    return labels_;
  }

  /** \brief The number of the seed of each point of the cloud, see Grouping::groups().
   */
  const std::vector<pcl::index_t>&
  groups() const
  {
    return groups_;
  }

  /** \brief Whether a point was painted. */
  bool
  isPainted(pcl::index_t point) const
  {
    return painted_[static_cast<std::size_t>(point)] != not_painted;
  }

  /** \brief The seeds, in the order of their numbers in the grouping. */
  std::vector<SessionSeed>
  seeds() const;

  /** \brief The instances, in the order in which they were made. */
  const std::vector<NamedInstance>&
  instances() const;

  /** \brief The labels with ragged boundaries mended, see cleanBoundaries(); painted
   *  points keep theirs, and so do those whose seed is a question. */
  std::vector<std::uint32_t>
  cleanedLabels(const CleaningSettings& settings = {},
                const ExecutionOptions& execution = {}) const;

  /** \brief The question with the most points; of equal ones that of the lowest number.
   *  \param[in] after a seed: of the questions that come after it in this order */
  std::optional<Question>
  nextQuestion(std::optional<pcl::index_t> after = std::nullopt) const;

  /** \brief The points that would have this point as their seed if it was clicked on,
   *  ascending; its own group where it is a seed.
   *  \throws CIDException when it is not finite or not selected, CIDCancelled
   *  \note Cost: a copy of the grouping, Grouping::addSeeds() and groups(). */
  pcl::Indices
  preview(pcl::index_t point, const ExecutionOptions& execution = {}) const;

private:
  struct Tables;
  struct Plan;
  class Planner;
  struct Step;

  static constexpr std::uint32_t not_painted = 0xFFFFFFFFu;

  bool
  perform(const LabelAction& action, const ExecutionOptions& execution);

  bool
  undo(unsigned int threads);

  Step
  carryOut(Plan plan, const LabelAction& action, const ExecutionOptions& execution);

  void
  takeBack(const Step& step, unsigned int threads);

  void
  propose(std::size_t seeds, Plan& plan, const ExecutionOptions& execution);

  void
  paint(const pcl::Indices& points, std::uint32_t label, Step& step);

  pcl::Indices
  updateLabels(const pcl::Indices& old_seeds,
               bool has_new_groups,
               unsigned int threads);

  std::vector<std::uint32_t>
  labelsOfSeeds() const;

  Grouping grouping_;
  std::shared_ptr<const Tables> tables_; ///< never null; shared with steps
  std::vector<bool> is_selected_;        ///< by point of the cloud, as all below
  std::vector<std::uint32_t> painted_;   ///< or not_painted
  std::vector<pcl::index_t> groups_;
  std::vector<std::uint32_t> labels_;
  std::vector<Step> done_;
  std::vector<LabelAction> undone_; ///< the next one to do again is the last
};

} // namespace pcl_cid
