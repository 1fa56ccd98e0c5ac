/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pages have exported, and under what names.
 */

#include "exported_files.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>

namespace pcl_cid::studio {

void
requireFileName(const std::string& name)
{
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 127; };
  if (name.find('/') != std::string::npos || name.front() == '.' ||
      std::any_of(name.begin(), name.end(), is_control))
    throw CIDException("the name '" + std::string(name.c_str()) +
                       "' must be that of a file, without folders, control characters "
                       "and a dot before it");
}

} // namespace pcl_cid::studio
