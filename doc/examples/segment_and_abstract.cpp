/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * README's example: a scan labelled by convex groups, and as 30 convex hulls.
 */

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/cid_label_propagation.h>

#include <iostream>
#include <vector>

#include <pcl/io/pcd_io.h>

namespace {

void
segmentAndAbstract(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  pcl_cid::CIDLabelPropagation<pcl::PointXYZ> propagation;
  propagation.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZL> labelled;
  propagation.segment(labelled);
  pcl::io::savePCDFileBinaryCompressed("labelled.pcd", labelled);

  pcl_cid::CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(cloud);
  abstraction.setNumberOfParts(30);
  std::vector<pcl_cid::ConvexPart> parts;
  abstraction.reconstruct(parts);
  for (const pcl_cid::ConvexPart& part : parts)
    std::cout << part.indices.size() << " points, " << part.volume << " m^3\n";
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "Usage: segment_and_abstract SCAN.pcd\n";
    return 1;
  }
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << argv[1] << ": cannot be read as a PCD file\n";
    return 1;
  }
  try {
    segmentAndAbstract(cloud);
  }
  catch (const pcl_cid::CIDException& error) {
    std::cerr << argv[1] << ": " << error.what() << '\n';
    return 1;
  }
  catch (const pcl::IOException& error) {
    std::cerr << "labelled.pcd: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
