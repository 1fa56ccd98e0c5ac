/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan from wherever it comes: a file, or a folder of a dataset.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief What readScan() may need besides a path. */
struct ScanOptions {
  /** ScanNet's `scannetv2-labels.combined.tsv`; when empty, it is looked for in the
   *  folder of the scan and in those above it. */
  std::string class_table;
  /** Called with one sentence, with file and line, for each thing that was repaired,
   *  left out or assumed; may be empty. */
  RemarkCallback remark;
  /** LabelledCloud::scale, setting::scale. */
  double scale = setting::scale.initial;
  /** Spacing of the points that are laid over the surface of a mesh, in the unit of the
   *  file, setting::mesh_spacing; 0: for about 200,000 points. A PLY is a mesh only
   *  where this is given. */
  double mesh_spacing = setting::mesh_spacing.initial;
  /** Extension of the format that a file has, with the dot, whatever its name and
   *  content say: one of scanExtensions(). Empty: they say it. */
  std::string extension = {};
};

/** \brief Whether a path is a folder that readScan() reads: a room of S3DIS or a scan
 *  of ScanNet. */
PCL_CID_IO_EXPORT bool
isScanFolder(const std::string& path);

/** \brief Whether a path is, by its name, something that readScan() reads: a folder as
 *  above, or a file with the extension of a cloud format (see cloudFormats()). To find
 *  the scans in a folder. */
PCL_CID_IO_EXPORT bool
isScan(const std::string& path);

/** \brief How names of files that readScan() reads end: those of cloud formats and
 *  meshes, and ".gz". */
PCL_CID_IO_EXPORT std::vector<std::string>
scanExtensions();

/** \brief Names of the datasets whose folders readScan() reads: "S3DIS", "ScanNet". */
PCL_CID_IO_EXPORT std::vector<std::string>
datasetNames();

/** \brief Read a file of any cloud format (readCloud()), a mesh
 *  (readSurfaceAsCloud()), a room of S3DIS (readS3DISRoom()) or a scan of ScanNet
 *  (readScannetScan()).
 *  \throws CIDException when it is none of them, cannot be read, is no scan of ScanNet
 *  although a class table is given, or no mesh although a spacing is */
PCL_CID_IO_EXPORT LabelledCloud
readScan(const std::string& path, const ScanOptions& options = {});

/** \brief The files that readScan() reads, as far as they exist: they must never be
 *  written over. */
PCL_CID_IO_EXPORT std::vector<std::string>
scanFiles(const std::string& path, const std::string& class_table = "");

/** \brief What to call a scan: the id of a scan of ScanNet, the folder of a room, the
 *  file without its extension (nor ".gz"), `standard_input` for "-". */
PCL_CID_IO_EXPORT std::string
scanName(const std::string& path);

} // namespace pcl_cid
