/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the header of a PLY: what the file holds, and in which order.
 */

#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief A property of an element: a single value, or a list. */
struct PLYProperty {
  std::string name;
  std::uint8_t datatype = 0;
  /** Type of the length of a list; 0 for a single value. */
  std::uint8_t length_datatype = 0;
};

/** \brief An element: a table with `count` rows. */
struct PLYElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PLYProperty> properties;

  /** \brief Number of the property of this name and type, -1 when there is none.
   *  \param[in] datatype 0 for any */
  int
  find(const std::string& property, std::uint8_t datatype = 0) const;
};

/** \brief A header. */
struct PLYHeader {
  enum class Encoding { ascii, little_endian, big_endian };
  Encoding encoding = Encoding::ascii;
  std::vector<PLYElement> elements;
  /** Number of lines of the header, and what ends them. */
  std::size_t lines = 0;
  char line_end = '\n';
};

/** \brief Read a header, to the end of its last line.
 *  \param[in] name of the file, for messages
 *  \throws CIDException when it is not a header of a PLY */
PLYHeader
readPLYHeader(std::istream& stream, const std::string& name);

/** \brief The datatype of a PLY's type name; 0 when there is none. */
std::uint8_t
plyDatatype(const std::string& type);

/** \brief PLY's name of a datatype; null when there is none. */
const char*
plyTypeName(std::uint8_t datatype);

} // namespace pcl_cid
