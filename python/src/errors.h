/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Errors as Python has them.
 */

#pragma once

#include <pcl_cid/exceptions.h>

#include <sstream>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

namespace pcl_cid::python {

namespace py = pybind11;

/** \brief What a message shows of a value: its repr, shortened. */
std::string
shown(py::handle value);

/** \brief Raise ValueError with a sentence of these parts. */
template <typename... Parts>
[[noreturn]] void
refuse(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw py::value_error(text.str());
}

/** \brief Work of which the library complains only when a given value is bad:
 *  CIDException becomes ValueError. May run without the GIL. */
template <typename Work>
auto
blamingValues(Work&& work) -> decltype(work())
{
  try {
    return std::forward<Work>(work)();
  }
  catch (const CIDCancelled&) {
    throw;
  }
  catch (const CIDException& error) {
    throw py::value_error(error.what());
  }
}

/** \brief Refuse to make an object of a class from Python, by whatever way: what
 *  pybind11 makes there has no value. */
void
forbidNew(const py::object& cls);

/** \brief CIDError and CIDCancelled, and their place in the module. */
void
bindErrors(py::module_& module);

} // namespace pcl_cid::python
