/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A point type of the user's own, through PCL_NO_PRECOMPILE.
 */

#define PCL_NO_PRECOMPILE
#include "clouds.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/cid_sampler.h>

#include <gtest/gtest.h>

struct EIGEN_ALIGN16 PointXYZRing {
  PCL_ADD_POINT4D;
  std::uint16_t ring;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(PointXYZRing,
    (float, x, x)(float, y, y)(float, z, z)(std::uint16_t, ring, ring))
// clang-format on

namespace pcl_cid::test {
namespace {

TEST(CustomPointType, GivesWhatPointXYZGives)
{
  const Points points = twoBoxes(300, 111);
  auto cloud = pcl::make_shared<pcl::PointCloud<PointXYZRing>>();
  for (const Eigen::Vector3f& p : points) {
    PointXYZRing point;
    point.getVector3fMap() = p;
    point.ring = 3;
    cloud->push_back(point);
  }
  CIDSampler<pcl::PointXYZ> reference;
  reference.setInputCloud(toCloud(points));
  reference.setNumberOfSeeds(6);
  pcl::Indices expected;
  reference.sample(expected);

  CIDSampler<PointXYZRing> sampler;
  sampler.setInputCloud(cloud);
  sampler.setNumberOfSeeds(6);
  pcl::Indices seeds;
  sampler.sample(seeds);
  EXPECT_EQ(seeds, expected);

  CIDLabelPropagation<PointXYZRing> propagation;
  propagation.setInputCloud(cloud);
  propagation.setSeeds({0, 1}, {1, 2});
  pcl::PointCloud<pcl::PointXYZL> labelled;
  propagation.segment(labelled);
  EXPECT_EQ(labelled[1].label, 2u);

  CIDConvexAbstraction<PointXYZRing> abstraction;
  abstraction.setInputCloud(cloud);
  abstraction.setNumberOfSeeds(6);
  abstraction.setNumberOfParts(2);
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  EXPECT_EQ(parts.size(), 2u);
}

} // namespace
} // namespace pcl_cid::test
