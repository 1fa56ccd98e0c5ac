/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds as files hold them: columns by name.
 */

#include "cloud.h"

#include "settings.h"

#include <pcl_cid/io/float_field.h>

#include <array>
#include <cmath>
#include <cstring>

namespace pcl_cid::python {
namespace {

py::dtype
dtypeOf(std::uint8_t datatype)
{
  switch (datatype) {
  case pcl::PCLPointField::BOOL:
    return py::dtype::of<bool>();
  case pcl::PCLPointField::INT8:
    return py::dtype::of<std::int8_t>();
  case pcl::PCLPointField::UINT8:
    return py::dtype::of<std::uint8_t>();
  case pcl::PCLPointField::INT16:
    return py::dtype::of<std::int16_t>();
  case pcl::PCLPointField::UINT16:
    return py::dtype::of<std::uint16_t>();
  case pcl::PCLPointField::INT32:
    return py::dtype::of<std::int32_t>();
  case pcl::PCLPointField::UINT32:
    return py::dtype::of<std::uint32_t>();
  case pcl::PCLPointField::INT64:
    return py::dtype::of<std::int64_t>();
  case pcl::PCLPointField::UINT64:
    return py::dtype::of<std::uint64_t>();
  case pcl::PCLPointField::FLOAT32:
    return py::dtype::of<float>();
  default:
    return py::dtype::of<double>();
  }
}

const pcl::PCLPointField*
find(const LabelledCloud& cloud, const std::string& name)
{
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    if (field.name == name)
      return &field;
  return nullptr;
}

bool
standSideBySide(const pcl::PCLPointField& a, const pcl::PCLPointField& b)
{
  const auto size = static_cast<std::uint32_t>(dtypeOf(a.datatype).itemsize());
  return a.datatype == b.datatype && a.count == 1 && b.count == 1 &&
         b.offset == a.offset + size;
}

/** Of a sequence; empty where it is none, or not of numbers. */
std::vector<double>
numbersOf(const py::object& given)
{
  std::vector<double> numbers;
  if (!py::isinstance<py::sequence>(given) && !py::isinstance<py::array>(given))
    return numbers;
  for (const py::handle each : given) {
    const std::optional<double> number = realNumber(each);
    if (!number)
      return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/** One float for each point. */
std::vector<float>
floatsOf(const py::array& array, const std::string& name, std::size_t size)
{
  const auto values =
      py::array_t<float, py::array::c_style | py::array::forcecast>(array);
  if (values.ndim() != 1 || static_cast<std::size_t>(values.size()) != size)
    refuse("the field '",
           name,
           "' is given the shape ",
           shown(array.attr("shape")),
           "; it must be (",
           size,
           ",), one for each point");
  return {values.data(), values.data() + values.size()};
}

} // namespace

Cloud::Cloud(LabelledCloud cloud)
: cloud_(std::make_shared<const LabelledCloud>(std::move(cloud)))
{
}

std::vector<std::string>
Cloud::names() const
{
  std::vector<std::string> names;
  for (const pcl::PCLPointField& field : cloud_->fields.fields)
    names.push_back(field.name);
  return names;
}

py::array
Cloud::viewOf(std::vector<py::ssize_t> shape,
              const pcl::PCLPointField& field,
              py::ssize_t step) const
{
  const py::dtype dtype = dtypeOf(field.datatype);
  std::vector<py::ssize_t> strides{step, dtype.itemsize()};
  strides.resize(shape.size());
  auto owner = std::make_unique<std::shared_ptr<const LabelledCloud>>(cloud_);
  const py::capsule keeper(owner.get(), [](void* kept) {
    delete static_cast<std::shared_ptr<const LabelledCloud>*>(kept);
  });
  owner.release();
  return readOnly(py::array(
      dtype, shape, strides, cloud_->fields.data.data() + field.offset, keeper));
}

py::array
Cloud::column(const std::string& name) const
{
  const pcl::PCLPointField* const field = find(*cloud_, name);
  if (field == nullptr) {
    std::string known;
    for (const std::string& each : names())
      known += (known.empty() ? "" : ", ") + each;
    throw py::key_error("there is no field '" + name + "'; there are " + known);
  }
  const auto size = static_cast<py::ssize_t>(cloud_->size());
  const auto step = static_cast<py::ssize_t>(cloud_->fields.point_step);
  if (field->count <= 1)
    return viewOf({size}, *field, step);
  return viewOf({size, static_cast<py::ssize_t>(field->count)}, *field, step);
}

py::array
Cloud::points() const
{
  const py::array in_file = pointsOfFile();
  if (cloud_->scale == 1.0)
    return in_file;
  return py::object(in_file.attr("__mul__")(cloud_->scale));
}

py::array
Cloud::pointsOfFile() const
{
  const auto* const x = find(*cloud_, "x");
  const auto* const y = find(*cloud_, "y");
  const auto* const z = find(*cloud_, "z");
  if (x && y && z && standSideBySide(*x, *y) && standSideBySide(*y, *z))
    return viewOf({static_cast<py::ssize_t>(cloud_->size()), 3},
                  *x,
                  static_cast<py::ssize_t>(cloud_->fields.point_step));
  return py::module_::import("numpy").attr("stack")(
      py::make_tuple(column("x"), column("y"), column("z")), py::arg("axis") = 1);
}

py::object
Cloud::colors() const
{
  if (!hasColors(*cloud_))
    return py::none();
  const auto colors =
      std::make_shared<const std::vector<ColorRGB>>(pcl_cid::colorsOf(*cloud_));
  static_assert(sizeof(ColorRGB) == 3, "rows of an array of bytes");
  py::array_t<std::uint8_t> array(
      {static_cast<py::ssize_t>(colors->size()), py::ssize_t{3}});
  std::memcpy(array.mutable_data(), colors->data(), 3 * colors->size());
  return array;
}

py::array
Cloud::sensor() const
{
  const Eigen::Vector4f p = cloud_->sensor_origin * static_cast<float>(cloud_->scale);
  const Eigen::Quaternionf& q = cloud_->sensor_orientation;
  return arrayOf(std::vector<float>{p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
}

void
Cloud::setColumn(const std::string& name, const py::object& values)
{
  const py::array array = py::module_::import("numpy").attr("asarray")(values);
  LabelledCloud changed = *cloud_;
  blamingValues([&] {
    if (array.dtype().kind() == 'f')
      setFloats(floatsOf(array, name, changed.size()), name, changed);
    else {
      const std::string labels = "values of the field '" + name + "'";
      setLabels(labelsOf(values, labels.c_str(), changed.size(), "points"),
                LabelType::U4,
                changed,
                name);
    }
  });
  cloud_ = std::make_shared<const LabelledCloud>(std::move(changed));
}

LabelledCloud
cloudOf(const py::array& points, const std::string& name)
{
  LabelledCloud cloud;
  cloud.name = name;
  const auto size = static_cast<std::uint32_t>(points.itemsize());
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    pcl::PCLPointField field;
    field.name = "xyz"[axis];
    field.offset = axis * size;
    field.datatype = size == sizeof(float) ? pcl::PCLPointField::FLOAT32
                                           : pcl::PCLPointField::FLOAT64;
    field.count = 1;
    cloud.fields.fields.push_back(field);
  }
  cloud.fields.height = 1;
  cloud.fields.width = static_cast<std::uint32_t>(points.shape(0));
  cloud.fields.point_step = 3 * size;
  cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
  const auto* const bytes = static_cast<const std::uint8_t*>(points.data());
  cloud.fields.data.assign(bytes, bytes + points.nbytes());
  return cloud;
}

void
setSensor(const py::object& sensor, LabelledCloud& cloud)
{
  if (sensor.is_none())
    return;
  const std::vector<double> values = numbersOf(sensor);
  if (values.size() != 3 && values.size() != 7)
    refuse("the sensor is ",
           shown(sensor),
           "; it must be x, y, z, or these and a rotation as w, x, y, z");
  std::array<float, 7> v{0.0f, 0.0f, 0.0f, 1.0f};
  for (std::size_t i = 0; i < values.size(); ++i) {
    v[i] = static_cast<float>(values[i]);
    if (!std::isfinite(v[i]))
      refuse("the sensor is ", shown(sensor), "; its values must be finite");
  }
  cloud.sensor_origin = {v[0], v[1], v[2], 0.0f};
  cloud.sensor_orientation = Eigen::Quaternionf(v[3], v[4], v[5], v[6]);
}

void
Remarks::warn() const
{
  for (const std::string& sentence : sentences_)
    if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), 2) != 0)
      throw py::error_already_set();
}

} // namespace pcl_cid::python
