/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The rows of the table of scene formats.
 */

#pragma once

#include <pcl_cid/io/scene_formats.h>

namespace pcl_cid {

SceneFormat
urdfFormat();

SceneFormat
sdfFormat();

SceneFormat
mjcfFormat();

SceneFormat
moveItFormat();

SceneFormat
gltfFormat();

SceneFormat
usdFormat();

} // namespace pcl_cid
