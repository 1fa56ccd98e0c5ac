/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Arrays of numpy: checked on their way in, views on their way out.
 */

#pragma once

#include "errors.h"

#include <pcl_cid/core/color.h>
#include <pcl_cid/core/point_set.h>

#include <cstdint>
#include <memory>
#include <vector>

#include <pybind11/numpy.h>

namespace pcl_cid::python {

/** \brief Points as they were given: (N, 3), C-contiguous, of float32 or float64, which
 *  whole numbers become. Copied only where they were not that already. Points that are
 *  not finite stay.
 *  \throws ValueError, with \a name, for anything else, and for no point at all */
py::array
pointsOf(const py::object& given, const char* name);

/** \brief Finite positions, (K, 3), or (3,) for one.
 *  \throws ValueError */
std::vector<Eigen::Vector3d>
positionsOf(const py::object& given, const char* name);

/** \brief Indices of points, (K,), or a single one.
 *  \param[in] size 0 to size - 1 are allowed
 *  \throws ValueError */
pcl::Indices
indicesOf(const py::object& given, const char* name, std::size_t size);

/** \brief Labels or classes, (N,): whole numbers, 0 to 4294967295.
 *  \throws ValueError */
std::vector<std::uint32_t>
labelsOf(const py::object& given, const char* name);

/** \brief The same, one for each of \a size \a things. */
std::vector<std::uint32_t>
labelsOf(const py::object& given,
         const char* name,
         std::size_t size,
         const char* things);

/** \brief Colors, (N, 3): uint8, or floats from 0 to 1.
 *  \throws ValueError */
std::vector<ColorRGB>
colorsOf(const py::object& given, std::size_t size);

/** \brief The array, read-only from now on. */
py::array
readOnly(py::array array);

/** \brief A read-only array on values that live as long as the array. */
template <typename Value>
py::array
viewOf(std::shared_ptr<const std::vector<Value>> values)
{
  auto owner = std::make_unique<std::shared_ptr<const std::vector<Value>>>(values);
  const py::capsule keeper(owner.get(), [](void* kept) {
    delete static_cast<std::shared_ptr<const std::vector<Value>>*>(kept);
  });
  owner.release();
  return readOnly(py::array_t<Value>(
      static_cast<py::ssize_t>(values->size()), values->data(), keeper));
}

/** \brief A read-only array that owns the values. */
template <typename Value>
py::array
arrayOf(std::vector<Value> values)
{
  return viewOf(std::make_shared<const std::vector<Value>>(std::move(values)));
}

} // namespace pcl_cid::python
