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

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pcl_cid {

class RunFolder;
struct Change;

/** \brief The name of the standard output, as an output like others. */
constexpr const char* standard_output = "-";

/** \brief The outputs of one run.
 *
 *  Each is written beside its place, under a hidden name, and renamed once all of them
 *  are written and on the disk; until then, and when anything fails, nothing appears
 *  and what was there before stays. When the process is killed amid the renames, the
 *  next run with outputs in the folder takes them back.
 *
 *  The standard output can be one of them: what is written to it is held in memory
 *  until all others are in their places.
 *
 *  \code
 *    pcl_cid::OutputFiles outputs({"scan.pcd"});
 *    outputs.announce("labels.pcd");
 *    outputs.write("labels.pcd", [&](std::ostream& stream) { ... });
 *    outputs.commit();
 *  \endcode */
class PCL_CID_IO_EXPORT OutputFiles {
public:
  /** \param[in] inputs files that must never be written over, under whatever name they
   *  have now
   *  \param[in] around outputs whose inputs must not be written over, either: those of
   *  a run that this one is a part of; null: none. They must outlive these. */
  explicit OutputFiles(const std::vector<std::string>& inputs,
                       const OutputFiles* around = nullptr);

  /** \brief Remove what was not committed. */
  ~OutputFiles();

  OutputFiles(const OutputFiles&) = delete;
  OutputFiles&
  operator=(const OutputFiles&) = delete;

  /** \brief Make sure, before long work, that this output can be written.
   *  \throws CIDException when it is an input (under whatever name) or another output,
   *  when its folder is missing or not writable, when something that is not a file has
   *  its name, or when what a run that was killed left in the folder cannot be taken
   *  back */
  void
  announce(const std::string& path);

  /** \brief Let the standard output be one of the outputs, named standard_output in
   *  write().
   *  \throws CIDException when it is announced twice */
  void
  announceStandardOutput();

  /** \brief The same for a folder in which outputs will be announced: it is made when
   *  it is missing, and removed again when nothing is committed.
   *  \throws CIDException when it cannot be made or written to, or is not a folder */
  void
  announceFolder(const std::string& path);

  /** \brief Let commit() remove a file that an earlier run left behind. An output of
   *  this run that has the same name is kept.
   *  \throws CIDException when it is an input */
  void
  announceRemoval(const std::string& path);

  /** \brief The files that were announced, links resolved: what one run writes can be
   *  told from what others do. Of a folder, those that were announced in it. */
  std::vector<std::string>
  files() const;

  /** \brief Write an output that was announced.
   *  \param[in] path as announced
   *  \param[in] writer writes to a stream in binary mode; its exceptions pass through
   *  \throws CIDException when the output was not announced, or could not be written in
   *  full */
  void
  write(const std::string& path, const std::function<void(std::ostream&)>& writer);

  /** \brief Where an output is until commit(), to read again what was written.
   *  \throws CIDException when it was not announced */
  std::string
  pathBeforeCommit(const std::string& path);

  /** \brief Put all outputs in place, then remove what was announced for removal.
   *  \throws CIDException when one of these fails; then no output stays, and every
   *  older file is back in its place, or the message says where it is. Only when all
   *  outputs are in place and a hidden file cannot be removed, they stay, and the
   *  message says that. */
  void
  commit();

  /** \brief Remove what was not committed, as the destructor does. It needs no memory:
   *  the want of it may be why. */
  void
  discard() noexcept;

private:
  struct Output {
    std::string path;    ///< as announced
    std::string target;  ///< the file that it names, links resolved
    std::string partial; ///< where it is written
  };

  struct Removal {
    std::string path;   ///< as announced, absolute
    std::string file;   ///< the file itself, even where that is a link
    std::string target; ///< the file that it names, links resolved
  };

  /** Files that are never written over, by all that tells them apart. */
  struct Inputs {
    std::unordered_map<std::string, std::string> by_file; ///< links resolved
    /** By device and number on it, of those that exist. */
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::string> by_number;

    void
    add(const std::string& path);

    /** \return the input that a name means, as it was given; null: none */
    const std::string*
    find(const std::string& path) const;
  };

  void
  sendToStandardOutput() const;

  void
  refuseInput(const std::string& path) const;

  bool
  isOutput(const std::string& target) const;

  RunFolder&
  enter(const std::string& path, const std::string& folder);

  void
  commitIn(const std::string& base);

  void
  leaveToNextRun(bool is_left) noexcept;

  std::vector<Change>
  changes();

  Output&
  find(const std::string& path);

  Inputs inputs_;
  const OutputFiles* around_;
  std::vector<Output> outputs_;
  std::vector<std::string> made_folders_;
  std::vector<Removal> removals_;
  std::optional<std::string> for_standard_output_; ///< none: it is not announced
  std::vector<std::unique_ptr<RunFolder>> folders_;
};

} // namespace pcl_cid
