/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where the labels of a session may be wrong.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/label_session.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

class SampleGraph;

/** \brief Points next to each other whose labels are doubtful. */
struct DoubtfulArea {
  pcl::index_t point; ///< the one that is farthest from all points outside
  pcl::Indices points;
};

/** \brief How sure the labels of a session are (*ours*), at a sample of its points.
 *
 *  The *margin* of a point is what the nearest seed of another label costs it more than
 *  the nearest seed of its own: near 0, another label is nearly as likely. Questions do
 *  not count, and a point has no margin (NaN) where it was painted, where its seed is a
 *  question, or where there is no other label. Exact, and so only as many points are
 *  looked at as are worth the time; what a seed costs them is found once.
 *  \note Cost: a CID for each of the points and each new seed; memory: 4 bytes for each
 *  of these pairs. It serves one thread. */
class PCL_CID_EXPORT LabelDoubt {
public:
  /** So many points of a scan tell where doubt is, and a click costs as many CIDs. */
  static constexpr std::size_t enough_points = 20000;

  /** \param[in] scan not null; its sessions are asked about
   *  \param[in] samples M, as in the sessions
   *  \param[in] points indices of the cloud: finite, selected, at least 1, each once
   *  \throws CIDException, CIDCancelled
   *  \note Cost: the neighbors of the points. */
  LabelDoubt(PreparedScan::ConstPtr scan,
             int samples,
             const pcl::Indices& points,
             const ExecutionOptions& execution = {});
  ~LabelDoubt();
  LabelDoubt(const LabelDoubt&) = delete;
  LabelDoubt&
  operator=(const LabelDoubt&) = delete;

  /** \brief The margins of the labels that a session has now, metres; one for each of
   *  the points.
   *  \throws CIDException when it is a session of another scan, CIDCancelled */
  std::vector<float>
  margins(const LabelSession& session, const ExecutionOptions& execution = {});

  /** \brief Of the points with a margin below a limit, a set that hangs together, by
   *  size; of equally large ones that with the earliest point comes first. Two points
   *  are neighbors when each is within two local spacings of the other, of all points
   *  that are looked at.
   *  \param[in] margins as margins() returned them
   *  \param[in] below metres
   *  \param[in] rank 0 for the largest
   *  \return nothing when there are not so many */
  std::optional<DoubtfulArea>
  area(const std::vector<float>& margins, float below, std::size_t rank = 0) const;

private:
  using Costs = std::vector<float>;

  void
  updateCosts(const std::vector<SessionSeed>& seeds, const ExecutionOptions& execution);

  Costs
  costsOf(pcl::index_t seed, const ExecutionOptions& execution) const;

  PreparedScan::ConstPtr scan_;
  int samples_;
  pcl::Indices points_;            ///< of the cloud
  pcl::Indices working_;           ///< the same among the points that are worked on
  std::vector<std::size_t> order_; ///< those that are near each other in a row
  std::unique_ptr<SampleGraph> graph_;
  std::map<pcl::index_t, Costs> costs_; ///< by seed, of each point
};

} // namespace pcl_cid
