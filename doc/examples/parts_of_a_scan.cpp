/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * README's example: a scan in convex parts.
 */

#include <pcl_cid/cid_convex_abstraction.h>

#include <iostream>

#include <pcl/io/pcd_io.h>

int
main(int, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (pcl::io::loadPCDFile(argv[1], *cloud) != 0)
    return 1;
  pcl_cid::CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(cloud);
  abstraction.setSubsample(5000);
  abstraction.setNumberOfParts(30);
  std::vector<pcl_cid::ConvexPart> parts;
  abstraction.reconstruct(parts);
  for (const pcl_cid::ConvexPart& part : parts)
    std::cout << part.indices.size() << " points, " << part.volume << " m^3\n";
  return parts.size() == 30 ? 0 : 1;
}
