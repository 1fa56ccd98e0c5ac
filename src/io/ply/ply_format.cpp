/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The row of PLY in the table of cloud formats.
 */

#include "ply_format.h"

#include "text/file_reading.h"

#include <iomanip>
#include <istream>
#include <string>

namespace pcl_cid {
namespace {

/** The first line is "ply". */
bool
recognizesPLY(std::istream& stream)
{
  constexpr int longer_than_ply = 8; // of a file without blanks, no more is read
  passByteOrderMark(stream);
  std::string word;
  return stream >> std::setw(longer_than_ply) >> word && word == "ply";
}

} // namespace

CloudFormat
plyFormat()
{
  CloudFormat format;
  format.name = "PLY";
  format.extensions = {".ply"};
  format.encodings = {CloudEncoding::ascii, CloudEncoding::binary};
  format.recognizes = recognizesPLY;
  format.read = readPLYCloud;
  format.streams = "a binary PLY whose vertices have no lists";
  format.stream = streamPLYCloud;
  format.check = checkPLYCloud;
  format.write = writePLYCloud;
  format.pieces = plyPieces();
  return format;
}

} // namespace pcl_cid
