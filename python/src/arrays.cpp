/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Arrays of numpy: checked on their way in, views on their way out.
 */

#include "arrays.h"

#include <cmath>
#include <limits>

namespace pcl_cid::python {
namespace {

std::string
shapeOf(const py::array& array)
{
  return shown(array.attr("shape"));
}

/** Whatever numpy makes of it; ragged lists and the like are refused. */
py::array
anyArray(const py::object& given, const char* name, const char* allowed)
{
  try {
    py::array array = py::module_::import("numpy").attr("asarray")(given);
    if (array.dtype().kind() != 'O')
      return array;
  }
  catch (py::error_already_set& error) {
    if (!error.matches(PyExc_Exception)) // Ctrl-C
      throw;
  }
  refuse("what is given as ", name, " is ", shown(given), "; it must be ", allowed);
}

/** The array in a type that its values fit into, native and C-contiguous. */
py::array
converted(const py::array& array, const char* dtype)
{
  return py::module_::import("numpy").attr("ascontiguousarray")(array, dtype);
}

/** (N, 3) of numbers. */
py::array
triples(const py::object& given, const char* name, const char* allowed)
{
  py::array array = anyArray(given, name, allowed);
  if (array.ndim() != 2 || array.shape(1) != 3)
    refuse("the array of ",
           name,
           " has the shape ",
           shapeOf(array),
           "; it must be ",
           allowed);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    refuse("the array of ",
           name,
           " has the dtype ",
           std::string(py::str(array.dtype())),
           "; it must be ",
           allowed);
  return array;
}

/** (N,) of whole numbers, 0 to \a most. */
template <typename Value>
std::vector<Value>
wholeNumbers(const py::object& given,
             const char* name,
             std::uint64_t most,
             const std::string& allowed)
{
  const py::array array =
      anyArray(given, name, "an array of whole numbers, of shape (N,)");
  if (array.ndim() > 1)
    refuse(
        "the array of ", name, " has the shape ", shapeOf(array), "; it must be (N,)");
  const char kind = array.dtype().kind();
  if (array.size() == 0)
    return {};
  if (kind != 'i' && kind != 'u')
    refuse("the array of ",
           name,
           " has the dtype ",
           std::string(py::str(array.dtype())),
           "; it must be of whole numbers");
  // Bits of a negative number are those of one that is too large.
  const py::array_t<std::uint64_t> bits(
      kind == 'u' ? converted(array, "uint64")
                  : py::array(converted(array, "int64").attr("view")("uint64")));
  std::vector<Value> values;
  values.reserve(static_cast<std::size_t>(array.size()));
  for (py::ssize_t i = 0; i < bits.size(); ++i) {
    const std::uint64_t value = bits.data()[i];
    if (value > most)
      refuse("the array of ",
             name,
             " holds ",
             shown(array.attr("flat")[py::int_(i)].attr("item")()),
             "; ",
             allowed);
    values.push_back(static_cast<Value>(value));
  }
  return values;
}

} // namespace

py::array
pointsOf(const py::object& given, const char* name)
{
  const py::array array = triples(given, name, "an array of shape (N, 3)");
  if (array.shape(0) == 0)
    refuse("the array of ", name, " has the shape (0, 3); at least 1 point is needed");
  if (array.shape(0) > std::numeric_limits<pcl::index_t>::max())
    refuse("the array of ",
           name,
           " has ",
           array.shape(0),
           " rows; at most ",
           std::numeric_limits<pcl::index_t>::max(),
           " points can be numbered");
  const bool is_single = array.dtype().kind() == 'f' && array.itemsize() <= 4;
  return converted(array, is_single ? "float32" : "float64");
}

std::vector<Eigen::Vector3d>
positionsOf(const py::object& given, const char* name)
{
  py::object rows = given;
  if (const py::array array = anyArray(given, name, "an array of shape (3,) or (K, 3)");
      array.ndim() == 1)
    rows = array.attr("reshape")(1, -1);
  const py::array_t<double> array(
      converted(triples(rows, name, "an array of shape (3,) or (K, 3)"), "float64"));
  std::vector<Eigen::Vector3d> positions;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    positions.emplace_back(array.data(i, 0));
    if (!positions.back().allFinite())
      refuse("row ",
             i,
             " of the array of ",
             name,
             " is not finite; it must be a position");
  }
  return positions;
}

pcl::Indices
indicesOf(const py::object& given, const char* name, std::size_t size)
{
  return wholeNumbers<pcl::index_t>(given,
                                    name,
                                    size - 1,
                                    "it must be 0 to " + std::to_string(size) +
                                        " - 1 (the points of the scan)");
}

std::vector<std::uint32_t>
labelsOf(const py::object& given, const char* name)
{
  return wholeNumbers<std::uint32_t>(
      given,
      name,
      std::numeric_limits<std::uint32_t>::max(),
      "a label must be a whole number, 0 to 4294967295, 0 for none");
}

std::vector<std::uint32_t>
labelsOf(const py::object& given,
         const char* name,
         std::size_t size,
         const char* things)
{
  std::vector<std::uint32_t> labels = labelsOf(given, name);
  if (labels.size() != size)
    refuse("there are ",
           labels.size(),
           " ",
           name,
           "; there must be one for each of the ",
           size,
           " ",
           things);
  return labels;
}

std::vector<ColorRGB>
colorsOf(const py::object& given, std::size_t size)
{
  constexpr const char* allowed =
      "an array of shape (N, 3), uint8 or floats from 0 to 1";
  const py::array array = triples(given, "colors", allowed);
  if (static_cast<std::size_t>(array.shape(0)) != size)
    refuse("there are ",
           array.shape(0),
           " colors; there must be one for each of the ",
           size,
           " points");
  const double white = array.dtype().kind() == 'f' ? 1.0 : 255.0;
  const py::array_t<double> channels(converted(array, "float64"));
  const auto byte = [&](py::ssize_t i, int channel) {
    const double value = channels.at(i, channel);
    if (value < 0.0 || value > white)
      refuse("the color of point ",
             i,
             " has the value ",
             value,
             "; it must be 0 to ",
             white);
    return static_cast<std::uint8_t>(
        std::isnan(value) ? 0 : std::lround(value / white * 255.0));
  };
  std::vector<ColorRGB> colors;
  colors.reserve(size);
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    colors.push_back({byte(i, 0), byte(i, 1), byte(i, 2)});
  return colors;
}

py::array
readOnly(py::array array)
{
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

} // namespace pcl_cid::python
