/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A session on the disk: what was done, action by action.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/label_session.h>
#include <pcl_cid/core/part_session.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Which scan a session is of, as far as it shows in its points. */
struct ScanIdentity {
  std::string name; ///< of the file, without its folder; another one is no other scan
  std::size_t points = 0;
  /** CRC-64 of the coordinates, in double, in their order; all that are not finite are
   *  alike. */
  std::uint64_t checksum = 0;
};

/** \brief The identity of a cloud.
 *  \throws CIDException when x, y or z is missing or has several values */
PCL_CID_IO_EXPORT ScanIdentity
identityOf(const LabelledCloud& cloud);

/** \brief What labels depend on besides the scan and the actions. */
struct SessionSettings {
  /** Those with a row in the table of settings, and `start_index`; a session works on
   *  all points, so there is no subsample. */
  PreparationSettings preparation;
  GroupingSettings grouping;
  bool keep_zeros = false; ///< see PointOptions
  /** Where the labels are from that it began with, a field or a file; empty for none.
   *  They are among the actions; this is to tell one import from another. */
  std::string imported;
};

/** \brief What a session file holds. */
struct SessionRecord {
  ScanIdentity scan;
  SessionSettings settings;
  std::vector<LabelAction> actions;
  std::vector<std::size_t> lines; ///< where each of these is in the file, from 1
  std::vector<PartAction> part_actions;
  std::vector<std::size_t> part_lines;

  /** \brief Of the file, as far as it was written to its end. */
  std::size_t
  lastLine() const
  {
    return 1 + actions.size() + part_actions.size();
  }
};

/** \brief Read a session, to look at it.
 *  \return without a last line that was not written to its end
 *  \throws CIDException with file and line, when it cannot be read or is not a session
 */
PCL_CID_IO_EXPORT SessionRecord
readSession(const std::string& path);

/** \brief The same, or nothing where SessionFile would begin a new one: there is no
 * file, or nothing in it. */
PCL_CID_IO_EXPORT std::optional<SessionRecord>
findSession(const std::string& path);

/** \brief Refuse a scan that a session is not of.
 *  \param[in] path of the session, for the message
 *  \throws CIDException that says what differs */
PCL_CID_IO_EXPORT void
requireScanOf(const SessionRecord& record,
              const ScanIdentity& scan,
              const std::string& path);

/** \brief Do what a record says about labels.
 *  \param[in,out] session of the scan and settings of the record, with nothing done
 *  \param[in] path of the record, for messages
 *  \return how many actions were done: all, or all but the last line of the file, which
 *  may have been written down and then not been possible
 *  \throws CIDException when another one is not possible, CIDCancelled */
PCL_CID_IO_EXPORT std::size_t
replaySession(const SessionRecord& record,
              const std::string& path,
              LabelSession& session,
              const ExecutionOptions& execution = {});

/** \brief The same for what it says about parts.
 *  \throws CIDException when an action is not possible, CIDCancelled */
PCL_CID_IO_EXPORT void
replayParts(const SessionRecord& record,
            const std::string& path,
            PartSession& parts,
            const ExecutionOptions& execution = {});

/** \brief A session file that is written: JSON lines, the first about scan and
 *  settings, each other an action, on the disk before append() returns.
 *
 *  It is locked as long as this lives, so that no two programs write to it. What was
 *  not written to its end, by a kill or a power failure, is cut off when it is opened
 *  again.
 *  \code
 *    {"format": "pcl_cid session", "version": 1, "scan": {...}, "settings": {...}}
 *    {"do": "propose", "seeds": 50}
 *    {"do": "label", "seed": 812, "new": {"class": "chair"}}
 *    {"do": "click", "points": [1234], "label": 1}
 *    {"do": "undo"}
 *    {"do": "decompose", "groups": 100}
 *  \endcode */
class PCL_CID_IO_EXPORT SessionFile {
public:
  /** \brief Open a session, or begin one where there is no file, or an empty one.
   *  \param[in] scan what it must be of
   *  \param[in] settings of a new one; one that is there has its own
   *  \param[in] anew begin a new one whatever is there
   *  \throws CIDException when it cannot be read or written, another program has it
   *  open, it is not a session, or one of another scan */
  SessionFile(std::string path,
              const ScanIdentity& scan,
              const SessionSettings& settings,
              bool anew = false);
  ~SessionFile();
  SessionFile(const SessionFile&) = delete;
  SessionFile&
  operator=(const SessionFile&) = delete;

  const std::string&
  path() const
  {
    return path_;
  }

  /** \brief What it held when it was opened. */
  const SessionRecord&
  record() const
  {
    return record_;
  }

  /** \brief Write an action, and wait until it is on the disk.
   *  \throws CIDException when it cannot be, as on a full disk: then it is not there */
  void
  append(const LabelAction& action);
  void
  append(const PartAction& action);

  /** \brief Take the last action out again, once: it was not possible. For actions
   *  that the file was opened with, too.
   *  \throws CIDException when the file cannot be changed */
  void
  dropLast();

  /** \brief Give the file another name, in the same folder; what had it is gone.
   *  \throws CIDException when the file cannot be renamed */
  void
  moveTo(const std::string& path);

private:
  class File;

  void
  begin(const ScanIdentity& scan, const SessionSettings& settings);

  void
  write(const std::string& line);

  std::string path_;
  std::unique_ptr<File> file_;
  SessionRecord record_;
  std::size_t end_ = 0;         ///< bytes of the file that are whole lines
  std::size_t before_last_ = 0; ///< bytes before the last of them
};

/** \brief The action on parts in a line of a session file, which is how a page of
 *  pcl_cid_studio says it, too: `{"do": "cut", "parts": 30}`.
 *
 *  \return nothing where the line is about something else
 *
 *  \throws CIDException when it is no JSON, or an action that is not whole */
PCL_CID_IO_EXPORT std::optional<PartAction>
partActionIn(const std::string& line);

/** \brief What an action is called in a session file: `click`. */
PCL_CID_IO_EXPORT const char*
wordOf(const LabelAction& action);

} // namespace pcl_cid
