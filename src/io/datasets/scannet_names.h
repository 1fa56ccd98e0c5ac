/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the names of ScanNet's files end with.
 */

#pragma once

namespace pcl_cid {

constexpr const char* scannet_mesh_ending = "_vh_clean_2.ply";
constexpr const char* scannet_segments_ending = "_vh_clean_2.0.010000.segs.json";
constexpr const char* scannet_aggregation_ending = ".aggregation.json";

} // namespace pcl_cid
