/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A folder in which a run has outputs.
 */

#include "run_folder.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace pcl_cid {

namespace fs = std::filesystem;

RunFolder::RunFolder(const std::string& folder, const RunFolder* first)
: folder_(folder)
{
  lockNewBase();
  const std::string& first_base = first != nullptr ? first->base() : base_;
  try {
    lock_->writeAll(fs::path(first_base).lexically_relative(folder).string() + '\n');
  }
  catch (...) {
    unlink(lock_name_.c_str());
    throw;
  }
}

RunFolder::~RunFolder()
{
  if (!is_left_)
    unlink(lock_name_.c_str());
}

void
RunFolder::lockNewBase()
{
  const std::string stem = (fs::path(folder_) / hidden_prefix).string();
  for (int attempt = 0;; ++attempt) {
    base_ = stem + std::to_string(getpid()) + "-" + std::to_string(attempt);
    lock_name_ = base_ + ".run";
    lock_ = std::make_unique<OpenFile>(lock_name_, O_CREAT | O_EXCL | O_RDWR);
    if (lock_->get() < 0 && errno != EEXIST)
      throw std::system_error(errno, std::generic_category());
    // Before the lock, another run may take this one for dead. Where the file system
    // has no locks, nobody can.
    if (lock_->get() >= 0 && lock_->lock() != EWOULDBLOCK && lock_->hasName(lock_name_))
      return;
  }
}

std::string
RunFolder::newName(const std::string& purpose)
{
  std::string name;
  do
    name = base_ + "-" + std::to_string(++names_) + "." + purpose;
  while (isThere(name));
  return name;
}

} // namespace pcl_cid
