/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * README's example: a scan is prepared once; labels, a correction, and hulls share it.
 */

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/pcl_cid.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <pcl/io/pcd_io.h>

namespace {

/** Where an annotator would click; here, the point that is farthest from its seed in
 *  CID. A CID of NaN (the point is not finite) never compares as larger. */
pcl::index_t
pointToCorrect(const std::vector<float>& cid)
{
  std::size_t farthest = 0;
  float largest = -1.0f;
  for (std::size_t i = 0; i < cid.size(); ++i)
    if (cid[i] > largest) {
      farthest = i;
      largest = cid[i];
    }
  return static_cast<pcl::index_t>(farthest);
}

void
saveHulls(const std::string& path, const std::vector<pcl_cid::ConvexPart>& parts)
{
  std::ofstream file(path, std::ios::binary);
  pcl_cid::writePLY(file, parts);
  if (!file.flush())
    throw pcl::IOException("cannot be written", path.c_str());
}

void
segmentAndAbstract(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  pcl_cid::CIDSampler<pcl::PointXYZ> sampler;
  sampler.setInputCloud(cloud);
  pcl::Indices seeds;
  sampler.sample(seeds); // prepares the scan; nothing below does so again

  pcl_cid::CIDLabelPropagation<pcl::PointXYZ> propagation;
  propagation.setInputCloud(cloud);
  propagation.setGrouping(sampler.getGrouping());
  pcl::PointCloud<pcl::PointXYZL> labelled;
  propagation.segment(labelled); // without labels of its own, seed k has label k + 1

  const pcl::index_t wrong = pointToCorrect(sampler.getProposal().cid);
  propagation.addSeeds({wrong}, {1000}); // a corrective seed, with a label of its own
  propagation.segment(labelled);
  pcl::io::savePCDFileBinaryCompressed("labelled.pcd", labelled);

  pcl_cid::CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(cloud);
  abstraction.setGrouping(propagation.getGrouping());
  abstraction.setNumberOfParts(30);
  std::vector<pcl_cid::ConvexPart> parts;
  abstraction.reconstruct(parts);
  saveHulls("hulls.ply", parts);
  std::cout << seeds.size() << " seeds and 1 corrective one, " << parts.size()
            << " hulls\n";
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
    std::cerr << "an output: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
