/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a file format of clouds is: one row of the table in cloud_formats.h.
 */

#pragma once

#include <pcl_cid/core/execution.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace pcl_cid {

struct LabelledCloud;

/** \brief Called with one sentence for each thing that a user should know, though it is
 *  no error; may be empty where it is not said otherwise. */
using RemarkCallback = std::function<void(const std::string&)>;

/** \brief How the values of a cloud are written down. */
enum class CloudEncoding { ascii, binary, compressed };

/** \brief How a cloud is laid out in a file: in which format, and how that writes its
 *  values down. */
struct CloudLayout {
  /** Name of a CloudFormat. */
  std::string format = "PCD";
  /** One of those that the format has. */
  CloudEncoding encoding = CloudEncoding::compressed;
};

inline bool
operator==(const CloudLayout& a, const CloudLayout& b)
{
  return a.format == b.format && a.encoding == b.encoding;
}

inline bool
operator!=(const CloudLayout& a, const CloudLayout& b)
{
  return !(a == b);
}

/** \brief The points of a file that is read block by block, as often as need be. */
class CloudRows {
public:
  virtual ~CloudRows() = default;

  /** \brief Go to the first point. */
  virtual void
  begin() = 0;

  /** \brief Read the next points; there are so many.
   *  \param[out] points as in LabelledCloud::fields
   *  \throws CIDException that names the file and says what is wrong with it */
  virtual void
  read(std::size_t count, std::uint8_t* points) = 0;

  /** \brief After the last point: refuse what must not follow it.
   *  \throws CIDException */
  virtual void
  end() = 0;
};

/** \brief How a file is written block by block: the head, the points of each block, the
 *  tail. The bytes are those of CloudFormat::write. */
struct CloudPieces {
  /** Writes a piece. Head and tail get a cloud whose data are not all there, rows one
   *  with some of its points. */
  using Write = std::function<void(
      std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)>;

  /** The encodings that can be written like this; none: the format cannot. */
  std::vector<CloudEncoding> encodings;
  Write head;
  Write rows;
  Write tail; ///< empty: there is none
};

/** \brief A file format of clouds. */
struct CloudFormat {
  /** What users call it: "PCD". */
  std::string name;
  /** How names of its files end: in small letters, with the dot. */
  std::vector<std::string> extensions;
  /** Whether every file with these extensions is a scan. Others, such as tables, are
   *  read where they are named, and passed over where scans are looked for in a
   *  folder. */
  bool is_of_scans_only = true;
  /** The encodings that it can be written in. A cloud from a file of another format is
   *  written in the last of them, or in ascii where it was ascii and that is one of
   *  them. */
  std::vector<CloudEncoding> encodings;
  /** Whether a file is of this format, by its content; empty for a format without a
   *  mark of its own, where the file's extension decides.
   *  \param[in] stream at the beginning of the file; it may be left anywhere */
  std::function<bool(std::istream& stream)> recognizes;
  /** Read a file; empty for a format that is only written.
   *  \param[in] stream at the beginning of the file
   *  \param[in] size of the file in bytes, at least 1
   *  \param[in,out] cloud has its name; fields, layout and pose are to be filled in
   *  \throws CIDException that names the file and says what is wrong with it */
  std::function<void(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)>
      read;
  /** Which of its files can be read block by block: "a PCD that is not compressed";
   *  empty: none. */
  std::string streams = {};
  /** Begin to read a file block by block; empty for a format that cannot.
   *  \param[in] stream at the beginning of the file; it outlives the result
   *  \param[in] size of the file in bytes, at least 1
   *  \param[in,out] head as in \a read, but its data stay empty; it outlives the result
   *  \param[in] progress told of what must be read of the file before; may be empty
   *  \return null for a file that cannot be read like this
   *  \throws CIDException as \a read; CIDCancelled */
  std::function<std::unique_ptr<CloudRows>(std::istream& stream,
                                           std::uint64_t size,
                                           LabelledCloud& head,
                                           const ProgressCallback& progress)>
      stream = {};
  /** Refuse a cloud that the format cannot hold; empty for one that holds all. Called
   *  before the work, and before \a write.
   *  \param[in] remark called with one sentence for each thing that is written in
   *  another way than it is in the cloud
   *  \throws CIDException for a cloud that cannot be written */
  std::function<void(const LabelledCloud& cloud, const RemarkCallback& remark)> check;
  /** Write a file; empty for a format that is only read.
   *  \param[in] encoding one of those above */
  std::function<void(
      std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)>
      write;
  /** How it is written block by block, where it can be. */
  CloudPieces pieces = {};
};

} // namespace pcl_cid
