/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The rows of the table of mesh formats.
 */

#pragma once

#include <pcl_cid/io/mesh_formats.h>

namespace pcl_cid {

MeshFormat
objFormat();

MeshFormat
plyMeshFormat();

MeshFormat
stlFormat();

} // namespace pcl_cid
