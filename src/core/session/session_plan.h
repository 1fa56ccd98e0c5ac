/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What an action will do to a session, and what it has done.
 */

#pragma once

#include <pcl_cid/core/label_session.h>
#include <pcl_cid/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_cid {

/** \brief What is known of seeds and instances. */
struct LabelSession::Tables {
  /** By number of the seed; empty for a question. */
  std::vector<std::optional<std::uint32_t>> label_of_seed;
  std::vector<NamedInstance> instances;
  std::uint32_t next_label = 1; ///< above all labels that there were
};

/** \brief What an action will do, once it is known to be possible. */
struct LabelSession::Plan {
  Tables tables; ///< afterwards, but for seeds that are proposed
  /** One of these three at most. */
  std::size_t proposed = 0;         ///< seeds to be proposed
  pcl::Indices added;               ///< seeds that join
  std::vector<std::size_t> removed; ///< numbers of seeds that go, ascending
  pcl::Indices painted;
  std::uint32_t paint = not_painted; ///< what with
};

/** \brief An action that was done, and what it takes to undo it. */
struct LabelSession::Step {
  struct RemovedSeed {
    std::size_t number;
    pcl::index_t point;
  };

  struct PaintedPoint {
    pcl::index_t point;
    std::uint32_t before;
  };

  LabelAction action;
  std::shared_ptr<const Tables> tables; ///< before
  std::vector<RemovedSeed> removed;     ///< by number, ascending
  std::size_t added;                    ///< seeds, after all others
  std::vector<PaintedPoint> painted;

  bool
  changesSeeds() const
  {
    return added > 0 || !removed.empty();
  }
};

/** \brief Turns actions into plans. */
class LabelSession::Planner {
public:
  /** \param[in] session must outlive this */
  explicit Planner(const LabelSession& session);

  /** \throws CIDException when an action is not possible */
  Plan
  plan(const LabelAction& action);

  void
  operator()(const action::Propose& propose);
  void
  operator()(const action::Label& label);
  void
  operator()(const action::Click& click);
  void
  operator()(const action::Remove& remove);
  void
  operator()(const action::Paint& paint);
  void
  operator()(const action::Unpaint& unpaint);
  void
  operator()(const action::Edit& edit);
  void
  operator()(const action::Merge& merge);
  void
  operator()(const action::Delete& deletion);
  void
  operator()(const action::Settle&);
  void
  operator()(const action::Undo&);
  void
  operator()(const action::Redo&);

private:
  std::vector<NamedInstance>::iterator
  find(std::uint32_t label);

  std::uint32_t
  labelFor(const action::Answer& answer);

  std::uint32_t
  add(const action::NewInstance& instance);

  std::size_t
  numberOf(pcl::index_t seed) const;

  void
  requirePoints(const pcl::Indices& points) const;

  void
  removeSeeds(std::vector<std::size_t> numbers);

  pcl::Indices
  paintedWith(std::uint32_t label) const;

  const LabelSession& session_;
  const pcl::Indices seeds_;
  Plan plan_;
};

} // namespace pcl_cid
