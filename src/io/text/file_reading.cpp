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

#include <array>
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

char
lineEndOf(std::istream& stream)
{
  std::streambuf& bytes = *stream.rdbuf();
  constexpr auto end = std::char_traits<char>::eof();
  constexpr int longest = 1 << 16; // what has no line end until then has no header
  int byte = bytes.sgetc();
  for (int i = 0; i < longest && byte != end && byte != '\r' && byte != '\n'; ++i)
    byte = bytes.snextc();
  const bool begins_with_return = byte == '\r';
  while (byte == '\r')
    byte = bytes.snextc();
  stream.seekg(0);
  return begins_with_return && byte != '\n' ? '\r' : '\n';
}

void
passByteOrderMark(std::istream& stream)
{
  std::array<char, 3> mark{};
  stream.read(mark.data(), mark.size());
  if (stream && mark == std::array<char, 3>{'\xEF', '\xBB', '\xBF'})
    return;
  stream.clear();
  stream.seekg(0);
}

bool
readHeaderLine(std::istream& stream,
               char line_end,
               const std::string& name,
               std::string& line)
{
  constexpr std::size_t longest = 1 << 20;
  std::streambuf& bytes = *stream.rdbuf();
  constexpr auto end = std::char_traits<char>::eof();
  line.clear();
  int byte = bytes.sbumpc();
  for (; byte != end && byte != line_end; byte = bytes.sbumpc()) {
    line += static_cast<char>(byte);
    if (line.size() > longest)
      throw CIDException(name + ": a line of its header has more than 1 MB");
  }
  return byte != end || !line.empty();
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
