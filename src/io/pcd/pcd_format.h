/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Point cloud files of the Point Cloud Library (.pcd), version 0.7 and older.
 */

#pragma once

#include <pcl_cid/io/cloud_format.h>

#include <cstdint>
#include <iosfwd>
#include <memory>

namespace pcl_cid {

/** \brief The row of PCD in the table of cloud formats. */
CloudFormat
pcdFormat();

/** \brief Read a PCD; see CloudFormat::read. */
void
readPCD(std::istream& stream, std::uint64_t size, LabelledCloud& cloud);

/** \brief Read a PCD block by block; see CloudFormat::stream. */
std::unique_ptr<CloudRows>
streamPCD(std::istream& stream,
          std::uint64_t size,
          LabelledCloud& head,
          const ProgressCallback&);

/** \brief Write a PCD block by block. */
CloudPieces
pcdPieces();

/** \brief Write a PCD; see CloudFormat::write. */
void
writePCD(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding);

} // namespace pcl_cid
