/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hidden files of a run: their names, their bytes, their locks.
 */

#include "hidden_files.h"

#include <cerrno>
#include <filesystem>
#include <memory>
#include <new>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

/** \throws std::system_error for the last error, unless it was an interruption */
void
throwUnlessInterrupted()
{
  if (errno != EINTR)
    throw std::system_error(errno, std::generic_category());
}

} // namespace

bool
isHidden(const std::string& path)
{
  return fs::path(path).filename().string().rfind(hidden_prefix, 0) == 0;
}

OpenFile::OpenFile(const std::string& name, int flags)
: file_(open(name.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0666))
{
}

OpenFile::~OpenFile()
{
  if (file_ >= 0)
    close(file_);
}

bool
OpenFile::isOurs() const
{
  struct stat status = {};
  return fstat(file_, &status) == 0 && S_ISREG(status.st_mode) &&
         status.st_uid == geteuid();
}

int
OpenFile::lock() const
{
  return flock(file_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
}

bool
OpenFile::hasName(const std::string& name) const
{
  struct stat open = {};
  struct stat named = {};
  return fstat(file_, &open) == 0 && lstat(name.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

std::string
OpenFile::readAll() const
{
  std::string text;
  char buffer[4096];
  for (;;) {
    const ssize_t count = read(file_, buffer, sizeof(buffer));
    if (count == 0)
      return text;
    if (count > 0)
      text.append(buffer, static_cast<std::size_t>(count));
    else
      throwUnlessInterrupted();
  }
}

void
OpenFile::writeAll(const std::string& text) const
{
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(file_, text.data() + done, text.size() - done);
    if (count > 0)
      done += static_cast<std::size_t>(count);
    else
      throwUnlessInterrupted();
  }
}

bool
isThere(const std::string& name)
{
  struct stat status = {};
  return lstat(name.c_str(), &status) == 0;
}

std::vector<std::string>
filesIn(const std::string& folder)
{
  // std::filesystem's iterators terminate the process where memory lacks.
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(opendir(folder.c_str()), closedir);
  if (!entries && errno == ENOMEM)
    throw std::bad_alloc();
  std::vector<std::string> files;
  while (const dirent* const entry = entries ? readdir(entries.get()) : nullptr)
    files.push_back((fs::path(folder) / entry->d_name).string());
  return files;
}

int
synchronize(const std::string& name)
{
  const OpenFile file(name, O_RDONLY);
  int reason = file.get() < 0 ? errno : EINTR;
  while (file.get() >= 0 && reason == EINTR)
    reason = fsync(file.get()) == 0 ? 0 : errno;
  const bool is_promised = reason != EINVAL && reason != ENOTSUP; // not everywhere
  return is_promised ? reason : 0;
}

} // namespace pcl_cid
