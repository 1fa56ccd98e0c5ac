/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds read and written block by block.
 */

#include "base/requirements.h"
#include "base/sentence.h"
#include "file_format.h"
#include "text/numbers.h"
#include "text/opened_file.h"
#include "text/path_names.h"

#include <pcl_cid/io/cloud_blocks.h>
#include <pcl_cid/io/cloud_formats.h>

#include <algorithm>
#include <istream>
#include <utility>
#include <vector>

#include <zlib.h>

namespace pcl_cid {
namespace {

[[noreturn]] void
refuseBlocks(const std::string& path, const std::string& reason)
{
  throw CIDException(path + ": " + reason + " cannot be read block by block; " +
                     whatCanBeReadInBlocks() + " can");
}

/** What gzip packed, and the standard input, would be held in memory. */
OpenedFile
openedForBlocks(const std::string& path)
{
  if (path == standard_stream)
    refuseBlocks(path, "the standard input");
  if (isPackedFile(path))
    refuseBlocks(path, "a file packed by gzip");
  return openFile(path, neededFile());
}

bool
hasPieces(const CloudFormat& format, CloudEncoding encoding)
{
  const auto& known = format.pieces.encodings;
  return std::find(known.begin(), known.end(), encoding) != known.end();
}

const CloudFormat&
formatNamed(const CloudLayout& layout, const std::vector<CloudFormat>& formats)
{
  const auto found =
      std::find_if(formats.begin(), formats.end(), [&](const CloudFormat& format) {
        return format.name == layout.format && hasPieces(format, layout.encoding);
      });
  if (found == formats.end())
    throw CIDException("a cloud cannot be written block by block as " + layout.format +
                       " in the encoding that is asked for; choose another layout");
  return *found;
}

bool
haveSameFields(const LabelledCloud& a, const LabelledCloud& b)
{
  const auto areEqual = [](const pcl::PCLPointField& left,
                           const pcl::PCLPointField& right) {
    return left.name == right.name && left.offset == right.offset &&
           left.datatype == right.datatype && left.count == right.count;
  };
  return a.fields.point_step == b.fields.point_step &&
         std::equal(a.fields.fields.begin(),
                    a.fields.fields.end(),
                    b.fields.fields.begin(),
                    b.fields.fields.end(),
                    areEqual);
}

} // namespace

struct CloudBlockReader::State {
  OpenedFile file;
  LabelledCloud head;
  std::unique_ptr<CloudRows> rows;
  std::size_t block;
  std::size_t next = 0;            ///< point
  unsigned long checksum = 0;      ///< of the points before
  bool was_read_whole = false;     ///< and the remarks on it are said
  unsigned long checksum_then = 0; ///< of all points
};

CloudBlockReader::CloudBlockReader(const std::string& path,
                                   const std::string& extension,
                                   double scale,
                                   std::size_t block,
                                   const ProgressCallback& progress)
: state_(std::make_unique<State>())
{
  require(setting::scale, scale);
  requireAtLeast("most points of a block", block, std::size_t{1});
  State& s = *state_;
  s.file = openedForBlocks(path);
  s.block = block;
  s.head.name = path;
  const CloudFormat& format = formatOf(s.file, path, extension);
  if (format.stream)
    s.rows = format.stream(*s.file.stream, s.file.size, s.head, progress);
  if (!s.rows)
    refuseBlocks(path, "this " + format.name + " file");
  requireWhole(s.head, 0);
  mendPose(s.head);
  s.head.scale = scale;
  rewind();
}

CloudBlockReader::~CloudBlockReader() = default;

const LabelledCloud&
CloudBlockReader::head() const
{
  return state_->head;
}

bool
CloudBlockReader::read(LabelledCloud& block)
{
  State& s = *state_;
  const std::size_t count = std::min(s.block, s.head.size() - s.next);
  if (count == 0)
    return false;
  std::vector<std::uint8_t> data = std::move(block.fields.data);
  block = s.head;
  block.remarks.clear();
  data.resize(count * s.head.fields.point_step);
  s.rows->read(count, data.data());
  block.fields.data = std::move(data);
  block.fields.width = static_cast<std::uint32_t>(count);
  block.fields.height = 1;
  block.fields.row_step = block.fields.point_step * block.fields.width;
  block.first_point = s.next;
  s.next += count;
  s.checksum = crc32_z(s.checksum, block.fields.data.data(), block.fields.data.size());
  if (s.next < s.head.size())
    return true;
  const std::size_t remarks = s.head.remarks.size();
  s.rows->end();
  if (s.was_read_whole) {
    s.head.remarks.resize(remarks);
    if (s.checksum != s.checksum_then)
      throw CIDException(s.head.name + ": has changed while it was read");
  }
  s.was_read_whole = true;
  s.checksum_then = s.checksum;
  return true;
}

void
CloudBlockReader::rewind()
{
  state_->rows->begin();
  state_->next = 0;
  state_->checksum = 0;
}

std::string
whatCanBeReadInBlocks()
{
  std::vector<std::string> files;
  for (const CloudFormat& format : cloudFormats())
    if (!format.streams.empty())
      files.push_back(format.streams);
  return listed(files);
}

CloudLayout
blockLayoutFor(const std::string& path, const CloudLayout& source)
{
  CloudLayout layout = layoutFor(path, source);
  for (const CloudFormat& format : cloudFormats())
    if (format.name == layout.format && !format.pieces.encodings.empty() &&
        !hasPieces(format, layout.encoding))
      layout.encoding = format.pieces.encodings.back();
  formatNamed(layout, cloudFormats());
  return layout;
}

CloudBlockWriter::CloudBlockWriter(std::ostream& stream,
                                   const LabelledCloud& head,
                                   const CloudLayout& layout)
: stream_(&stream)
, head_(head)
, encoding_(layout.encoding)
, format_(formatNamed(layout, cloudFormats()))
{
  head_.fields.data.clear();
}

void
CloudBlockWriter::write(const LabelledCloud& block)
{
  requireWritable(block, "file" + format_.extensions.front());
  if (written_ == 0) {
    head_.fields.fields = block.fields.fields;
    head_.fields.point_step = block.fields.point_step;
    format_.pieces.head(*stream_, head_, encoding_);
  }
  if (!haveSameFields(block, head_))
    throw CIDException(head_.name + ": a block has other fields than the one before");
  format_.pieces.rows(*stream_, block, encoding_);
  written_ += block.size();
}

void
CloudBlockWriter::finish()
{
  if (written_ != head_.size() || written_ == 0)
    throw CIDException(sentence(head_.name,
                                ": ",
                                countOf(written_, "point"),
                                " were written block by block; the cloud has ",
                                head_.size()));
  if (format_.pieces.tail)
    format_.pieces.tail(*stream_, head_, encoding_);
}

} // namespace pcl_cid
