/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan and its session, in memory and on the disk.
 */

#include "recorded_session.h"

#include <pcl_cid/exceptions.h>

#include <utility>

namespace pcl_cid::studio {

RecordedSession::RecordedSession(LabelSession session,
                                 SessionFile& file,
                                 const ExecutionOptions& execution)
: session_(std::move(session)), file_(file)
{
  const std::size_t recorded = file.record().actions.size();
  revision_ = replaySession(file.record(), file.path(), session_, execution);
  if (revision_ < recorded)
    file_.dropLast();
}

pcl::Indices
RecordedSession::apply(const LabelAction& action, const ExecutionOptions& execution)
{
  file_.append(action);
  try {
    pcl::Indices changed = session_.apply(action, execution);
    ++revision_;
    return changed;
  }
  catch (...) {
    file_.dropLast();
    throw;
  }
}

} // namespace pcl_cid::studio
