/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Small clouds for tests: random, degenerate, and crops of real scans.
 */

#include "clouds.h"

#include "base/random.h"

#include <algorithm>
#include <filesystem>

#include <pcl/io/pcd_io.h>

namespace pcl_cid::test {
namespace {

float
uniform(RandomGenerator& generator)
{
  return static_cast<float>(drawBelow(generator, 1u << 20)) /
         static_cast<float>(1u << 20);
}

Eigen::Vector3f
uniformVector(RandomGenerator& generator)
{
  const float x = uniform(generator);
  const float y = uniform(generator);
  const float z = uniform(generator);
  return {x, y, z};
}

Eigen::Vector3f
onUnitBox(RandomGenerator& generator)
{
  Eigen::Vector3f p = uniformVector(generator);
  const auto side = drawBelow(generator, 6);
  p[static_cast<Eigen::Index>(side / 2)] = side % 2 == 0 ? 0.0f : 1.0f;
  return p;
}

Points
sphere(std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  Points points;
  while (points.size() < count) {
    const Eigen::Vector3f p = 2.0f * uniformVector(generator) - Eigen::Vector3f::Ones();
    if (p.norm() > 0.1f && p.norm() < 1.0f)
      points.push_back(p.normalized());
  }
  return points;
}

Points
noisyPlane(std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f p = uniformVector(generator);
    points.emplace_back(4.0f * p.x(), 3.0f * p.y(), 0.01f * p.z());
  }
  return points;
}

} // namespace

Points
randomCube(std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(uniformVector(generator));
  return points;
}

Points
twoBoxes(std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(onUnitBox(generator) +
                     static_cast<float>(i % 2) * Eigen::Vector3f(2.5f, 0.0f, 0.3f));
  return points;
}

std::vector<NamedPoints>
randomClouds()
{
  return {{"cube", randomCube(250, 1)},
          {"two_boxes", twoBoxes(300, 2)},
          {"sphere", sphere(250, 3)},
          {"noisy_plane", noisyPlane(250, 4)}};
}

std::vector<NamedPoints>
degenerateClouds()
{
  const Eigen::Vector3f p(0.3f, -0.2f, 0.7f);
  Points line, plane, duplicates, huge_and_tiny, grid;
  for (int i = 0; i < 40; ++i)
    line.push_back(p * static_cast<float>(i));
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      plane.emplace_back(
          0.1f * static_cast<float>(i), 0.25f * static_cast<float>(j), 0.5f);
  for (int i = 0; i < 120; ++i)
    duplicates.push_back(randomCube(6, 5)[static_cast<std::size_t>(i % 6)]);
  huge_and_tiny = randomCube(60, 6);
  for (Eigen::Vector3f& q : huge_and_tiny)
    q *= 1e-4f;
  huge_and_tiny.emplace_back(500.0f, 500.0f, -500.0f);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
        grid.emplace_back(
            static_cast<float>(i), static_cast<float>(j), static_cast<float>(k));
  return {{"one_point", {p}},
          {"two_points", {p, -p}},
          {"same_point", Points(20, p)},
          {"line", line},
          {"plane", plane},
          {"duplicates", duplicates},
          {"huge_and_tiny", huge_and_tiny},
          {"grid", grid}};
}

std::vector<NamedPoints>
allClouds()
{
  std::vector<NamedPoints> clouds = randomClouds();
  for (NamedPoints& cloud : degenerateClouds())
    clouds.push_back(std::move(cloud));
  return clouds;
}

Points
crop(const pcl::PointCloud<pcl::PointXYZ>& scan, std::size_t count, std::size_t stride)
{
  Points finite;
  for (const pcl::PointXYZ& p : scan)
    if (p.getVector3fMap().allFinite())
      finite.push_back(p.getVector3fMap());
  const Eigen::Vector3f center = finite[finite.size() / 2];
  std::stable_sort(finite.begin(), finite.end(), [&](const auto& a, const auto& b) {
    return (a - center).squaredNorm() < (b - center).squaredNorm();
  });
  Points cropped;
  for (std::size_t i = 0; i < finite.size() && cropped.size() < count; i += stride)
    cropped.push_back(finite[i]);
  return cropped;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
toCloud(const Points& points)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& p : points)
    cloud->emplace_back(p.x(), p.y(), p.z());
  return cloud;
}

std::string
sharedFile(const std::string& name)
{
  const std::filesystem::path path = std::filesystem::path(PCL_CID_SHARED_DIR) / name;
  return std::filesystem::exists(path) ? path.string() : std::string();
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
loadSharedScan(const std::string& name)
{
  const std::string path = sharedFile("data/" + name);
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (path.empty() || pcl::io::loadPCDFile(path, *cloud) != 0)
    return nullptr;
  return cloud;
}

} // namespace pcl_cid::test
