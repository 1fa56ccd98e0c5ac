/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The row of PCD in the table of cloud formats.
 */

#include "pcd_format.h"

#include "pcd_header.h"
#include "text/file_reading.h"

#include <iomanip>
#include <istream>
#include <string>

namespace pcl_cid {
namespace {

/** Comments, then an entry of a header. */
bool
recognizesPCD(std::istream& stream)
{
  const char line_end = lineEndOf(stream);
  passByteOrderMark(stream);
  std::string line;
  while ((stream >> std::ws).peek() == '#')
    std::getline(stream, line, line_end);
  constexpr int longer_than_any = 16; // of a file without blanks, no more is read
  std::string word;
  stream >> std::setw(longer_than_any) >> word;
  return isPCDEntry(word);
}

} // namespace

CloudFormat
pcdFormat()
{
  CloudFormat format;
  format.name = "PCD";
  format.extensions = {".pcd"};
  format.encodings = {
      CloudEncoding::ascii, CloudEncoding::binary, CloudEncoding::compressed};
  format.recognizes = recognizesPCD;
  format.read = readPCD;
  format.streams = "a PCD that is not compressed";
  format.stream = streamPCD;
  format.write = writePCD;
  format.pieces = pcdPieces();
  return format;
}

} // namespace pcl_cid
