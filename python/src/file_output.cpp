/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files that appear whole or not at all.
 */

#include "file_output.h"

#include "gil.h"

#include <pcl_cid/io/output_files.h>

namespace pcl_cid::python {

std::string
pathOf(const py::object& path)
{
  // Names of files need not be Unicode.
  const py::bytes bytes = py::module_::import("os").attr("fsencode")(path);
  std::string text = bytes;
  if (text.find('\0') != std::string::npos)
    refuse("the path is ", shown(path), "; it must not hold the character 0");
  return text;
}

void
writeFile(const std::string& path,
          const std::function<void(std::ostream&)>& writer,
          const std::string& beside,
          const std::function<void(std::ostream&)>& beside_writer)
{
  const GilReleased released;
  OutputFiles outputs({});
  outputs.announce(path);
  if (!beside.empty())
    outputs.announce(beside);
  outputs.write(path, writer);
  if (!beside.empty())
    outputs.write(beside, beside_writer);
  outputs.commit();
}

} // namespace pcl_cid::python
