/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scan: a prepared scan and its seeds for Python.
 */

#pragma once

#include "scan.h"
#include "settings.h"

namespace pcl_cid::python {

/** \brief Scan with what makes one and changes its seeds. */
void
bindScan(py::module_& module);

/** \brief What follows from the seeds: trees and parts. */
void
bindPartsOfScan(py::class_<Scan, std::shared_ptr<Scan>>& scan);

} // namespace pcl_cid::python
