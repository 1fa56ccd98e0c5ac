/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Small clouds for tests: random, degenerate, and crops of real scans.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <pcl_cid/core/point_set.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_cid::test {

struct NamedPoints {
  std::string name;
  Points points;
};

/** Uniform in a cube of side 1 metre. */
Points
randomCube(std::size_t count, std::uint64_t seed);

/** On the sides of two boxes with a gap between them: two convex parts. */
Points
twoBoxes(std::size_t count, std::uint64_t seed);

/** Random clouds of different shapes: a cube, boxes, a sphere, a noisy plane. */
std::vector<NamedPoints>
randomClouds();

/** One point, two points, all the same, collinear, coplanar, many duplicates, huge next
 * to tiny, a grid full of ties. */
std::vector<NamedPoints>
degenerateClouds();

/** All of both. */
std::vector<NamedPoints>
allClouds();

/** The \a count finite points of a scan that are nearest to one of them, every \a
 * stride-th: a crop with real noise and density. */
Points
crop(const pcl::PointCloud<pcl::PointXYZ>& scan, std::size_t count, std::size_t stride);

pcl::PointCloud<pcl::PointXYZ>::Ptr
toCloud(const Points& points);

/** Path of a file of ../shared, empty when it is not there. */
std::string
sharedFile(const std::string& name);

/** The scan in ../shared/data, null when it is not there. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
loadSharedScan(const std::string& name);

} // namespace pcl_cid::test
