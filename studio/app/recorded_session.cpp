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
  revision_ += file.record().part_actions.size();
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

const PartSession&
RecordedSession::parts(const ExecutionOptions& execution)
{
  if (!parts_) {
    const Grouping& grouping = session_.grouping();
    PartSession parts(grouping.sharedScan(), grouping.settings());
    replayParts(file_.record(), file_.path(), parts, execution);
    parts_ = std::move(parts);
  }
  return *parts_;
}

void
RecordedSession::applyToParts(const PartAction& action,
                              const ExecutionOptions& execution)
{
  PartSession next = parts(execution);
  next.apply(action, execution);
  file_.append(action);
  parts_ = std::move(next);
  ++revision_;
}

} // namespace pcl_cid::studio
