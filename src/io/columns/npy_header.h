/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the header of an array of NumPy: its shape, and what its elements are.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Numbers that a point may have. */
constexpr std::size_t most_numbers_of_point = 1000;

/** \brief Numbers of one type in an element of an array. */
struct NpyField {
  std::string name;     ///< empty where the element is one number
  char kind = 'f';      ///< 'f', 'i', 'u' or 'b', as NumPy calls it
  std::size_t size = 4; ///< bytes of a number
  bool is_big_endian = false;
  std::size_t count = 1; ///< numbers, one after the other

  std::size_t
  bytes() const
  {
    return size * count;
  }
};

/** \brief A header. */
struct NpyHeader {
  std::vector<NpyField> fields; ///< of an element
  std::vector<std::uint64_t> shape;
  bool is_fortran_order = false;
};

/** \brief Whether a file begins as an array of NumPy. */
bool
recognizesNpy(std::istream& stream);

/** \brief Read a header (format 1.0 to 3.0), to its end.
 *  \param[in] name of the file, for messages
 *  \throws CIDException when it is none, or its elements are no numbers */
NpyHeader
readNpyHeader(std::istream& stream, const std::string& name);

} // namespace pcl_cid
