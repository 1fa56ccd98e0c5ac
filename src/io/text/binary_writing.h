/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Values written to a binary file.
 */

#pragma once

#include <ostream>

namespace pcl_cid {

/** \brief Write the bytes of a value, in the order of this machine: little-endian. */
template <typename Value>
void
writeValue(std::ostream& stream, Value value)
{
  stream.write(reinterpret_cast<const char*>(&value), sizeof(value));
}

} // namespace pcl_cid
