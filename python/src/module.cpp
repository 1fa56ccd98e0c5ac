/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The module: what pcl_cid/__init__.py gives to users.
 */

#include "cids.h"
#include "cloud.h"
#include "errors.h"
#include "evaluation.h"
#include "gil.h"
#include "merge_tree.h"
#include "parts.h"
#include "scan_binding.h"
#include "settings.h"

#include <pcl_cid/version.h>

PYBIND11_MODULE(_pcl_cid, module)
{
  using namespace pcl_cid::python;
  module.doc() = "Concavity-Induced Distance for point clouds.";
  module.attr("__version__") = PCL_CID_VERSION;
  py::options options;
  options.disable_function_signatures();
  letTheEndWait();
  bindErrors(module);
  bindSettings(module);
  bindClouds(module);
  bindMergeTree(module);
  bindParts(module);
  bindScan(module);
  bindCids(module);
  bindEvaluation(module);
}
