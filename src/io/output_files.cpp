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
makePartial(const std::string& path, const fs::path& target)
{
  for (int attempt = 0;; ++attempt) {
    const fs::path partial = target.parent_path() /
                             ("." + target.filename().string() + ".partial-" +
                              std::to_string(getpid()) + "-" + std::to_string(attempt));
    const int file =
        open(partial.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      return partial.string();
    }
    if (errno != EEXIST)
      throw CIDException(path + ": cannot be written: " + std::strerror(errno));
  }
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
  outputs_.push_back({path, target.string(), makePartial(path, target)});
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
}

std::string
OutputFiles::pathBeforeCommit(const std::string& path)
{
  return find(path).partial;
}

void
OutputFiles::commit()
{
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    std::error_code error;
    fs::rename(outputs_[i].partial, outputs_[i].target, error);
    if (error)
      takeBack(i, outputs_[i].path + ": cannot be put in place: " + error.message());
  }
  for (const Removal& removal : removals_) {
    std::error_code error;
    if (!isOutput(removal.target))
      fs::remove(removal.path, error);
    if (error)
      takeBack(outputs_.size(),
               removal.path +
                   ": is of an earlier run and cannot be removed: " + error.message());
  }
  outputs_.clear();
  made_folders_.clear();
  removals_.clear();
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
OutputFiles::takeBack(std::size_t placed, const std::string& reason)
{
  std::error_code ignored;
  for (std::size_t i = 0; i < placed; ++i)
    fs::remove(outputs_[i].target, ignored);
  throw CIDException(reason);
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
