/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * WCSeg-like segmentation of a scan, over a range of settings.
 */

#include "normals.h"
#include "peer_method.h"
#include "weak_convexity.h"

#include "scan/working_set.h"

#include <map>

namespace pcl_cid::benchmarks {
namespace {

/** As many as the paper gives it. */
constexpr std::size_t working_points = 20000;
/** For normals, and for the graph: what Open3D takes when it is not told otherwise, and
 *  what keeps a graph of a surface connected. */
constexpr int normal_neighbors = 30;
constexpr int graph_neighbors = 8;

struct WCSegSettings {
  Orientation orientation;
  WeakConvexityOptions options;
  double reach_spacings; ///< options.reach in point spacings of the working set
};

WorkingSet
drawWorkingSet(const PeerScan& scan)
{
  RandomGenerator generator(0);
  return WorkingSet(finitePoints(*scan.cloud), {}, {}, working_points, {}, generator);
}

Cloud::Ptr
toCloud(const Points& points)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (const Eigen::Vector3f& p : points)
    cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  return cloud;
}

std::vector<Eigen::Vector3f>
normalsOf(const Cloud::ConstPtr& cloud)
{
  const pcl::PointCloud<pcl::Normal>::Ptr estimated =
      estimateNormals(cloud, normal_neighbors);
  std::vector<Eigen::Vector3f> normals;
  for (const pcl::Normal& normal : *estimated)
    normals.emplace_back(normal.getNormalVector3fMap());
  return normals;
}

Measurement
segment(const PeerScan& scan, const WCSegSettings& settings)
{
  const WorkingSet working = drawWorkingSet(scan);
  const Cloud::Ptr cloud = toCloud(working.points());
  const auto neighbors = nearestNeighbors(working.points(), graph_neighbors);
  OrientedPoints surface{working.points(), normalsOf(cloud)};
  // The working set is about an origin of its own, and so are its viewpoints.
  const Eigen::Vector3f origin = working.all().frame.origin.cast<float>();
  std::vector<Eigen::Vector3f> viewpoints;
  for (const Eigen::Vector3f& viewpoint : scan.viewpoints)
    viewpoints.emplace_back(viewpoint - origin);
  orientNormals(
      surface.points, neighbors, viewpoints, settings.orientation, surface.normals);

  WeakConvexityOptions options = settings.options;
  options.reach = settings.reach_spacings * pointSpacing(*cloud);
  const std::vector<int> segments =
      findWeaklyConvexSegments(surface, working.field(), neighbors, options);
  Measurement result;
  // A dropped segment is -1, and so its label is 0.
  result.labels = labelsOfGroups(working.carryOn(segments, scan.cloud->size(), -1));
  return result;
}

std::vector<Report::Parameter>
describe(const WCSegSettings& settings)
{
  static const std::map<Orientation, std::string> names = {
      {Orientation::viewpoint, "viewpoint"},
      {Orientation::center, "center"},
      {Orientation::tree, "tree"}};
  return {{"orientation", names.at(settings.orientation)},
          {"coplanar", settings.options.coplanar},
          {"merge_by_thickness", settings.options.merge_by_thickness}};
}

} // namespace

std::vector<PeerRun>
wcsegRuns(const PeerScan& scan)
{
  std::vector<PeerRun> runs;
  for (const Orientation orientation :
       {Orientation::viewpoint, Orientation::center, Orientation::tree})
    for (const double coplanar : {0.01, 0.1, 0.2})
      for (const bool merge : {true, false}) {
        WCSegSettings settings{orientation, {}, 2.0};
        settings.options.coplanar = coplanar;
        settings.options.merge_by_thickness = merge;
        runs.push_back({"wcseg", describe(settings), [=, &scan] {
                          return segment(scan, settings);
                        }});
      }
  return runs;
}

} // namespace pcl_cid::benchmarks
