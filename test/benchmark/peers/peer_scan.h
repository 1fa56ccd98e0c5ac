/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A labelled scan, as the peers are given it.
 */

#pragma once

#include "../benchmark_cloud.h"

#include <pcl_cid/core/instance_overlaps.h>
#include <pcl_cid/io/cloud_points.h>

#include <cstdint>
#include <string>
#include <vector>

#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl_cid::benchmarks {

/** \brief The finite points of a scan, with their truth and who saw them. */
struct PeerScan {
  LabelledCloud file;
  Cloud::Ptr cloud;
  /** Index in the file of each point. */
  pcl::Indices source;
  /** True instance and class of each point; all of class 1 where the file has no field
   *  `semantic`. */
  PointLabels truth;
  /** Where sensors stood, at least one. */
  std::vector<Eigen::Vector3f> viewpoints;
  /** Whether the file is an image of width x height from its one viewpoint. */
  bool is_organized = false;
};

/** \brief Read a scan with the field `label` and perhaps `semantic`.
 *  \param[in] viewpoints where sensors stood; empty for the one of the file
 *  \throws CIDException when it cannot be read, has no such field, no finite point or
 *  no instance */
PeerScan
readPeerScan(const std::string& path, const std::vector<Eigen::Vector3d>& viewpoints);

/** \brief The file with a label for each of the finite points, 0 for all others.
 *  \param[in] path ends in .pcd or .ply */
void
writeLabels(const PeerScan& scan,
            const std::vector<std::uint32_t>& labels,
            const std::string& path);

} // namespace pcl_cid::benchmarks
