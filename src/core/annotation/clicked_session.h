/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Seeds with their true labels, and the labels of all points.
 */

#pragma once

#include <pcl_cid/core/annotation.h>
#include <pcl_cid/core/label_session.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief The class that all instances have. */
constexpr std::uint32_t class_of_instances = 1;

/** \brief A session in which each seed has its true label, one for each click.
 *
 *  Points are those that are worked on, by their index (see PreparedScan::working()).
 */
class ClickedSession {
public:
  /** How often labels are asked for. Either gives the same ones. */
  enum class Looks {
    rare,       ///< after many clicks
    after_click ///< what a look finds out about CIDs is kept: half the time
  };

  /** \throws CIDException when the task is not one */
  ClickedSession(const AnnotationTask& task, Looks looks);

  const PreparedScan&
  scan() const
  {
    return session_.scan();
  }

  const LabelSession&
  session() const
  {
    return session_;
  }

  /** \brief True label of each point. */
  const std::vector<std::uint32_t>&
  truth() const
  {
    return truth_;
  }

  /** \brief Label of each point, that of its seed; 0 without seeds. */
  const std::vector<std::uint32_t>&
  labels() const
  {
    return labels_;
  }

  std::size_t
  clicks() const
  {
    return session_.grouping().numberOfSeeds();
  }

  /** \brief Let Algorithm 1 propose where to click, as far as there is anything left.
   *  \param[in] seeds all in all
   *  \throws CIDCancelled */
  void
  propose(std::size_t seeds, const ExecutionOptions& execution);

  /** \brief Click on points, none of which is a seed.
   *  \throws CIDCancelled */
  void
  click(const pcl::Indices& points, const ExecutionOptions& execution);

  /** \brief The state with the labels that there are. */
  AnnotationState
  state() const
  {
    return state(labels_);
  }

  /** \brief The state with other labels of the points. */
  AnnotationState
  state(const std::vector<std::uint32_t>& labels) const;

private:
  void
  updateLabels(const ExecutionOptions& execution);

  action::Answer
  answerFor(pcl::index_t seed) const;

  LabelSession session_;
  bool clean_up_;
  std::vector<std::uint32_t> cloud_truth_; ///< of all points; 0 for those left out
  std::vector<std::uint32_t> truth_;
  std::vector<std::uint32_t> labels_;
};

} // namespace pcl_cid
