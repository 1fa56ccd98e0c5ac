/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What writers of datasets wrote, read by Python and numpy.
 */

#include "python_reader.h"

#include <array>
#include <cstdio>

#include <gtest/gtest.h>

namespace pcl_cid::test {

nlohmann::json
readByPython(const std::vector<std::string>& arguments)
{
  // numpy is where Debian's own interpreter looks for it.
  std::string command = "/usr/bin/python3 '" PCL_CID_EXPORT_READER "'";
  for (const std::string& argument : arguments)
    command += " '" + argument + "'";
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), count);
  if (pclose(pipe) != 0) {
    ADD_FAILURE() << command << "\n" << output;
    return {};
  }
  return nlohmann::json::parse(output);
}

} // namespace pcl_cid::test
