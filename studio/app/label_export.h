/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The labels of a session in the formats of others.
 */

#pragma once

#include "exported_files.h"

#include <pcl_cid/core/label_session.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/labelled_cloud.h>

#include <string>
#include <vector>

namespace pcl_cid::studio {

/** \brief Writes the labels of sessions of one scan into one folder. */
class LabelExporter {
public:
  /** \param[in] cloud,points must outlive this
   *  \param[in] inputs files that are never written over
   *  \param[in] folder where files go
   *  \param[in] name what they are called where nothing else is asked for: "room" */
  LabelExporter(const LabelledCloud& cloud,
                const CloudPoints& points,
                std::vector<std::string> inputs,
                std::string folder,
                std::string name);

  /** \brief Write all files of a format, or none.
   *  \param[in] format `pcd`, `ply`, `seeds`, `scannet`, `s3dis`, `kitti`
   *  \param[in] name of the file, or of the folder for those that are one; without
   *  folders; empty: the name of the scan
   *  \param[in] clean_up see LabelSession::cleanedLabels()
   *  \throws CIDException when there is no such format, the name has a folder, or
   *  writing fails */
  ExportedFiles
  write(const LabelSession& session,
        const std::string& format,
        const std::string& name,
        bool clean_up,
        const ExecutionOptions& execution) const;

private:
  const LabelledCloud& cloud_;
  const CloudPoints& points_;
  std::vector<std::string> inputs_;
  std::string folder_;
  std::string name_;
};

} // namespace pcl_cid::studio
