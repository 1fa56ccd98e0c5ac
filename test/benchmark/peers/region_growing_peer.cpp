/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * PCL's region growing on estimated normals, over a range of settings.
 */

#include "normals.h"
#include "peer_method.h"

#include <cmath>

#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

namespace pcl_cid::benchmarks {
namespace {

struct GrowingSettings {
  int normal_neighbors;
  double angle;     ///< between the normals of neighbors, degrees
  double curvature; ///< of a point that the region goes on from
};

// Those of PCL's tutorial on region growing.
constexpr unsigned int neighbors = 30;
constexpr int least_points = 50;

Measurement
segment(const PeerScan& scan, const GrowingSettings& settings)
{
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  growing.setInputCloud(scan.cloud);
  growing.setInputNormals(estimateNormals(scan.cloud, settings.normal_neighbors));
  growing.setNumberOfNeighbours(neighbors);
  growing.setMinClusterSize(least_points);
  growing.setSmoothnessThreshold(static_cast<float>(settings.angle * M_PI / 180.0));
  growing.setCurvatureThreshold(static_cast<float>(settings.curvature));
  std::vector<pcl::PointIndices> regions;
  growing.extract(regions);

  Measurement result;
  result.labels.assign(scan.cloud->size(), 0);
  for (std::size_t k = 0; k < regions.size(); ++k)
    for (const pcl::index_t i : regions[k].indices)
      result.labels[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(k + 1);
  return result;
}

std::vector<Report::Parameter>
describe(const GrowingSettings& settings)
{
  return {{"normal_neighbors", std::int64_t(settings.normal_neighbors)},
          {"smoothness", settings.angle},
          {"curvature", settings.curvature}};
}

} // namespace

std::vector<PeerRun>
regionGrowingRuns(const PeerScan& scan)
{
  std::vector<PeerRun> runs;
  for (const int normal_neighbors : {30, 60})
    for (const double angle : {2.0, 4.0, 8.0, 15.0})
      for (const double curvature : {0.01, 0.05, 1.0}) {
        const GrowingSettings settings{normal_neighbors, angle, curvature};
        runs.push_back({"region_growing", describe(settings), [=, &scan] {
                          return segment(scan, settings);
                        }});
      }
  return runs;
}

} // namespace pcl_cid::benchmarks
