/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The sentence of a message, from its parts.
 */

#pragma once

#include <sstream>
#include <string>

namespace pcl_cid {

/** \brief The parts as one text, numbers with six digits. */
template <typename... Parts>
std::string
sentence(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

} // namespace pcl_cid
