/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * read() and write(): clouds from files and into files.
 */

#include "cloud.h"
#include "file_output.h"
#include "gil.h"

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <ostream>

#include <pybind11/stl.h>

namespace pcl_cid::python {
namespace {

constexpr const char* cloud_doc = R"(A cloud with named columns, as `read` gives it.

``cloud["x"]`` is a read-only array of shape (N,) on the cloud's own memory, ``cloud["label"]
= values`` replaces or adds a column: whole numbers as uint32, floats as float32. Columns that
were taken before keep their values.
)";

constexpr const char* read_doc = R"(Read a cloud from a file or the folder of a dataset.

Parameters
----------
path : str or os.PathLike
    A PCD or PLY file, text, an array of NumPy, a scan of KITTI or nuScenes (`.bin`), any
    of these packed by gzip, a mesh, a room folder of S3DIS or a scan folder of ScanNet.
class_table : str or os.PathLike, optional
    ScanNet's `scannetv2-labels.combined.tsv`; looked for in the folder of the scan and
    above it where it is not given.
scale : float, optional
    Metres that a unit of the coordinates stands for; 0.001 for millimetres. The fields
    keep the unit of the file.
mesh_spacing : float, optional
    How far apart points are that are laid over the surface of a mesh, in the unit of
    the file; 0 for about 200,000 points. With it, a PLY is read as a mesh.

Returns
-------
Cloud
    What was repaired or assumed while reading is a UserWarning.

Raises
------
CIDError
    When the file cannot be read, with its name and what is wrong with it.
)";

constexpr const char* write_doc =
    R"(Write a cloud to a file, which appears whole or not at all.

Parameters
----------
path : str or os.PathLike
    Its extension is the format: .pcd or .ply.
cloud : Cloud or array_like of shape (N, 3)
    In metres. A cloud that was read keeps its layout, fields and sensor.
encoding : {'ascii', 'binary', 'compressed'}, optional
    Default: that of the file the cloud was read from, else 'compressed' for PCD.
**fields : array_like of shape (N,)
    Columns that the file has in addition: whole numbers (uint32) or floats (float32).

Raises
------
ValueError
    For a field of another length or type, and an encoding that the format lacks.
CIDError
    When the file cannot be written.
)";

constexpr std::pair<const char*, CloudEncoding> encodings[] = {
    {"ascii", CloudEncoding::ascii},
    {"binary", CloudEncoding::binary},
    {"compressed", CloudEncoding::compressed}};

Cloud
read(const py::object& path,
     const py::object& class_table,
     double scale,
     double mesh_spacing)
{
  Remarks remarks;
  const std::string file = pathOf(path);
  const std::string table = class_table.is_none() ? "" : pathOf(class_table);
  Cloud cloud([&] {
    const GilReleased released;
    return readScan(file, {table, remarks.callback(), scale, mesh_spacing});
  }());
  remarks.warn();
  return cloud;
}

/** The format has to have it. */
CloudEncoding
encodingOf(const py::object& encoding, const std::string& path)
{
  const std::vector<CloudEncoding> known = findCloudFormat(path)->encodings;
  std::string words;
  for (const auto& [word, value] : encodings) {
    if (std::find(known.begin(), known.end(), value) == known.end())
      continue;
    if (py::isinstance<py::str>(encoding) && encoding.cast<std::string>() == word)
      return value;
    words += (words.empty() ? "'" : ", '") + std::string(word) + "'";
  }
  refuse("the encoding is ", shown(encoding), "; for ", path, " there are ", words);
}

Cloud
asCloud(const py::object& cloud)
{
  if (py::isinstance<Cloud>(cloud))
    return cloud.cast<Cloud>();
  return Cloud(cloudOf(pointsOf(cloud, "points"), "points"));
}

void
write(const py::object& path,
      const py::object& given,
      const py::object& encoding,
      const py::kwargs& fields)
{
  const std::string file = pathOf(path);
  Cloud cloud = asCloud(given);
  for (const auto& [name, values] : fields)
    cloud.setColumn(name.cast<std::string>(),
                    py::reinterpret_borrow<py::object>(values));
  Remarks remarks;
  requireWritable(cloud.cloud(), file, remarks.callback());
  CloudLayout layout = layoutFor(file, cloud.cloud().layout);
  if (!encoding.is_none())
    layout.encoding = encodingOf(encoding, file);
  writeFile(file,
            [&](std::ostream& stream) { writeCloud(stream, cloud.cloud(), layout); });
  remarks.warn();
}

} // namespace

void
bindClouds(py::module_& module)
{
  py::class_<Cloud>(module, "Cloud", cloud_doc)
      .def(py::init([](const py::object& points, const py::object& sensor) {
             LabelledCloud cloud = cloudOf(pointsOf(points, "points"), "points");
             setSensor(sensor, cloud);
             return Cloud(std::move(cloud));
           }),
           py::arg("points"),
           py::arg("sensor") = py::none())
      .def(
          "__getitem__",
          [](const Cloud& self, const py::str& name) {
            return self.column(name.cast<std::string>());
          },
          py::arg("name"))
      .def(
          "__setitem__",
          [](Cloud& self, const py::str& name, const py::object& values) {
            self.setColumn(name.cast<std::string>(), values);
          },
          py::arg("name"),
          py::arg("values"))
      .def("__contains__",
           [](const Cloud& self, const py::object& name) {
             return py::isinstance<py::str>(name) &&
                    hasField(self.cloud(), name.cast<std::string>());
           })
      .def("__iter__",
           [](const Cloud& self) { return py::iter(py::cast(self.names())); })
      .def("__len__", [](const Cloud& self) { return self.cloud().size(); })
      .def("__repr__",
           [](const Cloud& self) {
             return "<pcl_cid.Cloud of " + std::to_string(self.cloud().size()) +
                    " points: " + shown(py::cast(self.names())) + ">";
           })
      .def("keys", &Cloud::names, "Names of the columns, in the order of the file.")
      .def_property_readonly(
          "points",
          &Cloud::points,
          "ndarray of shape (N, 3): x, y and z, metres; a view where "
          "they stand side by side and are metres in the file, too.")
      .def_property_readonly(
          "colors",
          &Cloud::colors,
          "ndarray of uint8, shape (N, 3): red, green and blue; None "
          "where there are none.")
      .def_property_readonly("sensor",
                             &Cloud::sensor,
                             "ndarray of float32, shape (7,): x, y, z of the sensor in "
                             "metres, and its rotation as w, x, y, z.");
  module.def("read",
             &read,
             py::arg("path"),
             py::arg("class_table") = py::none(),
             py::arg("scale") = setting::scale.initial,
             py::arg("mesh_spacing") = setting::mesh_spacing.initial,
             read_doc);
  module.def("write",
             &write,
             py::arg("path"),
             py::arg("cloud"),
             py::arg("encoding") = py::none(),
             write_doc);
}

} // namespace pcl_cid::python
