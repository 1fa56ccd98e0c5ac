/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A thing in a scan, and what it is called.
 */

#pragma once

#include <cstdint>
#include <string>

namespace pcl_cid {

/** \brief A thing in a scan. */
struct NamedInstance {
  /** Of its points; above 0. */
  std::uint32_t label = 0;
  /** What it is, such as `chair`; any text, empty for no class. */
  std::string class_name;
  /** What a person calls it, such as `the broken one`; may be empty. */
  std::string name;

  bool
  operator==(const NamedInstance& other) const
  {
    return label == other.label && class_name == other.class_name && name == other.name;
  }
};

} // namespace pcl_cid
