/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Numbers of binary glTF that its writer and its reader share.
 */

#pragma once

#include <array>
#include <cstdint>

#include <nlohmann/json.hpp>

namespace pcl_cid::gltf {

constexpr std::uint32_t magic = 0x46546C67; // "glTF"
constexpr std::uint32_t version = 2;
constexpr std::uint32_t json_chunk = 0x4E4F534A;   // "JSON"
constexpr std::uint32_t binary_chunk = 0x004E4942; // "BIN"

constexpr int float_type = 5126;
constexpr int unsigned_type = 5125;
constexpr int corner_target = 34962;
constexpr int triangle_target = 34963;

/** Our views: all corners, all triangles. */
constexpr int corner_view = 0;
constexpr int triangle_view = 1;
constexpr std::uint64_t corner_bytes = 3 * sizeof(float);
constexpr std::uint64_t triangle_bytes = 3 * sizeof(std::uint32_t);

/** In glTF y is up: (x, y, z) becomes (x, z, -y); column by column. */
constexpr std::array<int, 16> z_up_to_y_up = {
    1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};

} // namespace pcl_cid::gltf
