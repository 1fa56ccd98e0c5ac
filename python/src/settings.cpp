/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Keywords that are settings: read, checked and told of by the rows of the one table.
 */

#include "settings.h"

#include <algorithm>
#include <string_view>

namespace pcl_cid::python {
namespace {

/** Of Python or of numpy: no number, though both can be taken for one. */
bool
isBool(py::handle given)
{
  return PyBool_Check(given.ptr()) ||
         std::string_view(Py_TYPE(given.ptr())->tp_name) == "numpy.bool_";
}

/** The int that a value stands for by __index__. */
py::object
indexOf(py::handle given)
{
  if (isBool(given) || PyIndex_Check(given.ptr()) == 0)
    return py::none();
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
  if (number)
    return number;
  PyErr_Clear();
  return py::none();
}

/** What a choice is between; a number has no words. */
template <typename Value>
py::object
wordListOf(const NumberSetting<Value>&)
{
  return py::none();
}

template <typename Value, std::size_t Count>
py::object
wordListOf(const ChoiceSetting<Value, Count>& row)
{
  py::list words;
  for (const auto& each : row.words)
    words.append(each.word);
  return words;
}

template <typename Row>
py::dict
describe(const Row& row)
{
  py::dict entry;
  entry["group"] = row.group;
  entry["name"] = row.name;
  entry["type"] = typeOf(row);
  entry["default"] = asPython(row, row.initial);
  entry["paper"] = asPython(row, row.paper());
  entry["range"] = allowedBy(row);
  entry["words"] = wordListOf(row);
  entry["meaning"] = meaningOf(row);
  return entry;
}

} // namespace

std::optional<long long>
wholeNumber(py::handle given)
{
  const py::object number = indexOf(given);
  int overflow = 0;
  const long long value =
      number.is_none() ? 0 : PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (number.is_none() || overflow != 0)
    return std::nullopt;
  return value;
}

std::optional<unsigned long long>
naturalNumber(py::handle given)
{
  const py::object number = indexOf(given);
  if (number.is_none())
    return std::nullopt;
  const unsigned long long value = PyLong_AsUnsignedLongLong(number.ptr());
  if (PyErr_Occurred() == nullptr)
    return value;
  PyErr_Clear();
  return std::nullopt;
}

std::optional<double>
realNumber(py::handle given)
{
  if (isBool(given))
    return std::nullopt;
  const double value = PyFloat_AsDouble(given.ptr());
  if (PyErr_Occurred() == nullptr)
    return value;
  PyErr_Clear();
  return std::nullopt;
}

Keywords::Keywords(const char* function, const py::kwargs& given)
: function_(function), given_(given)
{
}

void
Keywords::requireKnown() const
{
  for (const auto& [name, value] : given_) {
    const auto text = name.cast<std::string>();
    if (std::find(known_.begin(), known_.end(), text) != known_.end())
      continue;
    std::string known;
    for (const std::string& each : known_)
      known += (known.empty() ? "" : ", ") + each;
    throw py::type_error(std::string(function_) + "() has no setting '" + text +
                         "'; there are " + known);
  }
}

std::string
SettingDocs::in(const std::string& text) const
{
  return replaced(text, "{settings}\n", lines_);
}

std::string
replaced(std::string text, const std::string& place, const std::string& by)
{
  for (std::size_t at = text.find(place); at != std::string::npos;
       at = text.find(place, at + by.size()))
    text.replace(at, place.size(), by);
  return text;
}

void
bindSettings(py::module_& module)
{
  module.def(
      "settings",
      [] {
        py::list rows;
        forEachSetting([&](const auto& row) { rows.append(describe(row)); });
        return rows;
      },
      R"(The table of settings.

Returns
-------
list of dict
    For each setting its group, name, type, default, the default of the paper
    (Wang et al., RA-L 2023), range, words where it is one of a few, and meaning.
    Lengths are in metres.
)");
}

} // namespace pcl_cid::python
