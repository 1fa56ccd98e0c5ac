/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Values read from a binary file, with messages that say where.
 */

#pragma once

#include "base/sentence.h"
#include "file_reading.h"

#include <pcl_cid/exceptions.h>

#include <fstream>
#include <string>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Reads values one after the other, and knows where in the file they stand. */
class BinaryReading {
public:
  /** \throws CIDException when the file cannot be opened */
  explicit BinaryReading(const std::string& path)
  : path_(path), stream_(openedForReading(path)), size_(sizeOfFile(path))
  {
  }

  std::ifstream&
  stream()
  {
    return stream_;
  }

  /** \brief Refuse a file that does not hold exactly this many more bytes. */
  void
  requireLeft(std::uint64_t bytes)
  {
    const std::uint64_t left = bytesLeft(stream_, size_);
    if (left != bytes)
      fail(size_ - left,
           sentence("has ", left, " bytes from here on; its header announces ", bytes));
  }

  /** \brief The next value; refused when the file ends before it does. */
  template <typename Value>
  Value
  read()
  {
    Value value{};
    stream_.read(reinterpret_cast<char*>(&value), sizeof(value));
    if (!stream_)
      fail(size_, "the file ends too early");
    return value;
  }

  /** \brief The next three coordinates; refused when they are not finite. */
  template <typename Scalar>
  Eigen::Vector3d
  readFinite()
  {
    Eigen::Vector3d v;
    for (int axis = 0; axis < 3; ++axis)
      v[axis] = static_cast<double>(read<Scalar>());
    if (!v.allFinite())
      fail(offset() - 3 * sizeof(Scalar), "is a vertex that is not finite");
    return v;
  }

  /** \brief Bytes read so far. */
  std::uint64_t
  offset()
  {
    return static_cast<std::uint64_t>(stream_.tellg());
  }

  [[noreturn]] void
  fail(std::uint64_t offset, const std::string& reason) const
  {
    throw CIDException(sentence(path_, ": offset ", offset, ": ", reason));
  }

private:
  std::string path_;
  std::ifstream stream_;
  std::uint64_t size_;
};

} // namespace pcl_cid
