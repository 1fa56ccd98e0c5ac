/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The clouds that are measured: generated rooms and scans from files.
 */

#include "benchmark_cloud.h"

#include "depth_sensor.h"
#include "even_sampler.h"
#include "room_scene.h"

#include <pcl_cid/io/cloud_points.h>

#include <stdexcept>

#include <pcl/io/pcd_io.h>

namespace pcl_cid::benchmarks {
namespace {

test::LabelledScan
scanARoom(RoomScan scan, std::size_t points)
{
  test::RoomOptions room;
  room.seed = 7; // the room of data/room.pcd
  const test::RoomScene scene = test::makeRoom(room);
  if (scan == RoomScan::even)
    return test::sampleRoomEvenly(scene, points, 7);
  test::SensorOptions sensor;
  sensor.seed = 7;
  sensor.points = points;
  return test::scanRoom(scene, sensor);
}

} // namespace

RoomScan
roomScanFromName(const std::string& name)
{
  if (name == "even")
    return RoomScan::even;
  if (name == "sensor")
    return RoomScan::sensor;
  throw std::invalid_argument("the room is '" + name + "'; it must be even or sensor");
}

Cloud::Ptr
makeRoomCloud(RoomScan scan, std::size_t points)
{
  auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(points);
  for (const Eigen::Vector3f& p : scanARoom(scan, points).points)
    cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  return cloud;
}

Cloud::Ptr
loadCloud(const std::string& path)
{
  auto cloud = pcl::make_shared<Cloud>();
  if (pcl::io::loadPCDFile(path, *cloud) != 0)
    throw std::runtime_error("cannot read " + path + "; it must be a PCD file");
  if (finitePoints(*cloud).size() == 0)
    throw std::runtime_error(path + " has no finite point; at least 1 is needed");
  return cloud;
}

} // namespace pcl_cid::benchmarks
