/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A labelled scan, as the peers are given it.
 */

#include "peer_scan.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/output_files.h>

#include <algorithm>
#include <ostream>

#include <pcl/common/point_tests.h>

namespace pcl_cid::benchmarks {
namespace {

/** Only those that belong to finite points. */
std::vector<std::uint32_t>
select(const std::vector<std::uint32_t>& values, const pcl::Indices& source)
{
  std::vector<std::uint32_t> selected;
  for (const pcl::index_t i : source)
    selected.push_back(values[static_cast<std::size_t>(i)]);
  return selected;
}

} // namespace

PeerScan
readPeerScan(const std::string& path, const std::vector<Eigen::Vector3d>& viewpoints)
{
  PeerScan scan;
  scan.file = readCloud(path);
  const CloudPoints points = pointsOf(scan.file);
  if (points.finite == 0)
    throw CIDException(path + ": has no finite point; at least 1 is needed");
  scan.cloud = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < points.points->size(); ++i)
    if (pcl::isFinite((*points.points)[i])) {
      scan.cloud->push_back((*points.points)[i]);
      scan.source.push_back(static_cast<pcl::index_t>(i));
    }
  scan.truth.label = select(labelsOf(scan.file, "label", points), scan.source);
  const std::vector<std::uint32_t>& label = scan.truth.label;
  if (std::count(label.begin(), label.end(), 0u) ==
      static_cast<std::ptrdiff_t>(label.size()))
    throw CIDException(path + ": every label is 0, which means none; the true "
                              "instances are needed");
  scan.truth.semantic.assign(scan.cloud->size(), 1);
  if (hasField(scan.file, "semantic"))
    scan.truth.semantic = select(labelsOf(scan.file, "semantic", points), scan.source);
  const Eigen::Vector3f offset = points.frame.origin.cast<float>();
  for (const Eigen::Vector3d& v : viewpoints)
    scan.viewpoints.emplace_back(points.frame.toLocal(v).cast<float>());
  if (viewpoints.empty())
    scan.viewpoints.emplace_back(scan.file.sensor_origin.head<3>() - offset);
  scan.is_organized = scan.file.fields.height > 1;
  return scan;
}

void
writeLabels(const PeerScan& scan,
            const std::vector<std::uint32_t>& labels,
            const std::string& path)
{
  std::vector<std::uint32_t> all(scan.file.size(), 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    all[static_cast<std::size_t>(scan.source[i])] = labels[i];
  LabelledCloud labelled = scan.file;
  setLabels(all, LabelType::U4, labelled);
  OutputFiles outputs({scan.file.name});
  outputs.announce(path);
  outputs.write(path, [&](std::ostream& stream) {
    writeCloud(stream, labelled, layoutFor(path, labelled.layout));
  });
  outputs.commit();
}

} // namespace pcl_cid::benchmarks
