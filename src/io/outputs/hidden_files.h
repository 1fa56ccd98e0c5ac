/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hidden files of a run: their names, their bytes, their locks.
 */

#pragma once

#include <string>
#include <vector>

namespace pcl_cid {

/** \brief What the names of all hidden files begin with. */
constexpr const char* hidden_prefix = ".pcl_cid-";

/** \brief Whether the file name in a path begins like that. */
bool
isHidden(const std::string& path);

/** \brief A file that is open. */
class OpenFile {
public:
  /** \param[in] flags as for open(); a negative get() says that it failed, and errno
   *  why */
  OpenFile(const std::string& name, int flags);

  ~OpenFile();

  OpenFile(const OpenFile&) = delete;
  OpenFile&
  operator=(const OpenFile&) = delete;

  int
  get() const
  {
    return file_;
  }

  /** \brief Whether it is a regular file of this user: what others leave is none of our
   *  business. */
  bool
  isOurs() const;

  /** \brief Lock it, unless somebody else has, for as long as it is open.
   *  \return 0 or the reason why not */
  int
  lock() const;

  /** \brief Whether it still is the file that has this name. */
  bool
  hasName(const std::string& name) const;

  /** \throws std::system_error */
  std::string
  readAll() const;

  /** \throws std::system_error */
  void
  writeAll(const std::string& text) const;

private:
  int file_;
};

/** \brief Whether something has this name, be it a link that leads nowhere. */
bool
isThere(const std::string& name);

/** \brief Paths of all in a folder; none where one may not look. */
std::vector<std::string>
filesIn(const std::string& folder);

/** \brief Let a file or a folder reach the disk: what is put in place before that may
 *  be empty after a power failure.
 *  \return 0 or the reason why not */
int
synchronize(const std::string& name);

} // namespace pcl_cid
