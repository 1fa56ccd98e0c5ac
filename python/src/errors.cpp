/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Errors as Python has them.
 */

#include "errors.h"

namespace pcl_cid::python {
namespace {

extern "C" PyObject*
refuseNew(PyTypeObject* type, PyObject*, PyObject*)
{
  PyErr_Format(PyExc_TypeError, "a %s is made by a Scan alone", type->tp_name);
  return nullptr;
}

} // namespace

std::string
shown(py::handle value)
{
  constexpr std::size_t most = 60;
  std::string text;
  try {
    text = py::str(py::repr(value)).cast<std::string>();
  }
  catch (const py::error_already_set&) { // a repr of the caller's own
    text = std::string("a ") + Py_TYPE(value.ptr())->tp_name;
  }
  for (char& character : text)
    if (character == '\n')
      character = ' ';
  if (text.size() <= most)
    return text;
  text.resize(most);
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80) != 0)
    text.pop_back(); // not within a character
  return text + "...";
}

void
forbidNew(const py::object& cls)
{
  reinterpret_cast<PyTypeObject*>(cls.ptr())->tp_new = refuseNew;
}

void
bindErrors(py::module_& module)
{
  const auto& error =
      py::register_exception<CIDException>(module, "CIDError", PyExc_RuntimeError);
  error.attr("__doc__") = "The work failed; the message is a sentence that says why.";
  const auto& cancelled =
      py::register_exception<CIDCancelled>(module, "CIDCancelled", error);
  cancelled.attr("__doc__") = "The progress callback returned False; nothing changed.";
}

} // namespace pcl_cid::python
