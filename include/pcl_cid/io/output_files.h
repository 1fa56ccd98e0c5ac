/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files that appear whole or not at all, all of a run or none.
 */

#pragma once

#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief The outputs of one run.
 *
 *  Each is written beside its place, under a name of its own, and renamed once all of
 *  them are written and on the disk; until then, and when anything fails, nothing
 *  appears and what was there before stays.
 *
 *  \code
 *    pcl_cid::OutputFiles outputs({"scan.pcd"});
 *    outputs.announce("labels.pcd");
 *    outputs.write("labels.pcd", [&](std::ostream& stream) { ... });
 *    outputs.commit();
 *    \endcode */
class PCL_CID_IO_EXPORT OutputFiles {
public:
  /** \param[in] inputs files that must never be written over */
  explicit OutputFiles(std::vector<std::string> inputs);

  /** \brief Removes what was not committed. */
  ~OutputFiles();

  OutputFiles(const OutputFiles&) = delete;
  OutputFiles&
  operator=(const OutputFiles&) = delete;

  /** \brief Make sure, before long work, that this output can be written.
   *  \throws CIDException when it is an input (under whatever name) or another output,
   *  when its folder is missing or not writable, or when something that is not a file
   *  has its name */
  void
  announce(const std::string& path);

  /** \brief The same for a folder that outputs will be announced in: it is made when it
   *  is missing, and removed again when nothing is committed.
   *  \throws CIDException when it cannot be made or written to, or is not a folder */
  void
  announceFolder(const std::string& path);

  /** \brief Let commit() remove a file of an earlier run that has no place beside the
   *  outputs of this one; an output of that name is kept.
   *  \throws CIDException when it is an input */
  void
  announceRemoval(const std::string& path);

  /** \brief Write an output that was announced.
   *  \param[in] writer its exceptions pass through
   *  \throws CIDException when not all of it could be written */
  void
  write(const std::string& path, const std::function<void(std::ostream&)>& writer);

  /** \brief Where an output that was written is until commit(), for whoever wants to
   *  read it again. */
  std::string
  pathBeforeCommit(const std::string& path);

  /** \brief Let all outputs appear, then remove what was announced for it.
   *  \throws CIDException when one cannot; then none stays, and every older file is
   *  back in its place (or the message says where it is) */
  void
  commit();

private:
  struct Output {
    std::string path;    ///< as announced
    std::string target;  ///< the file that it names, links resolved
    std::string partial; ///< where it is written
  };

  struct Removal {
    std::string path;   ///< itself, should it be a link
    std::string target; ///< the file that it names, links resolved
  };

  void
  refuseInput(const std::string& path) const;

  bool
  isOutput(const std::string& target) const;

  /** A file that commit() replaces, removes or lets appear. */
  struct Change {
    std::string file;
    std::string older; ///< what was there, until all is done; empty: nothing was
  };

  void
  keepOlder(const std::string& path, const std::string& file);

  std::string
  takeBack();

  Output&
  find(const std::string& path);

  std::vector<std::string> inputs_;
  std::vector<Output> outputs_;
  std::vector<std::string> made_folders_;
  std::vector<Removal> removals_;
  std::vector<Change> changes_;
};

} // namespace pcl_cid
