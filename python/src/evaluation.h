/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * evaluate(): scores of instance labels.
 */

#pragma once

#include <pybind11/pybind11.h>

namespace pcl_cid::python {

/** \brief evaluate(). */
void
bindEvaluation(pybind11::module_& module);

} // namespace pcl_cid::python
