/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * All readers of files, each with files that it reads: what is tried on them with bytes
 * that nobody would write.
 */

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_cid::test {

/** A reader. */
struct FuzzedReader {
  const char* name;
  /** Read a file that holds these bytes, and use what is read. Throws CIDException for
   *  what is no such file; anything else is a finding. */
  std::function<void(std::string_view bytes)> read;
  /** Files to begin with. */
  std::vector<std::string> corpus;
};

/** One row for each reader; a new one is one more row. */
const std::vector<FuzzedReader>&
fuzzedReaders();

} // namespace pcl_cid::test
