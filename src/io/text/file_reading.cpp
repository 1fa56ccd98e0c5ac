/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files opened and read as a whole, with messages that name them.
 */

#include "file_reading.h"

#include <pcl_cid/exceptions.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace pcl_cid {

std::ifstream
openedForReading(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw CIDException(path + ": cannot be opened: " + std::strerror(errno));
  return stream;
}

std::uint64_t
sizeOfFile(const std::string& path)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error)
    throw CIDException(path + ": cannot be read: " + error.message());
  return size;
}

std::uint64_t
bytesLeft(std::istream& stream, std::uint64_t size)
{
  return stream.eof() ? 0 : size - static_cast<std::uint64_t>(stream.tellg());
}

std::string
textOf(const std::string& path)
{
  std::ifstream stream = openedForReading(path);
  std::string text(sizeOfFile(path), '\0');
  if (!stream.read(text.data(), static_cast<std::streamsize>(text.size())))
    throw CIDException(path + ": could not be read in full: " + std::strerror(errno));
  return text;
}

} // namespace pcl_cid
