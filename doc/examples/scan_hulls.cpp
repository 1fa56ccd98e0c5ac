/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan from a file, and its convex hulls.
 */

#include "scan_hulls.h"

#include <pcl_cid/cid_convex_abstraction.h>

#include <algorithm>
#include <stdexcept>

#include <pcl/common/point_tests.h>
#include <pcl/io/pcd_io.h>

namespace planning {

Cloud::Ptr
loadFinitePoints(const std::string& path)
{
  Cloud loaded;
  if (pcl::io::loadPCDFile(path, loaded) != 0)
    throw std::runtime_error("it cannot be read as a PCD file");
  auto scan = pcl::make_shared<Cloud>();
  for (const pcl::PointXYZ& point : loaded)
    if (pcl::isFinite(point))
      scan->push_back(point);
  if (scan->empty())
    throw std::runtime_error("it has no finite point");
  return scan;
}

std::vector<pcl_cid::ConvexPart>
hullsOf(const Cloud::ConstPtr& scan, const HullOptions& options)
{
  pcl_cid::CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(scan);
  abstraction.setNumberOfParts(options.number_of_parts);
  abstraction.setMergingRule(options.merging);
  // By hull:
  abstraction.setRobotRadius(options.robot_radius);
  if (options.has_one_view)
    abstraction.setViewpoints({Eigen::Vector3d::Zero()});
  // By CID:
  abstraction.setSubsample(20000); // for speed; hulls contain the other points, too
  abstraction.setNumberOfSeeds(2 * options.number_of_parts); // what is merged
  abstraction.setStopAtCut(true);
  std::vector<pcl_cid::ConvexPart> parts;
  abstraction.reconstruct(parts);
  return parts;
}

double
toleranceOf(const std::vector<pcl_cid::ConvexPart>& parts)
{
  double tolerance = 0.0;
  for (const pcl_cid::ConvexPart& part : parts) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : part.hull.vertices)
      box.extend(vertex);
    tolerance = std::max(tolerance, pcl_cid::hull_tolerance * box.diagonal().norm());
  }
  return tolerance;
}

Eigen::AlignedBox3d
boxOf(const Cloud& scan)
{
  Eigen::AlignedBox3d box;
  for (const pcl::PointXYZ& point : scan)
    box.extend(point.getVector3fMap().cast<double>());
  return box;
}

} // namespace planning
