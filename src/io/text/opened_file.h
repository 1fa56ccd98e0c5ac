/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A file open for reading, unpacked where gzip packed it.
 */

#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>

namespace pcl_cid {

/** \brief A file open for reading. */
struct OpenedFile {
  std::string name;                     ///< the path, without what gzip adds to it
  std::shared_ptr<std::istream> stream; ///< seekable, at its beginning
  std::uint64_t size = 0;               ///< bytes in it
};

/** \brief The name of the standard input, or output. */
constexpr const char* standard_stream = "-";

/** \brief What names of files packed by gzip end in. */
constexpr const char* gzip_extension = ".gz";

/** \brief The path without gzip_extension. */
std::string
withoutGzip(const std::string& path);

/** \brief Whether gzip packed a file, as its first bytes tell; not when there is none.
 */
bool
isPackedFile(const std::string& path);

/** \brief Open a file. One that gzip packed, as its first bytes tell, is unpacked into
 *  memory, and so is the standard input, whose name is standard_stream.
 *  \param[in] needed what the caller needs, for messages: "a PCD file is needed"
 *  \throws CIDException when it does not exist, is a folder, cannot be opened or
 *  unpacked, or is empty */
OpenedFile
openFile(const std::string& path, const std::string& needed);

} // namespace pcl_cid
