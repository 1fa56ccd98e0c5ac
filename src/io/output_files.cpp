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

/** Whether two names mean one file: through links, hard links, "..", too. */
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

/** An empty file beside the target, of a name that nothing has yet. */
std::string
makeBeside(const std::string& path, const fs::path& target)
{
  for (int attempt = 0;; ++attempt) {
    const fs::path beside = target.parent_path() /
                            ("." + target.filename().string() + ".partial-" +
                             std::to_string(getpid()) + "-" + std::to_string(attempt));
    const int file =
        open(beside.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      return beside.string();
    }
    if (errno != EEXIST)
      throw CIDException(path + ": cannot be written: " + std::strerror(errno));
  }
}

/** Let what was written reach the disk: a file that is put in place before that may be
 *  empty after a power failure. */
void
synchronize(const std::string& path, const std::string& written)
{
  const int file = open(written.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && fsync(file) == 0;
  const int reason = errno;
  if (file >= 0)
    close(file);
  if (!done)
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
  outputs_.push_back({path, target.string(), makeBeside(path, target)});
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
  std::vector<std::string> placed;
  try {
    for (const Output& output : outputs_) {
      setAside(output.path, output.target);
      std::error_code error;
      fs::rename(output.partial, output.target, error);
      if (error)
        throw CIDException(output.path + ": cannot be put in place: " + error.message());
      placed.push_back(output.target);
    }
    for (const Removal& removal : removals_)
      if (!isOutput(removal.target))
        setAside(removal.path, removal.path);
  }
  catch (...) {
    takeBack(placed);
    throw;
  }
  std::error_code ignored;
  for (const Aside& older : aside_)
    fs::remove(older.beside, ignored);
  aside_.clear();
  outputs_.clear();
  made_folders_.clear();
  removals_.clear();
}

/** Make room for an output, for as long as not all are in place. */
void
OutputFiles::setAside(const std::string& path, const std::string& file)
{
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file, error);
  if (!fs::exists(status))
    return;
  if (fs::is_directory(status))
    throw CIDException(path + ": is a folder, which is never replaced or removed");
  const std::string beside = makeBeside(path, file);
  fs::rename(file, beside, error);
  if (error) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw CIDException(path + ": is of an earlier run and cannot be replaced: " +
                       error.message());
  }
  aside_.push_back({file, beside});
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

void
OutputFiles::takeBack(const std::vector<std::string>& placed)
{
  std::error_code ignored;
  for (const std::string& file : placed)
    fs::remove(file, ignored);
  for (const Aside& older : aside_)
    fs::rename(older.beside, older.file, ignored);
  aside_.clear();
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
