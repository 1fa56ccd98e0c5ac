/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The changes of a commit, and the record by which they are all made or none.
 */

#include "commit_record.h"

#include "hidden_files.h"

#include <pcl_cid/exceptions.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

constexpr const char* record_head = "pcl_cid commit 1";
constexpr const char* record_end = "end";

void
requireDone(const std::string& path, const char* what_failed, int reason)
{
  if (reason != 0)
    throw CIDException(path + ": " + what_failed + ": " + std::strerror(reason));
}

/** \return 0, also when there is nothing of that name, or the reason why not */
int
removeFile(const std::string& name)
{
  return unlink(name.c_str()) == 0 || errno == ENOENT ? 0 : errno;
}

int
moveFile(const std::string& from, const std::string& to)
{
  return rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

bool
isFolder(const std::string& name)
{
  struct stat status = {};
  return lstat(name.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

Change::Mark
markOf(const struct stat& status)
{
  return {status.st_ino, status.st_size, status.st_mtim};
}

/** Whether a file is the one that was the partial file of a change. */
bool
isPlaced(const Change& change)
{
  struct stat status = {};
  if (change.partial.empty() || lstat(change.file.c_str(), &status) != 0)
    return false;
  const Change::Mark mark = markOf(status);
  return mark.inode == change.mark.inode && mark.size == change.mark.size &&
         mark.written.tv_sec == change.mark.written.tv_sec &&
         mark.written.tv_nsec == change.mark.written.tv_nsec;
}

/** Give what is there a second name; where the file system has no hard links, another
 *  one.
 *  \return 0, also when nothing is there, or the reason why not */
int
keepOlder(const Change& change)
{
  if (link(change.file.c_str(), change.older.c_str()) == 0 || errno == ENOENT)
    return 0;
  if (errno == EEXIST)
    return errno;
  if (isFolder(change.file))
    return EISDIR;
  const int reason = moveFile(change.file, change.older);
  return reason == ENOENT ? 0 : reason;
}

void
make(const Change& change)
{
  requireDone(change.path, "cannot be put in place", keepOlder(change));
  if (change.partial.empty())
    requireDone(change.path,
                "is of an earlier run and cannot be removed",
                removeFile(change.file));
  else
    requireDone(
        change.path, "cannot be put in place", moveFile(change.partial, change.file));
}

/** Undo a change, made or not; this may be done again. It needs no memory.
 *  \return whether that was possible */
bool
takeBackChange(const Change& change) noexcept
{
  const bool was_kept = isThere(change.older);
  const bool is_placed = isPlaced(change);
  if (was_kept && (is_placed || !isThere(change.file)))
    return moveFile(change.older, change.file) == 0;
  if (was_kept) // the same file, or one that somebody else has put there since
    return removeFile(change.older) == 0;
  return !is_placed || removeFile(change.file) == 0;
}

/** \return the first change that could not be undone, or nullptr */
const Change*
takeBackAll(const std::vector<Change>& changes) noexcept
{
  const Change* lost = nullptr;
  for (const Change& change : changes)
    if (!takeBackChange(change) && lost == nullptr)
      lost = &change;
  return lost;
}

/** Remove what was there before.
 *  \throws CIDException for the first that cannot be removed */
void
removeOlder(const std::vector<Change>& changes)
{
  const Change* lost = nullptr;
  int reason = 0;
  for (const Change& change : changes)
    if (const int error = removeFile(change.older); error != 0 && lost == nullptr) {
      lost = &change;
      reason = error;
    }
  if (lost != nullptr)
    throw CIDException(lost->path +
                       ": all outputs are in place, but what was there "
                       "before cannot be removed from " +
                       lost->older + ": " + std::strerror(reason));
}

/** What a record holds: names as seen from its folder, so that it may move with its
 *  files. */
std::string
textOf(const std::vector<Change>& changes, const fs::path& folder)
{
  std::string text = std::string(record_head) + '\0';
  for (const Change& change : changes) {
    for (const std::string& name : {change.file, change.partial, change.older})
      text += fs::path(name).lexically_relative(folder).string() + '\0';
    const Change::Mark& mark = change.mark;
    text += std::to_string(mark.inode) + ' ' + std::to_string(mark.size) + ' ' +
            std::to_string(mark.written.tv_sec) + ' ' +
            std::to_string(mark.written.tv_nsec) + '\0';
  }
  return text + record_end + '\0';
}

Change::Mark
markIn(const std::string& text)
{
  Change::Mark mark;
  std::istringstream stream(text);
  stream >> mark.inode >> mark.size >> mark.written.tv_sec >> mark.written.tv_nsec;
  return mark;
}

/** Whether the names are such as a run writes: only then they are touched. */
bool
isSound(const Change& change)
{
  const fs::path folder = fs::path(change.file).parent_path();
  for (const std::string& name : {change.partial, change.older})
    if (!name.empty() && (!isHidden(name) || fs::path(name).parent_path() != folder))
      return false;
  return !change.older.empty();
}

std::vector<std::string>
fieldsIn(const std::string& text)
{
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\0', begin);
    fields.push_back(text.substr(begin, end - begin));
    begin = end == std::string::npos ? text.size() : end + 1;
  }
  return fields;
}

/** \throws CIDException when it is none */
std::vector<Change>
changesIn(const std::string& record)
{
  const OpenFile file(record, O_RDONLY);
  const std::vector<std::string> fields = fieldsIn(file.readAll());
  const fs::path folder = fs::path(record).parent_path();
  std::vector<Change> changes;
  bool is_sound = file.isOurs() && fields.size() % 4 == 2 &&
                  fields.front() == record_head && fields.back() == record_end;
  for (std::size_t k = 1; is_sound && k + 4 < fields.size(); k += 4) {
    const auto name = [&](const std::string& field) {
      return field.empty() ? field : (folder / field).lexically_normal().string();
    };
    Change change;
    change.file = change.path = name(fields[k]);
    change.partial = name(fields[k + 1]);
    change.older = name(fields[k + 2]);
    change.mark = markIn(fields[k + 3]);
    is_sound = isSound(change);
    changes.push_back(std::move(change));
  }
  if (!is_sound)
    throw CIDException(record + ": is not the record of a run that was killed, as its "
                                "name says; remove it");
  return changes;
}

} // namespace

Commit::Commit(const std::string& base, std::vector<Change> changes)
: changes_(std::move(changes))
, begun_(base + ".begun")
, undo_(base + ".undo")
, done_(base + ".done")
{
  for (Change& change : changes_) {
    if (isFolder(change.file))
      throw CIDException(change.path +
                         ": is a folder, which is never replaced or removed");
    struct stat status = {};
    if (!change.partial.empty() && lstat(change.partial.c_str(), &status) != 0)
      requireDone(change.path, "cannot be put in place", errno);
    change.mark = markOf(status);
  }
}

void
Commit::make()
{
  try {
    makeAll();
  }
  catch (const CIDException& failure) {
    const std::string lost = takeBack();
    throw CIDException(failure.what() + lost);
  }
  catch (...) {
    takeBack();
    throw;
  }
}

void
Commit::makeAll()
{
  const std::string folder = fs::path(undo_).parent_path().string();
  const auto requireRecorded = [&](int reason) {
    requireDone(undo_, "could not be written in full", reason);
  };
  try {
    const OpenFile record(begun_, O_CREAT | O_EXCL | O_WRONLY);
    record.writeAll(textOf(changes_, folder));
  }
  catch (const std::system_error& error) {
    requireRecorded(error.code().value());
  }
  requireRecorded(synchronize(begun_));
  requireRecorded(moveFile(begun_, undo_));
  requireRecorded(synchronize(folder));
  for (const Change& change : changes_)
    pcl_cid::make(change);
  requireRecorded(moveFile(undo_, done_));
}

/** \return what could not be undone, for the message */
std::string
Commit::takeBack()
{
  const Change* const lost = takeBackAll(changes_);
  removeFile(begun_);
  if (lost == nullptr)
    removeFile(undo_);
  return lost == nullptr || !isThere(lost->older)
             ? ""
             : "; the older " + lost->path + " is now " + lost->older;
}

void
Commit::finish()
{
  removeOlder(changes_);
  requireDone(
      done_, "all outputs are in place, but it cannot be removed", removeFile(done_));
}

bool
Commit::isOver() const noexcept
{
  return !isThere(undo_) && !isThere(done_);
}

void
endCommit(const std::string& base)
{
  const std::string undo = base + ".undo";
  if (isThere(undo)) {
    const std::vector<Change> changes = changesIn(undo);
    if (const Change* const lost = takeBackAll(changes))
      throw CIDException(lost->file +
                         ": a run that was killed left it half done, and " +
                         lost->older + ", which was there before, cannot be put back");
    for (const Change& change : changes)
      removeFile(change.partial);
    removeFile(undo);
  }
  const std::string done = base + ".done";
  if (isThere(done)) {
    removeOlder(changesIn(done));
    removeFile(done);
  }
  removeFile(base + ".begun");
}

} // namespace pcl_cid
