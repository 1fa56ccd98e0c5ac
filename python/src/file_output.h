/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files that appear whole or not at all.
 */

#pragma once

#include "errors.h"

#include <functional>
#include <iosfwd>
#include <string>

namespace pcl_cid::python {

/** \brief A path of str, bytes or os.PathLike.
 *  \throws TypeError as os.fspath() does */
std::string
pathOf(const py::object& path);

/** \brief Write a file, without the GIL, and another one beside it where that has a
 *  name.
 *  \throws CIDException */
void
writeFile(const std::string& path,
          const std::function<void(std::ostream&)>& writer,
          const std::string& beside = "",
          const std::function<void(std::ostream&)>& beside_writer = {});

} // namespace pcl_cid::python
