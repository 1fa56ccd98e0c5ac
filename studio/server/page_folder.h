/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page from a folder, for who works on it.
 */

#pragma once

#include "resource.h"

#include <filesystem>

namespace pcl_cid::studio {

/** \brief The files of a folder, read each time they are asked for. `/` is index.html.
 *
 *  Nothing outside the folder is served, not by ".." and not by a symbolic link, and no
 *  hidden file. */
class PageFolder : public Resources {
public:
  /** \throws std::filesystem::filesystem_error where there is no such folder */
  explicit PageFolder(const std::filesystem::path& folder);

  std::optional<Resource>
  find(std::string_view path) const override;

private:
  std::filesystem::path folder_; ///< without links
};

} // namespace pcl_cid::studio
