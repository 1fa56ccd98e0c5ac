/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files that appear whole or not at all, all of a run or none.
 */

#include <pcl_cid/io/output_files.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

/** Whether two names mean one file, also through links, hard links and "..". */
bool
areSame(const std::string& first, const std::string& second)
{
  std::error_code error;
  if (fs::equivalent(first, second, error))
    return true;
  return fs::weakly_canonical(first, error) == fs::weakly_canonical(second, error);
}

/** The file or folder that a name means, links and ".." resolved. */
fs::path
resolved(const std::string& path)
{
  fs::path target = fs::weakly_canonical(fs::absolute(path));
  // "folder/" means the folder.
  return target.has_filename() ? target : target.parent_path();
}

void
requireFolder(const std::string& path)
{
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    throw CIDException(path + ": the folder " + folder.string() +
                       " does not exist; create it first");
}

void
requireFileOrNothing(const std::string& path)
{
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))
    throw CIDException(path +
                       ": exists and is not a regular file; choose another name");
}

/** Make something beside a file, under a name that nothing has yet.
 *  \param[in] purpose part of the name
 *  \param[in] make called with names; returns 0 or what kept it from being made, EEXIST
 *  for the next name */
template <typename Make>
std::string
makeBeside(const std::string& path,
           const fs::path& file,
           const std::string& purpose,
           Make make)
{
  for (int attempt = 0;; ++attempt) {
    const fs::path beside =
        file.parent_path() / ("." + file.filename().string() + "." + purpose + "-" +
                              std::to_string(getpid()) + "-" + std::to_string(attempt));
    const int reason = make(beside.string());
    if (reason == 0)
      return beside.string();
    if (reason != EEXIST)
      throw CIDException(path + ": cannot be written: " + std::strerror(reason));
  }
}

/** \return 0 or the reason why not */
int
makeEmpty(const std::string& name)
{
  const int file = open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0)
    return errno;
  close(file);
  return 0;
}

/** Give a file a second name; where the file system has no hard links, rename it.
 *  \return 0 or the reason why not */
int
makeLink(const std::string& file, const std::string& name)
{
  if (link(file.c_str(), name.c_str()) == 0)
    return 0;
  if (errno == EEXIST)
    return EEXIST;
  const int reason = makeEmpty(name);
  if (reason != 0)
    return reason;
  return rename(file.c_str(), name.c_str()) == 0 ? 0 : errno;
}

/** Let what was written reach the disk: a file that is put in place before that may be
 *  empty after a power failure. */
void
synchronize(const std::string& path, const std::string& written)
{
  const int file = open(written.c_str(), O_RDONLY | O_CLOEXEC);
  int reason = file < 0 ? errno : EINTR;
  while (file >= 0 && reason == EINTR)
    reason = fsync(file) == 0 ? 0 : errno;
  if (file >= 0)
    close(file);
  const bool is_promised = reason != EINVAL && reason != ENOTSUP; // not everywhere
  if (reason != 0 && is_promised)
    throw CIDException(path +
                       ": could not be written in full: " + std::strerror(reason));
}

} // namespace

OutputFiles::OutputFiles(std::vector<std::string> inputs) : inputs_(std::move(inputs))
{
}

OutputFiles::~OutputFiles()
{
  std::error_code error;
  for (const Output& output : outputs_)
    fs::remove(output.partial, error);
  // Folders in folders first; and only when nobody has put anything into them.
  for (auto folder = made_folders_.rbegin(); folder != made_folders_.rend(); ++folder)
    fs::remove(*folder, error);
}

void
OutputFiles::announce(const std::string& path)
{
  refuseInput(path);
  requireFolder(path);
  requireFileOrNothing(path);
  const fs::path target = resolved(path);
  for (const Output& output : outputs_)
    if (target == output.target)
      throw CIDException(path + ": is written twice, the other time as " + output.path +
                         "; choose another name");
  outputs_.push_back(
      {path, target.string(), makeBeside(path, target, "partial", makeEmpty)});
}

void
OutputFiles::announceFolder(const std::string& path)
{
  std::error_code error;
  const fs::path folder = resolved(path);
  if (!fs::exists(folder, error)) {
    requireFolder(folder.string());
    if (!fs::create_directory(folder, error))
      throw CIDException(path + ": the folder cannot be made: " + error.message());
    made_folders_.push_back(folder.string());
  }
  if (!fs::is_directory(folder, error))
    throw CIDException(path + ": exists and is not a folder; choose another name");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw CIDException(path + ": cannot be written to: " + std::strerror(errno));
}

void
OutputFiles::announceRemoval(const std::string& path)
{
  refuseInput(path);
  removals_.push_back({fs::absolute(path).string(), resolved(path).string()});
}

void
OutputFiles::write(const std::string& path,
                   const std::function<void(std::ostream&)>& writer)
{
  const Output& output = find(path);
  std::ofstream stream(output.partial, std::ios::binary | std::ios::trunc);
  writer(stream);
  stream.close();
  if (!stream)
    throw CIDException(path +
                       ": could not be written in full: " + std::strerror(errno));
  synchronize(path, output.partial);
}

std::string
OutputFiles::pathBeforeCommit(const std::string& path)
{
  return find(path).partial;
}

void
OutputFiles::commit()
{
  try {
    for (const Output& output : outputs_) {
      keepOlder(output.path, output.target);
      std::error_code error;
      fs::rename(output.partial, output.target, error);
      if (error)
        throw CIDException(output.path +
                           ": cannot be put in place: " + error.message());
    }
    for (const Removal& removal : removals_)
      if (!isOutput(removal.target)) {
        keepOlder(removal.path, removal.path);
        std::error_code error;
        fs::remove(removal.path, error);
        if (error)
          throw CIDException(removal.path +
                             ": is of an earlier run and cannot be "
                             "removed: " +
                             error.message());
      }
  }
  catch (const CIDException& failure) {
    throw CIDException(failure.what() + takeBack());
  }
  catch (...) {
    takeBack();
    throw;
  }
  std::error_code ignored;
  for (const Change& change : changes_)
    fs::remove(change.older, ignored);
  changes_.clear();
  outputs_.clear();
  made_folders_.clear();
  removals_.clear();
}

/** Note that a file is about to change, and keep what is there until all outputs are in
 *  place. */
void
OutputFiles::keepOlder(const std::string& path, const std::string& file)
{
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file, error);
  if (status.type() == fs::file_type::none)
    throw CIDException(path + ": cannot be put in place: " + error.message());
  if (fs::is_directory(status))
    throw CIDException(path + ": is a folder, which is never replaced or removed");
  changes_.push_back({file, ""});
  if (fs::exists(status))
    changes_.back().older = makeBeside(
        path, file, "older", [&](const auto& name) { return makeLink(file, name); });
}

void
OutputFiles::refuseInput(const std::string& path) const
{
  for (const std::string& input : inputs_)
    if (areSame(path, input))
      throw CIDException(path + ": is the input " + input +
                         ", which is never written over; choose another name");
}

bool
OutputFiles::isOutput(const std::string& target) const
{
  return std::any_of(outputs_.begin(), outputs_.end(), [&](const Output& output) {
    return output.target == target;
  });
}

/** Undo all changes.
 *  \return what could not be undone, for the message */
std::string
OutputFiles::takeBack()
{
  std::string lost;
  for (const Change& change : changes_) {
    std::error_code error;
    if (change.older.empty())
      fs::remove(change.file, error);
    else
      fs::rename(change.older, change.file, error);
    // Two names of one file: then nothing has changed, and rename() has nothing to do.
    if (!error && !change.older.empty())
      fs::remove(change.older, error);
    if (error && !change.older.empty())
      lost += "; the older " + change.file + " is now " + change.older;
  }
  changes_.clear();
  return lost;
}

OutputFiles::Output&
OutputFiles::find(const std::string& path)
{
  for (Output& output : outputs_)
    if (output.path == path)
      return output;
  throw CIDException(path + ": was not announced as an output");
}

} // namespace pcl_cid
