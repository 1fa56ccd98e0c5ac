/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A file open for reading, unpacked where gzip packed it.
 */

#include "opened_file.h"
#include "path_names.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>
#include <unistd.h>
#include <zlib.h>

namespace pcl_cid {
namespace {

/** The bytes of a MemoryStream, which must be there before it. */
struct Bytes {
  std::string bytes;
};

/** Reads what it holds. */
class MemoryStream : private Bytes,
                     public boost::iostreams::stream<boost::iostreams::array_source> {
public:
  explicit MemoryStream(std::string text)
  : Bytes{std::move(text)}
  , boost::iostreams::stream<boost::iostreams::array_source>(bytes.data(), bytes.size())
  {
  }
};

struct CloseGzip {
  void
  operator()(gzFile file) const
  {
    gzclose(file);
  }
};

/** All that a packed file holds: several parts, one after the other, too. What is not
 *  packed comes as it is. */
std::string
unpacked(const std::string& path)
{
  const std::unique_ptr<gzFile_s, CloseGzip> file(path == standard_stream
                                                      ? gzdopen(dup(STDIN_FILENO), "rb")
                                                      : gzopen(path.c_str(), "rb"));
  if (!file)
    throw CIDException(path + ": cannot be opened: " + std::strerror(errno));
  std::string text;
  constexpr unsigned int block = 1 << 20;
  int count = 0;
  do {
    const std::size_t before = text.size();
    text.resize(before + block);
    count = gzread(file.get(), text.data() + before, block);
    text.resize(before + static_cast<std::size_t>(std::max(count, 0)));
  } while (count > 0);
  int error = Z_OK;
  const char* const reason = gzerror(file.get(), &error);
  if (error != Z_OK && error != Z_STREAM_END)
    throw CIDException(path + ": is damaged: it cannot be unpacked (gzip: " + reason +
                       ")");
  return text;
}

bool
isPacked(std::istream& stream)
{
  const bool begins_as_gzip = stream.get() == 0x1F && stream.get() == 0x8B;
  stream.clear();
  stream.seekg(0);
  return begins_as_gzip;
}

/** \param[in] needed what the caller needs, for messages */
std::shared_ptr<std::istream>
openedOnDisk(const std::string& path, const std::string& needed)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(path, error))
    throw CIDException(path + ": there is no such file");
  if (fs::is_directory(path, error))
    throw CIDException(path + ": is a folder; " + needed);
  const auto stream = std::make_shared<std::ifstream>(path, std::ios::binary);
  if (!*stream)
    throw CIDException(path + ": cannot be opened: " + std::strerror(errno));
  if (isPacked(*stream))
    return std::make_shared<MemoryStream>(unpacked(path));
  return stream;
}

} // namespace

std::string
withoutGzip(const std::string& path)
{
  if (extensionOf(path) != gzip_extension)
    return path;
  return path.substr(0, path.size() - std::strlen(gzip_extension));
}

bool
isPackedFile(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) // what a pipe holds is read once
    return false;
  std::ifstream stream(path, std::ios::binary);
  return isPacked(stream);
}

OpenedFile
openFile(const std::string& path, const std::string& needed)
{
  OpenedFile file;
  file.name = withoutGzip(path);
  if (path == standard_stream)
    file.stream = std::make_shared<MemoryStream>(unpacked(path));
  else
    file.stream = openedOnDisk(path, needed);
  file.stream->seekg(0, std::ios::end);
  const std::streamoff end = file.stream->tellg();
  file.stream->seekg(0);
  if (!*file.stream || end < 0)
    throw CIDException(path + ": cannot be read like a file; " + needed);
  if (end == 0)
    throw CIDException(path + ": is empty; " + needed);
  file.size = static_cast<std::uint64_t>(end);
  return file;
}

} // namespace pcl_cid
