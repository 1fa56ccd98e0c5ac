/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the header of a PCD: what the file holds.
 */

#pragma once

#include "fields/field_values.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_cid {

/** \brief One entry of FIELDS with its SIZE, TYPE and COUNT. */
struct PCDColumn {
  std::string name;
  std::uint8_t datatype = pcl::PCLPointField::FLOAT32;
  std::uint32_t count = 1;
  /** Where its values stand in a point of the cloud, which has no padding; meaningless
   *  for padding itself. */
  std::uint32_t offset = 0;

  bool
  isPadding() const
  {
    return name == padding_name;
  }

  /** \brief Bytes in a point. */
  std::size_t
  bytes() const
  {
    return count * sizeOf(datatype);
  }
};

/** \brief A header. */
struct PCDHeader {
  CloudEncoding encoding = CloudEncoding::ascii;
  /** Those with values. */
  std::vector<PCDColumn> columns;
  /** Names of the others, with COUNT 0. */
  std::vector<std::string> empty_columns;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  /** Number of lines of the header, and what ends them. */
  std::size_t lines = 0;
  char line_end = '\n';
};

/** \brief Whether a word is the name of an entry: FIELDS, WIDTH, ... */
bool
isPCDEntry(std::string_view word);

/** \brief Read a header, to the end of its last line.
 *  \param[in] name of the file, for messages
 *  \throws CIDException when it is not a consistent header of a PCD, or announces no
 *  point, more than 2^31 - 1 points, or points of more than 2^31 - 1 bytes */
PCDHeader
readPCDHeader(std::istream& stream, const std::string& name);

} // namespace pcl_cid
