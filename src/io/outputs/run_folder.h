/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A folder in which a run has outputs.
 */

#pragma once

#include "hidden_files.h"

#include <memory>
#include <string>

namespace pcl_cid {

/** \brief A folder in which a run has outputs, from the announcement to the end.
 *
 *  All hidden names in it begin with a base of the run's own, whatever the outputs are
 *  called and however long their names are:
 *
 *  - BASE.run is locked while the run lives; the system unlocks it however the run
 *    ends. It holds the base in the first folder of the run, where the record of a
 *    commit is.
 *  - BASE-1.partial, BASE-2.older, ...: see commit_record.h. */
class RunFolder {
public:
  /** \param[in] folder absolute, links resolved
   *  \param[in] first the first folder of the run; nullptr when it is this one
   *  \throws std::system_error when nothing can be written to the folder */
  RunFolder(const std::string& folder, const RunFolder* first);

  /** \brief Unless it was left to the next run, nothing of the run's own stays. */
  ~RunFolder();

  RunFolder(const RunFolder&) = delete;
  RunFolder&
  operator=(const RunFolder&) = delete;

  const std::string&
  folder() const
  {
    return folder_;
  }

  const std::string&
  base() const
  {
    return base_;
  }

  /** \brief A hidden name in this folder that nothing has.
   *  \param[in] purpose how it ends */
  std::string
  newName(const std::string& purpose);

  /** \brief Whether the next run in this folder has a record to see to. */
  void
  leaveToNextRun(bool is_left) noexcept
  {
    is_left_ = is_left;
  }

private:
  void
  lockNewBase();

  std::string folder_;
  std::string base_;
  std::string lock_name_;
  std::unique_ptr<OpenFile> lock_;
  int names_ = 0;
  bool is_left_ = false;
};

} // namespace pcl_cid
