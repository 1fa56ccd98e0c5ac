/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls of the parts that a person looks at.
 */

#pragma once

#include "abstract/abstract_settings.h"
#include "run/loaded_scan.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/hull_tightness.h>
#include <pcl_cid/core/part_session.h>

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_cid::studio {

/** \brief Hulls of parts as they would be exported, and how tightly each fits. They are
 *  made when they are asked for, and kept as long as the groups are the same. */
class PartHulls {
public:
  /** \param[in] scan,settings must outlive this */
  PartHulls(const tools::LoadedScan& scan, const tools::AbstractSettings& settings);

  /** \brief The hull of a part, in the frame of the scan's points; without its points.
   *  \param[in] part of this session */
  const ConvexPart&
  hullOf(const ChosenPart& part, const PartSession& session);

  /** \brief Its figures. */
  const HullTightness&
  tightnessOf(const ChosenPart& part, const PartSession& session);

private:
  /** Groups, and whether it is exact. */
  using Key = std::pair<std::vector<int>, bool>;

  struct Hull {
    ConvexPart part;
    std::optional<HullTightness> tightness;
  };

  Hull&
  find(const ChosenPart& part, const PartSession& session);

  void
  use(const PartSession& session);

  ConvexPart
  make(const ChosenPart& part, const PartSession& session) const;

  const tools::LoadedScan& scan_;
  const tools::AbstractSettings& settings_;
  std::shared_ptr<const Decomposition> decomposition_; ///< that all below is of
  std::vector<pcl::Indices> members_of_group_;         ///< among the scan's points
  std::map<Key, Hull> hulls_;
  std::unique_ptr<TightnessMeter> meter_; ///< made when it is asked for
};

} // namespace pcl_cid::studio
