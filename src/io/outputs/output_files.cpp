/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files that appear whole or not at all, all of a run or none.
 */

#include <pcl_cid/io/output_files.h>

#include "commit_record.h"
#include "dead_runs.h"
#include "run_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

/** What a link names, be it nothing yet; other names mean themselves.
 *  \throws fs::filesystem_error */
fs::path
followed(fs::path path)
{
  constexpr int most_links = 40; // as the system follows
  for (int links = 0; fs::is_symlink(fs::symlink_status(path)); ++links) {
    if (links == most_links)
      throw fs::filesystem_error(
          "", std::make_error_code(std::errc::too_many_symbolic_link_levels));
    path = path.parent_path() / fs::read_symlink(path);
  }
  return path;
}

/** The file or folder that a name means, links and ".." resolved.
 *  \throws CIDException when nobody can say */
fs::path
resolved(const std::string& path)
{
  try {
    fs::path name = fs::absolute(path);
    // "folder/" means the folder.
    if (!name.has_filename())
      name = name.parent_path();
    return fs::weakly_canonical(followed(name));
  }
  catch (const fs::filesystem_error& error) {
    throw CIDException(path + ": cannot be written: " + error.code().message());
  }
}

void
requireFolder(const std::string& path, const fs::path& folder)
{
  std::error_code error;
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

/** The file that a name means, links resolved; empty when nobody can say. */
std::string
fileOf(const std::string& path)
{
  std::error_code error;
  return fs::weakly_canonical(path, error).string();
}

/** Device and number on it, of a file that exists. */
std::optional<std::pair<std::uint64_t, std::uint64_t>>
numberOf(const std::string& path)
{
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0)
    return std::nullopt;
  return std::pair<std::uint64_t, std::uint64_t>(status.st_dev, status.st_ino);
}

} // namespace

OutputFiles::OutputFiles(const std::vector<std::string>& inputs,
                         const OutputFiles* around)
: around_(around)
{
  for (const std::string& input : inputs)
    inputs_.add(input);
}

OutputFiles::~OutputFiles()
{
  discard();
}

void
OutputFiles::discard() noexcept
{
  for (const Output& output : outputs_)
    unlink(output.partial.c_str());
  outputs_.clear();
  folders_.clear();
  // Folders in folders first; and only when nobody has put anything into them.
  for (auto folder = made_folders_.rbegin(); folder != made_folders_.rend(); ++folder)
    rmdir(folder->c_str());
  made_folders_.clear();
  removals_.clear();
  for_standard_output_.reset();
}

void
OutputFiles::announce(const std::string& path)
{
  refuseInput(path);
  requireFolder(path, fs::path(path).parent_path());
  requireFileOrNothing(path);
  const fs::path target = resolved(path);
  requireFolder(path, target.parent_path());
  for (const Output& output : outputs_)
    if (target == output.target)
      throw CIDException(path + ": is written twice, the other time as " + output.path +
                         "; choose another name");
  RunFolder& folder = enter(path, target.parent_path().string());
  outputs_.push_back({path, target.string(), folder.newName("partial")});
  const OpenFile partial(outputs_.back().partial, O_CREAT | O_EXCL | O_WRONLY);
  if (partial.get() < 0) {
    const int reason = errno;
    outputs_.pop_back();
    throw CIDException(path + ": cannot be written: " + std::strerror(reason));
  }
}

void
OutputFiles::announceStandardOutput()
{
  if (for_standard_output_)
    throw CIDException("the standard output is announced twice");
  for_standard_output_.emplace();
}

void
OutputFiles::announceFolder(const std::string& path)
{
  std::error_code error;
  const std::string folder = resolved(path).string();
  if (!fs::exists(folder, error)) {
    requireFolder(folder, fs::path(folder).parent_path());
    made_folders_.push_back(folder);
    if (!fs::create_directory(folder, error)) {
      made_folders_.pop_back();
      throw CIDException(path + ": the folder cannot be made: " + error.message());
    }
  }
  if (!fs::is_directory(folder, error))
    throw CIDException(path + ": exists and is not a folder; choose another name");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw CIDException(path + ": cannot be written to: " + std::strerror(errno));
  enter(path, folder);
}

void
OutputFiles::announceRemoval(const std::string& path)
{
  refuseInput(path);
  const fs::path name = fs::absolute(path);
  const std::string folder = resolved(name.parent_path().string()).string();
  enter(path, folder);
  removals_.push_back({name.string(),
                       (fs::path(folder) / name.filename()).string(),
                       resolved(path).string()});
}

std::vector<std::string>
OutputFiles::files() const
{
  std::vector<std::string> files;
  for (const Output& output : outputs_)
    files.push_back(output.target);
  return files;
}

void
OutputFiles::write(const std::string& path,
                   const std::function<void(std::ostream&)>& writer)
{
  if (path == standard_output && for_standard_output_) {
    std::ostringstream stream;
    writer(stream);
    for_standard_output_ = std::move(stream).str();
    return;
  }
  const Output& output = find(path);
  std::ofstream stream(output.partial, std::ios::binary | std::ios::trunc);
  writer(stream);
  stream.close();
  if (!stream)
    throw CIDException(path +
                       ": could not be written in full: " + std::strerror(errno));
  if (const int reason = synchronize(output.partial))
    throw CIDException(path +
                       ": could not be written in full: " + std::strerror(reason));
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
    if (!folders_.empty())
      commitIn(folders_.front()->base());
    if (for_standard_output_)
      sendToStandardOutput();
  }
  catch (...) {
    discard();
    throw;
  }
  discard(); // the locks alone
}

void
OutputFiles::sendToStandardOutput() const
{
  const std::string& bytes = *for_standard_output_;
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() ||
      std::fflush(stdout) != 0)
    throw CIDException(
        std::string("the standard output could not be written in full: ") +
        std::strerror(errno));
}

/** \param[in] base in the first folder: there the record will be */
void
OutputFiles::commitIn(const std::string& base)
{
  Commit commit(base, changes());
  leaveToNextRun(true); // should the process end amid the commit
  try {
    commit.make();
    outputs_.clear();
    made_folders_.clear();
    commit.finish();
  }
  catch (...) {
    leaveToNextRun(!commit.isOver());
    throw;
  }
  leaveToNextRun(false);
}

void
OutputFiles::leaveToNextRun(bool is_left) noexcept
{
  for (const auto& folder : folders_)
    folder->leaveToNextRun(is_left);
}

/** What commit() does: outputs take their places, then what is announced for removal
 *  goes. */
std::vector<Change>
OutputFiles::changes()
{
  std::vector<Change> all;
  const auto add = [&](const std::string& path,
                       const std::string& file,
                       const std::string& partial) {
    const std::string folder = fs::path(file).parent_path().string();
    all.push_back({path, file, partial, enter(path, folder).newName("older"), {}});
  };
  for (const Output& output : outputs_)
    add(output.path, output.target, output.partial);
  for (const Removal& removal : removals_)
    if (!isOutput(removal.target))
      add(removal.path, removal.file, "");
  return all;
}

void
OutputFiles::Inputs::add(const std::string& path)
{
  if (const std::string file = fileOf(path); !file.empty())
    by_file.emplace(file, path);
  if (const auto number = numberOf(path))
    by_number.emplace(*number, path);
}

/** Two names may mean one file also through links, hard links and "..". */
const std::string*
OutputFiles::Inputs::find(const std::string& path) const
{
  if (const auto same = by_file.find(fileOf(path)); same != by_file.end())
    return &same->second;
  const auto number = numberOf(path);
  const auto same = number ? by_number.find(*number) : by_number.end();
  return same != by_number.end() ? &same->second : nullptr;
}

void
OutputFiles::refuseInput(const std::string& path) const
{
  for (const OutputFiles* run = this; run; run = run->around_)
    if (const std::string* const input = run->inputs_.find(path))
      throw CIDException(path + ": is the input " + *input +
                         ", which is never written over; choose another name");
}

bool
OutputFiles::isOutput(const std::string& target) const
{
  return std::any_of(outputs_.begin(), outputs_.end(), [&](const Output& output) {
    return output.target == target;
  });
}

/** Of a folder in which this run has outputs, that of the run; the first time, what
 *  dead runs left in it is seen to. */
RunFolder&
OutputFiles::enter(const std::string& path, const std::string& folder)
{
  for (const auto& known : folders_)
    if (known->folder() == folder)
      return *known;
  try {
    endDeadRuns(folder);
    folders_.push_back(std::make_unique<RunFolder>(
        folder, folders_.empty() ? nullptr : folders_.front().get()));
  }
  catch (const std::system_error& error) {
    throw CIDException(path + ": cannot be written: " + error.code().message());
  }
  return *folders_.back();
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
