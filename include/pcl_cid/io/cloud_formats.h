/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds from and to files, in every format of one table.
 */

#pragma once

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_format.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Read a cloud from a file of any format in the table; which one it is, the
 *  content says.
 *
 *  Stricter than PCL's readers, and silent: whatever does not fit the header is an
 *  error. Of PCD there are ascii, binary and binary_compressed, of PLY ascii and binary
 *  in both byte orders. Fields get the names that PCL gives them: red, green and blue
 *  of a PLY become `rgb` (`rgba` with alpha), nx, ny and nz become `normal_x`,
 *  `normal_y` and `normal_z`. The pose and the width and height of a PLY are those of
 *  its `camera` element, where PCL writes them; a list that is equally long for all
 *  vertices is a field with several values. Faces of a PLY are passed over, and so is
 *  padding (fields named `_`). What else is passed over, `remarks` says: fields with
 *  COUNT 0, lists whose length varies, zeros up to 4096 bytes after the points of a
 *  PCD. Lines may end in CR, LF or both; a byte order mark may come first.
 *  \param[in] path "-" is the standard input
 *  \param[in] extension of the format that the file has, with the dot, whatever its
 *  name and content say; empty: they say it
 *  \throws CIDException when the file cannot be opened, is empty, truncated, damaged or
 *  of no format in the table, holds no point or more than its header says, has two
 *  fields of one name, or has no single x, y and z */
PCL_CID_IO_EXPORT LabelledCloud
readCloud(const std::string& path, const std::string& extension = "");

/** \brief The layout in which a cloud is written to a file of this name.
 *
 *  The extension says the format; a cloud for the standard output, "-", keeps that
 *  of \a source where it can be written, and becomes a PCD else. Where that is the
 *  format that the cloud came in, the encoding stays; ascii stays ascii; all else
 *  becomes the most compact encoding: compressed for `.pcd`, binary for `.ply`.
 *  \param[in] path its extension may be in capitals
 *  \param[in] source the layout that the cloud came in
 *  \throws CIDException when no format that can be written has this extension */
PCL_CID_IO_EXPORT CloudLayout
layoutFor(const std::string& path, const CloudLayout& source);

/** \brief Refuse a cloud that cannot be written to a file of this name: to be called
 *  before any work that its output would waste.
 *  \param[in] remark called with one sentence for each thing that the file will hold in
 *  another way than the cloud; may be empty
 *  \throws CIDException when no format that can be written has this extension, when a
 *  name of a field is empty, "_", holds a blank or is there twice, and for 8-byte
 *  integers that double does not hold exactly in PLY, which has no type for them */
PCL_CID_IO_EXPORT void
requireWritable(const LabelledCloud& cloud,
                const std::string& path,
                const RemarkCallback& remark = {});

/** \brief Write a cloud. Look at the state of the stream afterwards to see whether it
 *  worked, or write through OutputFiles.
 *
 *  PCD keeps every bit of every field. In ascii, `rgb` of type F is written as type U,
 *  as PCL does. PLY has the names that readCloud() reads, one property for each value
 *  of a field with several, 8 bits for each color (so `rgb` loses its unused fourth
 *  byte), double for 8-byte integers, and the pose as axes.
 *  \throws CIDException when the layout is none that can be written, and where
 *  requireWritable() does */
PCL_CID_IO_EXPORT void
writeCloud(std::ostream& stream, const LabelledCloud& cloud, const CloudLayout& layout);

/** \brief All formats: PCD, PLY, then those that were registered. */
PCL_CID_IO_EXPORT std::vector<CloudFormat>
cloudFormats();

/** \brief The format with the extension of this file, whether the file exists or not;
 *  null when there is none. The row stays where it is as long as the program runs. */
PCL_CID_IO_EXPORT const CloudFormat*
findCloudFormat(const std::string& path);

/** \brief Names of the formats that can be read: "PCD", "PLY". */
PCL_CID_IO_EXPORT std::vector<std::string>
readableCloudNames();

/** \brief Extensions of the formats that can be written: ".pcd", ".ply". */
PCL_CID_IO_EXPORT std::vector<std::string>
writableCloudExtensions();

/** \brief Add a format for as long as the program runs: readCloud(), layoutFor(),
 *  writeCloud() and readScan() know it from then on. Any thread may call this.
 *  \throws CIDException when its name or one of its extensions is taken or no good, or
 *  when it has neither a reader nor a writer, or a writer without encodings */
PCL_CID_IO_EXPORT void
registerCloudFormat(CloudFormat format);

} // namespace pcl_cid
