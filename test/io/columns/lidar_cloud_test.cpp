/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans of KITTI and nuScenes.
 */

#include "cloud_files.h"

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

void
writeFloats(const std::string& path, const std::vector<float>& values)
{
  writeText(path,
            std::string(reinterpret_cast<const char*>(values.data()),
                        values.size() * sizeof(float)));
}

/** Points with this many values each, the last a ring where there are five. */
std::vector<float>
lidarScan(std::size_t points, std::size_t values)
{
  std::vector<float> scan;
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t k = 0; k < values; ++k)
      scan.push_back(k == 4 ? static_cast<float>(i % 32)
                            : 0.25f * static_cast<float>(i) +
                                  0.125f * static_cast<float>(k));
  return scan;
}

TEST(LidarCloud, IsToldApartByWhatItHolds)
{
  const TemporaryFolder folder;
  for (const std::size_t points : {1, 4, 20, 21}) { // 4 and 20 fit both datasets
    const std::string kitti = folder.file("000000.bin");
    writeFloats(kitti, lidarScan(points, 4));
    const LabelledCloud four = readCloud(kitti);
    EXPECT_EQ(four.size(), points);
    EXPECT_EQ(valuesOf<float>(four.fields, "intensity").at(0), 0.375f);
    EXPECT_FALSE(hasField(four, "ring"));

    const std::string nuscenes = folder.file("n015.pcd.bin");
    writeFloats(nuscenes, lidarScan(points, 5));
    const LabelledCloud five = readCloud(nuscenes);
    EXPECT_EQ(five.size(), points);
    EXPECT_EQ(valuesOf<float>(five.fields, "ring").back(),
              static_cast<float>((points - 1) % 32));
    EXPECT_EQ(valuesOf<float>(five.fields, "x").back(),
              0.25f * static_cast<float>(points - 1));
  }
}

TEST(LidarCloud, IsRefusedWhenItIsCut)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("cut.bin");
  writeFloats(path, lidarScan(3, 4));
  const std::string whole = readText(path);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    writeText(path, whole.substr(0, size));
    const std::string complaint = complaintAbout(path, [&] { readCloud(path); });
    EXPECT_EQ(complaint == "none", size > 0 && size % 16 == 0) << size;
  }
}

TEST(LidarCloud, IsOnlyReadWhereItIsNamed)
{
  const TemporaryFolder folder;
  writeText(folder.file("text.dat"), std::string(64, '1'));
  EXPECT_THROW(readCloud(folder.file("text.dat")), CIDException);
}

} // namespace
} // namespace pcl_cid::test
