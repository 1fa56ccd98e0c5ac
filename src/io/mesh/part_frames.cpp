/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts moved between frames.
 */

#include <pcl_cid/io/mesh_export.h>

namespace pcl_cid {

void
moveToFile(const Frame& frame, std::vector<ConvexPart>& parts)
{
  for (ConvexPart& part : parts)
    for (Eigen::Vector3d& vertex : part.hull.vertices)
      vertex = frame.toFile(vertex);
}

} // namespace pcl_cid
