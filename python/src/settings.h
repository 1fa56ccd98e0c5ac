/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Keywords that are settings: read, checked and told of by the rows of the one table.
 */

#pragma once

#include "errors.h"

#include <pcl_cid/core/settings.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <pybind11/pybind11.h>

namespace pcl_cid::python {

/** \brief A whole number of Python that fits 64 bits; none for anything else: bool is
 *  not a number here. */
std::optional<long long>
wholeNumber(py::handle given);

/** \brief The same without sign. */
std::optional<unsigned long long>
naturalNumber(py::handle given);

/** \brief A number of Python; none for anything else. */
std::optional<double>
realNumber(py::handle given);

/** \brief A value of Python for a row.
 *  \throws ValueError "the <title> is <value>; it must be <range>" */
template <typename Value>
Value
valueFor(const NumberSetting<Value>& row, py::handle given)
{
  const auto number = [&] {
    if constexpr (std::is_floating_point_v<Value>)
      return realNumber(given);
    else if constexpr (std::is_same_v<Value, std::uint64_t>)
      return naturalNumber(given);
    else
      return wholeNumber(given);
  }();
  if (!number || !row.allows(*number))
    refuse("the ", row.title, " is ", shown(given), "; it must be ", rangeOf(row));
  return static_cast<Value>(*number);
}

/** \brief "'auto', 'off' or 'on'". */
template <typename Value, std::size_t Count>
std::string
wordsOf(const ChoiceSetting<Value, Count>& row)
{
  std::string words;
  for (std::size_t i = 0; i < Count; ++i)
    words += (i == 0           ? ""
              : i + 1 == Count ? " or "
                               : ", ") +
             ("'" + std::string(row.words[i].word) + "'");
  return words;
}

/** \brief The same for a row of words; True and False stand for those that mean them.
 */
template <typename Value, std::size_t Count>
Value
valueFor(const ChoiceSetting<Value, Count>& row, py::handle given)
{
  if constexpr (std::is_same_v<Value, bool>)
    if (PyBool_Check(given.ptr()))
      return given.is(py::bool_(true));
  if (py::isinstance<py::str>(given))
    if (const auto value = row.valueOf(given.cast<std::string>()))
      return *value;
  refuse(row.name, " is ", shown(given), "; it must be ", wordsOf(row));
}

/** \brief How Python writes the value of a row. */
template <typename Value>
py::object
asPython(const NumberSetting<Value>&, Value value)
{
  if constexpr (std::is_same_v<Value, float>)
    return py::cast(asWritten(value));
  else
    return py::cast(value);
}

template <typename Value, std::size_t Count>
py::object
asPython(const ChoiceSetting<Value, Count>& row, Value value)
{
  return py::cast(row.wordOf(value));
}

/** \brief The keywords of a call. A setting that is missing or None keeps its value. */
class Keywords {
public:
  Keywords(const char* function, const py::kwargs& given);

  /** \brief Take the setting of a row.
   *  \throws ValueError */
  template <typename Row, typename Value>
  void
  operator()(const Row& row, Value& value)
  {
    known_.emplace_back(row.name);
    if (given_.contains(row.name) && !py::object(given_[row.name]).is_none())
      value = static_cast<Value>(valueFor(row, given_[row.name]));
  }

  template <typename Row, typename Value>
  void
  operator()(const Row& row, std::optional<Value>& value)
  {
    known_.emplace_back(row.name);
    if (given_.contains(row.name) && !py::object(given_[row.name]).is_none())
      value = static_cast<Value>(valueFor(row, given_[row.name]));
  }

  /** \brief Once all that there are were taken.
   *  \throws TypeError that lists them, when another one was given */
  void
  requireKnown() const;

private:
  const char* function_;
  py::kwargs given_;
  std::vector<std::string> known_;
};

/** \brief The lines of a docstring about settings, by calling \a visit_all with a
 *  visitor as Keywords is one. */
class SettingDocs {
public:
  template <typename Row, typename Value>
  void
  operator()(const Row& row, const Value&)
  {
    add(row, std::is_same_v<Value, std::optional<std::decay_t<decltype(row.initial)>>>);
  }

  /** \brief \a text with the lines in the place of "{settings}". */
  std::string
  in(const std::string& text) const;

  /** \brief What each keyword is where it is not given. */
  const py::dict&
  defaults() const
  {
    return defaults_;
  }

private:
  template <typename Row>
  void
  add(const Row& row, bool is_optional);

  py::dict defaults_;
  std::string lines_;
};

/** \brief What a type of a row is called in Python. */
template <typename Value>
std::string
typeOf(const NumberSetting<Value>&)
{
  return std::is_floating_point_v<Value> ? "float" : "int";
}

template <typename Value, std::size_t Count>
std::string
typeOf(const ChoiceSetting<Value, Count>&)
{
  return std::is_same_v<Value, bool> ? "str or bool" : "str";
}

template <typename Value>
std::string
allowedBy(const NumberSetting<Value>& row)
{
  return rangeOf(row);
}

template <typename Value, std::size_t Count>
std::string
allowedBy(const ChoiceSetting<Value, Count>& row)
{
  return wordsOf(row);
}

/** \brief The sentence of a row, with what 0 means where it is within the range. */
template <typename Value>
std::string
meaningOf(const NumberSetting<Value>& row)
{
  const bool zero_is_inside = row.zero && row.least <= Value{0};
  return std::string(row.meaning) +
         (zero_is_inside ? std::string("; 0 ") + row.zero : "");
}

template <typename Value, std::size_t Count>
std::string
meaningOf(const ChoiceSetting<Value, Count>& row)
{
  return row.meaning;
}

template <typename Row>
void
SettingDocs::add(const Row& row, bool is_optional)
{
  const py::object initial =
      is_optional ? py::object(py::none()) : asPython(row, row.initial);
  defaults_[row.name] = initial;
  lines_ += std::string(row.name) + " : " + typeOf(row) + ", default " +
            py::repr(initial).template cast<std::string>() + "\n    " + meaningOf(row) +
            " (" + allowedBy(row) + ")\n";
}

/** \brief \a text with what follows in the place of \a place, wherever it is. */
std::string
replaced(std::string text, const std::string& place, const std::string& by);

/** \brief A docstring with the default of a row for "{name}" and its range for "{name
 *  range}". */
template <typename Row>
std::string
withRange(const std::string& text, const Row& row)
{
  const std::string name(row.name);
  const std::string initial =
      py::repr(asPython(row, row.initial)).template cast<std::string>();
  return replaced(replaced(text, "{" + name + "}", initial),
                  "{" + name + " range}",
                  allowedBy(row));
}

/** \brief settings(): the table, for people and for the stub. */
void
bindSettings(py::module_& module);

} // namespace pcl_cid::python
