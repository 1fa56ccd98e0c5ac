/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pages do to the parts of a scan, and ask about them.
 */

#pragma once

#include "part_export.h"
#include "part_hulls.h"
#include "places.h"
#include "recorded_session.h"
#include "server/frame.h"

#include <memory>
#include <vector>

namespace pcl_cid::studio {

/** \brief The parts mode of a session. */
class PartDesk {
public:
  /** \param[in] session,places,scan,settings,exporter must outlive this */
  PartDesk(RecordedSession& session,
           const Places& places,
           const tools::LoadedScan& scan,
           const tools::AbstractSettings& settings,
           const PartExporter& exporter);

  /** \brief Whether a question is about parts. */
  static bool
  answers(const nlohmann::json& header);

  /** \brief The answer, without its id.
   *  \throws CIDException, CIDCancelled */
  Frame
  answer(const Frame& question, const ExecutionOptions& execution);

  /** \brief What there is to say after a change. */
  nlohmann::json
  summary(const ExecutionOptions& execution);

private:
  std::vector<ChosenPart>
  partsIn(const nlohmann::json& header, const PartSession& session) const;

  Frame
  hulls(const Frame& question, const PartSession& session);

  Frame
  tightness(const Frame& question, const PartSession& session);

  Frame
  exportParts(const Frame& question, const PartSession& session) const;

  RecordedSession& session_;
  const Places& places_;
  const PartExporter& exporter_;
  PartHulls hulls_;
  /** The last one that pages were told of, and its number. */
  std::shared_ptr<const Decomposition> decomposition_;
  std::size_t decomposition_number_ = 0;
};

} // namespace pcl_cid::studio
