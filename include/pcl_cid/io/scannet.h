/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans of the dataset ScanNet, with their instances and classes.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Paths of the files of a scan of ScanNet; empty for those that do not
 *  exist. */
struct PCL_CID_IO_EXPORT ScannetFiles {
  /** `scene0000_00`. */
  std::string id;
  /** `<id>_vh_clean_2.ply`: the vertices. */
  std::string mesh;
  /** `<id>_vh_clean_2.0.010000.segs.json`: the segment of each vertex. */
  std::string segments;
  /** `<id>.aggregation.json`: the segments and the label of each instance. */
  std::string aggregation;
  /** `scannetv2-labels.combined.tsv`: the nyu40 class of each label. */
  std::string class_table;

  /** \brief All that exist. */
  std::vector<std::string>
  all() const;
};

/** \brief Whether a path is a scan of ScanNet: a folder with a
 *  `<id>_vh_clean_2.ply`. */
PCL_CID_IO_EXPORT bool
isScannetScan(const std::string& path);

/** \brief Find the files of a scan.
 *  \param[in] folder of the scan
 *  \param[in] class_table where the table of classes is; when empty, it is looked for
 *  in the folder and in those above it
 *  \throws CIDException when there is no mesh, or more than one */
PCL_CID_IO_EXPORT ScannetFiles
findScannetFiles(const std::string& folder, const std::string& class_table = "");

/** \brief Read a scan: the vertices of its mesh, in their order.
 *
 *  Fields of the cloud: those of the mesh (x y z rgba), `label` and `semantic`. The
 *  label of a vertex is objectId + 1 of the group that holds its segment; the class is
 *  what the table says about the label of that group (nyu40Classes()). Vertices of no
 *  group have 0 and 0. A segment in two groups belongs to the later one.
 *  \param[in] folder of the scan
 *  \param[in] class_table see findScannetFiles()
 *  \param[in] remark called with one sentence when a scan has no annotation (as in the
 *  hidden test set; the cloud then has no `label` and no `semantic`), when groups share
 *  segments or stand twice, and when segments of groups have no vertex; may be empty
 *  \throws CIDException with the file when one of the annotation's files is missing,
 *  one has another shape than ScanNet's, the number of segment indices is not that of
 *  the vertices, or labels are missing in the table (all are named) */
PCL_CID_IO_EXPORT LabelledCloud
readScannetScan(const std::string& folder,
                const std::string& class_table,
                const RemarkCallback& remark);

} // namespace pcl_cid
