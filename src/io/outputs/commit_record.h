/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The changes of a commit, and the record by which they are all made or none.
 */

#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace pcl_cid {

/** \brief A file that a commit replaces, removes or lets appear. */
struct Change {
  std::string path; ///< what its user calls it
  std::string file;
  std::string partial; ///< what takes its place; empty: it is removed
  std::string older;   ///< what was there, if anything, until all is done

  /** What tells the partial file from all others, under whatever name. */
  struct Mark {
    ino_t inode = 0;
    off_t size = 0;
    timespec written = {};
  } mark = {};
};

/** \brief The commit of a run.
 *
 *  BASE.undo, in the first folder of the run, names all changes before the first is
 *  made; BASE.done takes its place when the last one is: that is the moment of the
 *  commit. Who finds the former takes the changes back, who finds the latter removes
 *  what was there before. Both can be ended at any point and done again, and neither
 *  touches a file that somebody else has put there meanwhile. */
class Commit {
public:
  /** \param[in] base what the hidden names of the run begin with
   *  \throws CIDException when a file that is to change is a folder */
  Commit(const std::string& base, std::vector<Change> changes);

  /** \brief Make all changes, or, when one fails, none.
   *  \throws CIDException, std::bad_alloc */
  void
  make();

  /** \brief Remove what was there before.
   *  \throws CIDException; then the record stays for the next run */
  void
  finish();

  /** \brief Whether the next run in the folder has no record to see to. */
  bool
  isOver() const noexcept;

private:
  void
  makeAll();

  std::string
  takeBack();

  std::vector<Change> changes_;
  std::string begun_; ///< the record while it is being written
  std::string undo_;
  std::string done_;
};

/** \brief Bring the commit of a dead run to its end, if there is one.
 *  \throws CIDException when that is not possible */
void
endCommit(const std::string& base);

} // namespace pcl_cid
