/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Polygon files (.ply) as clouds.
 */

#pragma once

#include <pcl_cid/io/cloud_format.h>

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace pcl_cid {

/** \brief The remark on a PLY with faces. */
constexpr const char* ply_is_mesh =
    "is a mesh, of which the vertices are taken as points; a spacing (--mesh-spacing) "
    "lays points over its faces";

/** \brief The row of PLY in the table of cloud formats. */
CloudFormat
plyFormat();

/** \brief Read the vertices and the camera of a PLY; see CloudFormat::read. */
void
readPLYCloud(std::istream& stream, std::uint64_t size, LabelledCloud& cloud);

/** \brief Read a PLY block by block; see CloudFormat::stream. */
std::unique_ptr<CloudRows>
streamPLYCloud(std::istream& stream,
               std::uint64_t size,
               LabelledCloud& head,
               const ProgressCallback&);

/** \brief Write a PLY block by block. */
CloudPieces
plyPieces();

/** \brief Whether a PLY can hold a cloud; see CloudFormat::check. */
void
checkPLYCloud(const LabelledCloud& cloud, const RemarkCallback& remark);

/** \brief Write a PLY; see CloudFormat::write. */
void
writePLYCloud(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding);

} // namespace pcl_cid
