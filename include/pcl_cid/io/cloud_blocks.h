/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds read and written block by block, for those that do not fit into memory.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>

namespace pcl_cid {

/** \brief A cloud of a file, read block by block, as often as need be. What it says and
 *  refuses is what readCloud() does, in words of its own at times; only one block is
 *  held. One thread at a time.
 *
 *  \code
 *    pcl_cid::CloudBlockReader reader("scan.pcd");
 *    pcl_cid::LabelledCloud block;
 *    while (reader.read(block))
 *      ... // block.size() points, as if they were a cloud
 *    reader.rewind();
 *  \endcode */
class PCL_CID_IO_EXPORT CloudBlockReader {
public:
  /** Points of a block, unless fewer are left. */
  static constexpr std::size_t usual_block = 65536;

  /** \param[in] path,extension as in readCloud(); not the standard input
   *  \param[in] scale LabelledCloud::scale
   *  \param[in] block most points of a block, at least 1
   *  \param[in] progress told how far a text was read; its head follows from all of it
   *  \throws CIDException as readCloud(), as far as the head of the file tells, and
   *  when it cannot be read block by block: when gzip packed it, or its format says so;
   *  the message says what can; CIDCancelled */
  explicit CloudBlockReader(const std::string& path,
                            const std::string& extension = "",
                            double scale = setting::scale.initial,
                            std::size_t block = usual_block,
                            const ProgressCallback& progress = {});
  ~CloudBlockReader();
  CloudBlockReader(const CloudBlockReader&) = delete;
  CloudBlockReader&
  operator=(const CloudBlockReader&) = delete;

  /** \brief The cloud without its data. Remarks on what follows the points join once
   * the last block was read. */
  const LabelledCloud&
  head() const;

  /** \brief Read the next block.
   *  \param[out] block a cloud of these points, in one row, with the head's fields,
   *  layout, scale and pose
   *  \return whether there was one
   *  \throws CIDException as readCloud(), and at the last block when the points are not
   *  those that were read before */
  bool
  read(LabelledCloud& block);

  /** \brief Begin again with the first block. */
  void
  rewind();

private:
  struct State;
  std::unique_ptr<State> state_;
};

/** \brief Which files can be read block by block: "a PCD that is not compressed, ...".
 */
PCL_CID_IO_EXPORT std::string
whatCanBeReadInBlocks();

/** \brief The layout in which a cloud is written block by block to a file of this name:
 *  layoutFor(), but the most compact encoding that can be written like this where that
 *  one cannot: binary for compressed.
 *  \throws CIDException as layoutFor(), or when the format cannot be written like this
 */
PCL_CID_IO_EXPORT CloudLayout
blockLayoutFor(const std::string& path, const CloudLayout& source);

/** \brief A cloud written block by block: the bytes that writeCloud() writes. */
class PCL_CID_IO_EXPORT CloudBlockWriter {
public:
  /** \param[in] stream must outlive this
   *  \param[in] head width, height and pose of the cloud; its data and fields are not
   *  used
   *  \param[in] layout of blockLayoutFor()
   *  \throws CIDException for another layout */
  CloudBlockWriter(std::ostream& stream,
                   const LabelledCloud& head,
                   const CloudLayout& layout);

  /** \brief Write the next points. The fields of the first block are those of the file.
   *  \throws CIDException as requireWritable(), and for a block with other fields */
  void
  write(const LabelledCloud& block);

  /** \brief After the last block.
   *  \throws CIDException when there were more or fewer points than the head says, or
   *  none */
  void
  finish();

private:
  std::ostream* stream_;
  LabelledCloud head_;
  CloudEncoding encoding_;
  CloudFormat format_;
  std::size_t written_ = 0;
};

} // namespace pcl_cid
