/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points of voxels of a file, with all their fields, and what follows them.
 */

#include "cloud_files.h"

#include <pcl_cid/io/cloud_blocks.h>
#include <pcl_cid/io/voxel_cloud.h>

#include <numeric>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr double no_coordinate = std::numeric_limits<double>::quiet_NaN();

/** What is left of the coordinates of a cloud. */
VoxelPoints::Block
countingPoints(const LabelledCloud& cloud, bool keep_zeros)
{
  const CloudPoints points = pointsOf(cloud, {keep_zeros, {}});
  const FileCoordinates coordinates(cloud);
  VoxelPoints::Block block;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    block.push_back((*points.points)[i].getVector3fMap().allFinite()
                        ? coordinates[i]
                        : Eigen::Vector3d::Constant(no_coordinate));
  return block;
}

class VoxelCloudOf : public testing::Test {
protected:
  /** The points of the file in blocks are those of VoxelPoints in one. */
  void
  expectAsOneBlock(const LabelledCloud& cloud, double size, bool keep_zeros = false)
  {
    saveCloud(path_, cloud, pcd_binary);
    const VoxelPoints::Block points = countingPoints(cloud, keep_zeros);
    VoxelPoints expected(size);
    expected.add(points);
    expected.choose(points);
    expected.finish();
    for (const std::size_t most :
         {std::size_t{1}, std::size_t{11}, std::size_t{65536}}) {
      CloudBlockReader reader(path_, "", cloud.scale, most);
      VoxelOptions options;
      options.size = size;
      options.points.keep_zeros = keep_zeros;
      const VoxelCloud voxels(reader, options);
      EXPECT_EQ(voxels.source(), expected.source());
      EXPECT_EQ(voxels.finite(), pointsOf(cloud, {keep_zeros, {}}).finite);
      expectRowsOf(cloud, voxels);
      EXPECT_EQ(followsIn(reader, voxels), expected.follow(points));
    }
  }

  static void
  expectRowsOf(const LabelledCloud& cloud, const VoxelCloud& voxels)
  {
    const pcl::PCLPointCloud2& chosen = voxels.cloud().fields;
    const std::size_t step = cloud.fields.point_step;
    ASSERT_EQ(voxels.cloud().size(), voxels.source().size());
    ASSERT_EQ(chosen.data.size(), step * voxels.source().size());
    EXPECT_EQ(chosen.height, 1u);
    EXPECT_EQ(voxels.cloud().sensor_origin, cloud.sensor_origin);
    for (std::size_t k = 0; k < voxels.source().size(); ++k) {
      const auto row = static_cast<std::size_t>(voxels.source()[k]);
      EXPECT_TRUE(std::equal(
          chosen.data.begin() + static_cast<std::ptrdiff_t>(k * step),
          chosen.data.begin() + static_cast<std::ptrdiff_t>((k + 1) * step),
          cloud.fields.data.begin() + static_cast<std::ptrdiff_t>(row * step)));
    }
  }

  static pcl::Indices
  followsIn(CloudBlockReader& reader, const VoxelCloud& voxels)
  {
    pcl::Indices all;
    voxels.follow(reader, [&](const LabelledCloud& block, const pcl::Indices& follows) {
      EXPECT_EQ(block.size(), follows.size());
      all.insert(all.end(), follows.begin(), follows.end());
    });
    return all;
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("scan.pcd");
};

/** The desk scan with points at a place, spread over it. */
LabelledCloud
deskWith(std::size_t count, const Eigen::Vector3f& place)
{
  LabelledCloud cloud = deskScan();
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(cloud.fields.data.data() + (7 + 13 * i) * cloud.fields.point_step,
                place.data(),
                3 * sizeof(float));
  return cloud;
}

TEST_F(VoxelCloudOf, TheDeskHasItsRows)
{
  for (const double size : {0.03, 0.2, 100.0})
    expectAsOneBlock(deskScan(), size);
}

TEST_F(VoxelCloudOf, AScaleMakesMetres)
{
  LabelledCloud cloud = deskScan();
  cloud.scale = 0.001;
  expectAsOneBlock(cloud, 0.0002);
}

TEST_F(VoxelCloudOf, WhatDidNotReturnIsLeftOut)
{
  for (const std::size_t count : {1u, 9u, 10u, 50u})
    for (const bool keep_zeros : {false, true}) {
      SCOPED_TRACE(count);
      expectAsOneBlock(deskWith(count, Eigen::Vector3f::Zero()), 0.3, keep_zeros);
      expectAsOneBlock(
          deskWith(count, deskScan().sensor_origin.head<3>()), 0.3, keep_zeros);
    }
}

TEST_F(VoxelCloudOf, AllAtOnePlaceAreOneVoxel)
{
  LabelledCloud cloud = threePoints();
  for (const Eigen::Vector3f& place :
       {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1, 2, 3)}) {
    cloud.fields.width = 40;
    cloud.fields.row_step = 40 * cloud.fields.point_step;
    cloud.fields.data.assign(cloud.fields.row_step, 0);
    for (std::size_t i = 0; i < 40; ++i)
      std::memcpy(cloud.fields.data.data() + i * cloud.fields.point_step,
                  place.data(),
                  3 * sizeof(float));
    expectAsOneBlock(cloud, 0.5);
  }
}

TEST_F(VoxelCloudOf, RemarksAreThoseOfTheWhole)
{
  const LabelledCloud cloud = deskWith(20, Eigen::Vector3f::Zero());
  saveCloud(path_, cloud, pcd_binary);
  std::vector<std::string> expected;
  pointsOf(readCloud(path_),
           {false, [&](const std::string& s) { expected.push_back(s); }});
  std::vector<std::string> remarks;
  CloudBlockReader reader(path_);
  VoxelOptions options;
  options.size = 0.1;
  options.points.remark = [&](const std::string& s) { remarks.push_back(s); };
  const VoxelCloud voxels(reader, options);
  EXPECT_EQ(remarks, expected);
  EXPECT_EQ(remarks.size(), 1u);
}

TEST_F(VoxelCloudOf, BadPointsAreRefusedAsInTheWhole)
{
  LabelledCloud none = threePoints();
  const float not_finite = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < none.size(); ++i)
    std::memcpy(none.fields.data.data() + i * none.fields.point_step,
                &not_finite,
                sizeof(not_finite));
  saveCloud(path_, none, pcd_binary);
  VoxelOptions options;
  options.size = 0.1;
  const auto complaint = [&] {
    return complaintAbout(path_, [&] {
      CloudBlockReader reader(path_);
      const VoxelCloud voxels(reader, options);
    });
  };
  EXPECT_EQ(complaint(), ": none of its 3 points is finite; at least 1 must be");
  saveCloud(path_, deskWith(30, {1e16f, 0, 0}), pcd_binary);
  EXPECT_EQ(complaint(), complaintAbout(path_, [&] { pointsOf(readCloud(path_)); }));
}

TEST_F(VoxelCloudOf, CanBeCancelled)
{
  saveCloud(path_, deskScan(), pcd_binary);
  for (const double last : {0.2, 0.7}) {
    CloudBlockReader reader(path_, "", setting::scale.initial, 100);
    VoxelOptions options;
    options.size = 0.1;
    double told = 0.0;
    options.execution.progress = [&](double fraction) {
      EXPECT_GE(fraction, told);
      told = fraction;
      return fraction < last;
    };
    EXPECT_THROW(VoxelCloud(reader, options), CIDCancelled);
    EXPECT_LT(told, last + 0.1);
  }
}

} // namespace
} // namespace pcl_cid::test
