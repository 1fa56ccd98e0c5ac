/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One point of each voxel of a file, and what follows it.
 */

#include "fields/point_survey.h"

#include <pcl_cid/io/cloud_blocks.h>
#include <pcl_cid/io/voxel_cloud.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace pcl_cid {
namespace {

using Block = VoxelPoints::Block;

/** What VoxelPoints refuses, with the name of the file. */
template <typename Call>
auto
inFile(const CloudBlockReader& reader, const Call& call)
{
  try {
    return call();
  }
  catch (const CIDException& exception) {
    throw CIDException(reader.head().name + ": " + exception.what());
  }
}

/** Call take(block, points) for each block of a file, with its coordinates in metres,
 *  and tell how far it is. */
template <typename Take>
void
forEachBlock(CloudBlockReader& reader,
             const ExecutionOptions& execution,
             const Take& take)
{
  reader.rewind();
  const auto all = static_cast<double>(reader.head().size());
  std::size_t read = 0;
  LabelledCloud block;
  Block points;
  while (reader.read(block)) {
    const FileCoordinates coordinates(block);
    points.resize(block.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = coordinates[i];
    take(block, points);
    read += points.size();
    if (execution.progress && !execution.progress(static_cast<double>(read) / all))
      throw CIDCancelled();
  }
}

void
leaveOut(const std::vector<Eigen::Vector3d>& places, Block& points)
{
  if (places.empty())
    return;
  for (Eigen::Vector3d& p : points)
    p = keptPoint(p, places);
}

} // namespace

VoxelCloud::VoxelCloud(CloudBlockReader& reader, const VoxelOptions& options)
: voxels_(options.size, options.execution.threads)
{
  findVoxels(reader, options);
  if (finite_ == 0)
    throw CIDException(reader.head().name + ": none of its " +
                       std::to_string(reader.head().size()) +
                       " points is finite; at least 1 must be");
  choosePoints(reader, options);
}

VoxelCloud::~VoxelCloud() = default;

/** What is at the places of points that did not return waits until it is known whether
 *  it counts. */
void
VoxelCloud::findVoxels(CloudBlockReader& reader, const VoxelOptions& options)
{
  PointSurvey survey(reader.head(), options.points);
  Block waiting;
  const auto waits = [&](const Eigen::Vector3d& p) {
    return !options.points.keep_zeros && survey.isWhereNoneReturned(p);
  };
  forEachBlock(reader,
               partOf(options.execution, 0.0, 0.5),
               [&](const LabelledCloud&, Block& points) {
                 for (Eigen::Vector3d& p : points) {
                   survey.take(p);
                   if (!waits(p))
                     continue;
                   // More of one place are left out, unless there are no other points:
                   // then their mean is where they are, however many there are.
                   if (std::count(waiting.begin(), waiting.end(), p) <
                       PointSurvey::many)
                     waiting.push_back(p);
                   p.setConstant(std::numeric_limits<double>::quiet_NaN());
                 }
                 inFile(reader, [&] { voxels_.add(points); });
               });
  survey.decide();
  left_out_ = survey.leftOut();
  finite_ = survey.finite();
  leaveOut(left_out_, waiting);
  inFile(reader, [&] { voxels_.add(waiting); });
}

void
VoxelCloud::choosePoints(CloudBlockReader& reader, const VoxelOptions& options)
{
  const std::size_t step = reader.head().fields.point_step;
  std::vector<std::uint8_t> rows(voxels_.size() * step); // of each voxel, by its number
  forEachBlock(reader,
               partOf(options.execution, 0.5, 1.0),
               [&](const LabelledCloud& block, Block& points) {
                 leaveOut(left_out_, points);
                 if (options.check)
                   options.check(block, points);
                 const pcl::Indices numbers =
                     inFile(reader, [&] { return voxels_.choose(points); });
                 for (std::size_t i = 0; i < numbers.size(); ++i)
                   if (numbers[i] >= 0)
                     std::memcpy(rows.data() +
                                     static_cast<std::size_t>(numbers[i]) * step,
                                 block.fields.data.data() + i * step,
                                 step);
               });
  cloud_ = reader.head();
  cloud_.fields.data.reserve(rows.size());
  for (const pcl::index_t number : inFile(reader, [&] { return voxels_.finish(); })) {
    const auto row = rows.begin() + static_cast<std::ptrdiff_t>(
                                        static_cast<std::size_t>(number) * step);
    cloud_.fields.data.insert(
        cloud_.fields.data.end(), row, row + static_cast<std::ptrdiff_t>(step));
  }
  cloud_.fields.width = static_cast<std::uint32_t>(voxels_.size());
  cloud_.fields.height = 1;
  cloud_.fields.row_step = cloud_.fields.point_step * cloud_.fields.width;
}

void
VoxelCloud::follow(CloudBlockReader& reader,
                   const Take& take,
                   const ExecutionOptions& execution) const
{
  forEachBlock(reader, execution, [&](LabelledCloud& block, Block& points) {
    leaveOut(left_out_, points);
    take(block, inFile(reader, [&] { return voxels_.follow(points); }));
  });
}

} // namespace pcl_cid
