/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Merge trees: Algorithm 2 for Python.
 */

#pragma once

#include "settings.h"

#include <pcl_cid/core/group_merging.h>

namespace pcl_cid::python {

/** \brief Where to cut a tree, as far as it is said: at most one of the three.
 *  \throws ValueError */
MergeCut
mergeCutOf(const py::object& count,
           const py::object& threshold,
           const py::object& merges);

/** \brief MergeTree. */
void
bindMergeTree(py::module_& module);

} // namespace pcl_cid::python
