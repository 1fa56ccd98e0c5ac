/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds as files hold them: columns by name.
 */

#pragma once

#include "arrays.h"

#include <pcl_cid/io/cloud_format.h>
#include <pcl_cid/io/labelled_cloud.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_cid::python {

/** \brief A cloud with named columns. Columns are views that keep the values they were
 *  made of: a change makes a new cloud inside. */
class Cloud {
public:
  explicit Cloud(LabelledCloud cloud);

  const LabelledCloud&
  cloud() const
  {
    return *cloud_;
  }

  std::vector<std::string>
  names() const;

  /** \brief (N,), or (N, count) for a field of several values.
   *  \throws KeyError that lists the names */
  py::array
  column(const std::string& name) const;

  /** \brief (N, 3) of x, y and z, metres: a view where they stand side by side and are
   *  metres in the file, too. */
  py::array
  points() const;

  /** \brief (N, 3) of uint8, or None. */
  py::object
  colors() const;

  /** \brief (7,): position, and rotation as w, x, y, z. */
  py::array
  sensor() const;

  /** \brief Whole numbers become a field of uint32, floats one of float32.
   *  \throws ValueError */
  void
  setColumn(const std::string& name, const py::object& values);

private:
  /** \brief points() in the unit of the file. */
  py::array
  pointsOfFile() const;

  py::array
  viewOf(std::vector<py::ssize_t> shape,
         const pcl::PCLPointField& field,
         py::ssize_t step) const;

  std::shared_ptr<const LabelledCloud> cloud_;
};

/** \brief A cloud of points alone.
 *  \param[in] points as pointsOf() gives them
 *  \param[in] name for messages */
LabelledCloud
cloudOf(const py::array& points, const std::string& name);

/** \brief Give a cloud a sensor: None leaves it at the origin, upright.
 *  \param[in] sensor (3,) position, or (7,) with the rotation as w, x, y, z
 *  \throws ValueError */
void
setSensor(const py::object& sensor, LabelledCloud& cloud);

/** \brief What the library has to remark, to become warnings of Python once the GIL is
 *  there. */
class Remarks {
public:
  RemarkCallback
  callback()
  {
    return [this](const std::string& sentence) { sentences_.push_back(sentence); };
  }

  /** \throws the warning, where the user makes errors of them */
  void
  warn() const;

private:
  std::vector<std::string> sentences_;
};

/** \brief Cloud, read() and write(). */
void
bindClouds(py::module_& module);

} // namespace pcl_cid::python
