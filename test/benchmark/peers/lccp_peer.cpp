/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * PCL's supervoxels and locally convex patches, over a range of settings.
 */

#include "peer_method.h"

#include <map>

#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

namespace pcl_cid::benchmarks {
namespace {

struct LCCPSettings {
  double voxel_spacings; ///< edge of a voxel in point spacings
  double seed_voxels;    ///< edge of a supervoxel in voxels
  double angle;          ///< concavity tolerance, degrees
  unsigned int least;    ///< supervoxels below which a part joins a neighbor
  unsigned int common;   ///< neighbors that must be convex, too ("extended convexity")
};

// What PCL's example of LCCP (examples/segmentation) begins with.
constexpr float spatial_importance = 1.0f;
constexpr float normal_importance = 4.0f;
constexpr float smoothness = 0.1f;

/** Supervoxels turn their normals to the origin: the middle of the viewpoints is to be
 *  there. */
Cloud::Ptr
aboutViewpoints(const PeerScan& scan)
{
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& viewpoint : scan.viewpoints)
    middle += viewpoint / static_cast<float>(scan.viewpoints.size());
  auto moved = pcl::make_shared<Cloud>(*scan.cloud);
  for (pcl::PointXYZ& point : *moved)
    point.getVector3fMap() -= middle;
  return moved;
}

Measurement
segment(const PeerScan& scan, const LCCPSettings& settings, double spacing)
{
  const auto voxel = static_cast<float>(settings.voxel_spacings * spacing);
  const auto seed =
      static_cast<float>(settings.seed_voxels * settings.voxel_spacings * spacing);
  // The normals are those that it estimates from its voxels.
  pcl::SupervoxelClustering<pcl::PointXYZ> clustering(voxel, seed);
  // Voxels that grow with the distance from the sensor, for images of a camera only.
  clustering.setUseSingleCameraTransform(scan.is_organized);
  clustering.setInputCloud(aboutViewpoints(scan));
  clustering.setColorImportance(0.0f);
  clustering.setSpatialImportance(spatial_importance);
  clustering.setNormalImportance(normal_importance);
  std::map<std::uint32_t, pcl::Supervoxel<pcl::PointXYZ>::Ptr> supervoxels;
  clustering.extract(supervoxels);
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  clustering.getSupervoxelAdjacency(adjacency);

  pcl::LCCPSegmentation<pcl::PointXYZ> lccp;
  lccp.setConcavityToleranceThreshold(static_cast<float>(settings.angle));
  lccp.setSmoothnessCheck(true, voxel, seed, smoothness);
  lccp.setKFactor(settings.common);
  lccp.setMinSegmentSize(settings.least);
  lccp.setInputSupervoxels(supervoxels, adjacency);
  lccp.segment();
  const pcl::PointCloud<pcl::PointXYZL>::Ptr labelled = clustering.getLabeledCloud();
  lccp.relabelCloud(*labelled);

  // It numbers its parts in the order of addresses of memory; so by their first point.
  std::map<std::uint32_t, std::uint32_t> number = {{0, 0}};
  Measurement result;
  for (const pcl::PointXYZL& point : *labelled)
    result.labels.push_back(
        number.try_emplace(point.label, static_cast<std::uint32_t>(number.size()))
            .first->second);
  return result;
}

std::vector<Report::Parameter>
describe(const LCCPSettings& settings)
{
  return {{"voxel_spacings", settings.voxel_spacings},
          {"seed_voxels", settings.seed_voxels},
          {"concavity_tolerance", settings.angle},
          {"min_segment_size", std::int64_t(settings.least)},
          {"k_factor", std::int64_t(settings.common)}};
}

} // namespace

std::vector<PeerRun>
lccpRuns(const PeerScan& scan, double spacing)
{
  std::vector<PeerRun> runs;
  for (const double voxel_spacings : {2.0, 3.0, 5.0})
    for (const double seed_voxels : {4.0, 8.0})
      for (const double angle : {5.0, 10.0, 20.0})
        for (const unsigned int least : {0u, 3u})
          for (const unsigned int common : {0u, 1u}) {
            const LCCPSettings settings{
                voxel_spacings, seed_voxels, angle, least, common};
            runs.push_back({"lccp", describe(settings), [=, &scan] {
                              return segment(scan, settings, spacing);
                            }});
          }
  return runs;
}

} // namespace pcl_cid::benchmarks
