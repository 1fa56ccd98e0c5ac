/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Uses the installed headers and libraries as a stranger would.
 */

#include <pcl_cid/pcl_cid.h>

#include <iostream>
#include <vector>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace {

/** The four legs of a table, without the table. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
fourPosts()
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const float x : {0.0F, 1.0F})
    for (const float y : {0.0F, 1.0F})
      for (int step = 0; step < 50; ++step)
        cloud->emplace_back(x, y, 0.01F * static_cast<float>(step));
  return cloud;
}

} // namespace

#if PCL_CID_VERSION_NUMBER < 100 // 0.1.0
#error "version.h: its numbers are not those of a release"
#endif

int
main()
{
  std::cout << "pcl_cid " << PCL_CID_VERSION << '\n';
  const auto cloud = fourPosts();

  pcl_cid::CIDSampler<pcl::PointXYZ> sampler;
  sampler.setInputCloud(cloud);
  sampler.setNumberOfSeeds(4);
  pcl::Indices seeds;
  sampler.sample(seeds);
  std::cout << seeds.size() << " seeds\n";

  pcl_cid::CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(cloud);
  abstraction.setNumberOfParts(4);
  std::vector<pcl_cid::ConvexPart> parts;
  abstraction.reconstruct(parts);
  std::cout << parts.size() << " parts\n";
  return seeds.size() == 4 && parts.size() == 4 ? 0 : 1;
}
