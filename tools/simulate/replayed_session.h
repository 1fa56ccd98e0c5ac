/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A session of pcl_cid_studio, and what each of its actions brought.
 */

#pragma once

#include "run/run.h"
#include "scored_scan.h"
#include "simulate_settings.h"

#include <pcl_cid/core/annotation.h>
#include <pcl_cid/io/session_file.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid::tools {

/** \brief What a person has said, whether or not it was taken back later. */
struct Effort {
  std::size_t answers = 0;     ///< to questions, and other labels for seeds
  std::size_t corrections = 0; ///< clicks anywhere
  std::size_t strokes = 0;     ///< lassos that paint, or take paint away

  std::size_t
  total() const
  {
    return answers + corrections + strokes;
  }
};

/** \brief An action of a session, and the state after it. */
struct ReplayedAction {
  std::size_t line = 0;               ///< of the session file, from 1
  std::string word;                   ///< what the file calls it
  std::size_t points = 0;             ///< that it names
  std::optional<pcl::index_t> point;  ///< the first of them
  std::optional<std::uint32_t> label; ///< that it gives, or whose instance it is about
  std::string class_name;             ///< of this instance
  Effort effort;                      ///< until then, with this action
  AnnotationScore score;
};

/** \brief A session of pcl_cid_studio, and what each of its actions brought. */
struct ReplayedSession : ScoredScan {
  std::vector<ReplayedAction> actions;
};

/** \brief Do again what a session says, and score the labels after each action, with
 *  messages.
 *  \param[in] settings `input` is the scan; what labels depend on is as the session has
 *  it, see useSettingsOf()
 *  \throws CIDException when the session is not one of the scan, nothing was done in
 *  it, or an action of it is not possible; when the scan has no true labels, or cannot
 *  be worked on; CIDCancelled */
ReplayedSession
scoreSession(const SessionRecord& record, const SimulateSettings& settings, Run& run);

} // namespace pcl_cid::tools
