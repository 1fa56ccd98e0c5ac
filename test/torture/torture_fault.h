/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Something that does not hold.
 */

#pragma once

#include <exception>
#include <string>
#include <utility>

namespace pcl_cid::test {

/** \brief Ends the checks of a case. */
struct Fault : std::exception {
  std::string text;

  explicit Fault(std::string what) : text(std::move(what)) {}
};

inline void
expect(bool holds, const std::string& what)
{
  if (!holds)
    throw Fault(what);
}

} // namespace pcl_cid::test
