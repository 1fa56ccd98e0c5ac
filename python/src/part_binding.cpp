/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * ConvexPart and save(): hulls as arrays, and into files.
 */

#include "arrays.h"
#include "file_output.h"
#include "parts.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>

#include <ostream>

namespace pcl_cid::python {
namespace {

constexpr const char* save_doc =
    R"(Write hulls to a mesh file, which appears whole or not at all.

Parameters
----------
path : str or os.PathLike
    Its extension is the format: .obj (an object for each part, colors in an .mtl
    beside it), .ply (color and part number for each face) or .stl (float32).
parts : sequence of ConvexPart
    In the order of their numbers.
name : str, optional
    Before the names of objects and materials, where the format has those (.obj), so
    that files of several scans can be loaded together: ASCII letters, digits and
    underscores, a letter first.

Raises
------
ValueError
    For another extension, and for a name that is not good.
TypeError
    When one of the parts is none.
CIDError
    When the file cannot be written.
)";

/** (n, 3) on the values of a part, which live as long as the part. */
template <typename Value, typename Row>
py::array
rowsOf(const py::object& self, const std::vector<Row>& rows)
{
  static_assert(sizeof(Row) == 3 * sizeof(Value), "rows of three values");
  return readOnly(
      py::array_t<Value>({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}},
                         reinterpret_cast<const Value*>(rows.data()),
                         self));
}

py::array
indicesOf(const py::object& self, const pcl::Indices& indices)
{
  return readOnly(py::array_t<pcl::index_t>(
      static_cast<py::ssize_t>(indices.size()), indices.data(), self));
}

const ConvexPart&
partOf(const py::object& self)
{
  return self.cast<const ConvexPart&>();
}

std::vector<ConvexPart>
partsOf(const py::object& given)
{
  if (!py::isinstance<py::iterable>(given))
    throw py::type_error("parts is " + shown(given) +
                         "; it must be a sequence of ConvexPart");
  std::vector<ConvexPart> parts;
  for (const py::handle each : py::iterable(given)) {
    if (!py::isinstance<ConvexPart>(each))
      throw py::type_error("part " + std::to_string(parts.size()) + " is " +
                           shown(each) + "; it must be a ConvexPart");
    parts.push_back(each.cast<const ConvexPart&>());
  }
  return parts;
}

void
save(const py::object& path, const py::object& given, const std::string& name)
{
  const std::string file = pathOf(path);
  if (!name.empty())
    blamingValues([&] { requirePartsName(name); });
  const std::vector<ConvexPart> parts = partsOf(given);
  const std::string materials = blamingValues([&] { return materialsBeside(file); });
  writeFile(
      file,
      [&](std::ostream& stream) { writeMesh(stream, parts, file, name); },
      materials,
      [&](std::ostream& stream) { writeMaterials(stream, parts, file, name); });
}

} // namespace

void
bindParts(py::module_& module)
{
  py::class_<ConvexPart, std::shared_ptr<ConvexPart>> part(
      module,
      "ConvexPart",
      "An approximately convex part of a scan and its hull. Arrays are read-only "
      "views.");
  forbidNew(part);
  part.def_property_readonly(
          "vertices",
          [](const py::object& self) {
            return rowsOf<double>(self, partOf(self).hull.vertices);
          },
          "ndarray of float64, shape (V, 3): corners of the hull, metres, in the "
          "coordinates of the points that were given.")
      .def_property_readonly(
          "faces",
          [](const py::object& self) {
            return rowsOf<std::uint32_t>(self, partOf(self).hull.triangles);
          },
          "ndarray of uint32, shape (F, 3): triangles, counter-clockwise seen from "
          "outside.")
      .def_property_readonly(
          "indices",
          [](const py::object& self) { return indicesOf(self, partOf(self).indices); },
          "ndarray of int32: the points of the part, ascending.")
      .def_property_readonly(
          "trimmed",
          [](const py::object& self) { return indicesOf(self, partOf(self).trimmed); },
          "ndarray of int32: stray points that the hull need not contain, ascending.")
      .def_readonly("volume", &ConvexPart::volume, "Of the hull, cubic metres.")
      .def_readonly("area", &ConvexPart::area, "Of the hull's surface, square metres.")
      .def_readonly("thickness",
                    &ConvexPart::thickness,
                    "Least width of the hull over all directions, metres.")
      .def_readonly("thickened",
                    &ConvexPart::thickened,
                    "Whether the points alone were thinner than min_thickness.")
      .def_readonly(
          "boxed",
          &ConvexPart::boxed,
          "Whether the hull is the oriented box of the points, as qhull failed.")
      .def("__repr__", [](const ConvexPart& self) {
        return "<pcl_cid.ConvexPart of " + std::to_string(self.indices.size()) +
               " points, " + std::to_string(self.hull.vertices.size()) + " vertices>";
      });
  module.def(
      "save", &save, py::arg("path"), py::arg("parts"), py::arg("name") = "", save_doc);
}

} // namespace pcl_cid::python
