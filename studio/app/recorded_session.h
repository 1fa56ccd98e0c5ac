/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan and its session, in memory and on the disk.
 */

#pragma once

#include "places.h"

#include <pcl_cid/core/label_doubt.h>
#include <pcl_cid/core/label_session.h>
#include <pcl_cid/core/part_session.h>
#include <pcl_cid/io/session_file.h>

#include <memory>
#include <optional>

namespace pcl_cid::studio {

/** \brief A session whose every action is on the disk before it is done. */
class RecordedSession {
public:
  /** \brief Do again what the file says.
   *  \param[in] file must outlive this; its scan and settings are those of \a session
   *  \throws CIDException when an action in it is not possible, CIDCancelled */
  RecordedSession(LabelSession session,
                  SessionFile& file,
                  const ExecutionOptions& execution = {});

  const LabelSession&
  session() const
  {
    return session_;
  }

  /** \brief How many actions there were. */
  std::size_t
  revision() const
  {
    return revision_;
  }

  /** \brief As LabelSession::apply().
   *  \throws CIDException also when the disk does not take it; then nothing is done */
  pcl::Indices
  apply(const LabelAction& action, const ExecutionOptions& execution = {});

  /** \brief The parts of the scan. When they are first asked for, all is done that the
   *  file says of them.
   *  \throws CIDException when that is not possible, CIDCancelled */
  const PartSession&
  parts(const ExecutionOptions& execution = {});

  /** \brief As PartSession::apply(); on the disk before it counts.
   *  \throws CIDException, as above, and when the disk does not take it; then nothing
   *  is done */
  void
  applyToParts(const PartAction& action, const ExecutionOptions& execution = {});

private:
  LabelSession session_;
  std::optional<PartSession> parts_; ///< made when they are asked for
  SessionFile& file_;
  std::size_t revision_;
};

} // namespace pcl_cid::studio
