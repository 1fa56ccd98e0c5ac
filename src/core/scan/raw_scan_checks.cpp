/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a raw scan and the settings of its preparation must be.
 */

#include "raw_scan_checks.h"

#include "base/requirements.h"

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

/** Beyond this, squared distances come too close to the largest float. */
constexpr float largest_coordinate = 1e15f;

/** Below this, the squares of distances that are as small, beside it, as float can tell
 *  come too close to the smallest float: from here on results are the same in every
 *  unit. */
constexpr float least_extent = 1e-10f;

void
requireFiniteAndModerate(const Points& points)
{
  for (const Eigen::Vector3f& p : points) {
    if (!p.allFinite())
      throw CIDException(sentence("a point is (",
                                  p.x(),
                                  ", ",
                                  p.y(),
                                  ", ",
                                  p.z(),
                                  "); all points to prepare must be finite"));
    if (p.cwiseAbs().maxCoeff() > largest_coordinate)
      throw CIDException(sentence("a coordinate is ",
                                  p.cwiseAbs().maxCoeff(),
                                  " from the middle of the cloud; it must be within ",
                                  largest_coordinate));
  }
}

/** All at one place is fine; what is no more than tiny is most likely misread. */
void
requireNotTiny(const RawScan& scan)
{
  Eigen::AlignedBox3f box;
  for (const Points* points : {&scan.points.points, &scan.surface})
    for (const Eigen::Vector3f& p : *points)
      box.extend(p);
  const float extent = box.sizes().maxCoeff();
  if (extent > 0.0f && extent < least_extent)
    throw CIDException(
        sentence("the cloud is ",
                 extent,
                 " from end to end; it must be at least ",
                 least_extent,
                 " (float cannot square the distances in a smaller one), "
                 "or 0; are the coordinates read as what they are?"));
}

/** Indices of the cloud: results are written to these places. */
void
requireIndices(const PointSet& points, std::size_t cloud_size)
{
  const pcl::Indices& source = points.source;
  if (source.size() != points.size())
    throw CIDException(sentence("there are ",
                                points.size(),
                                " points and ",
                                source.size(),
                                " indices; there must be one for each point"));
  for (std::size_t i = 0; i < source.size(); ++i) {
    requireIndex("index of a point", source[i], cloud_size);
    if (i > 0 && source[i] <= source[i - 1])
      throw CIDException(sentence("the indices of the points hold ",
                                  source[i],
                                  " after ",
                                  source[i - 1],
                                  "; they must ascend"));
  }
}

void
requireColors(const std::vector<ColorRGB>& colors, std::size_t points)
{
  if (colors.size() != points)
    throw CIDException(sentence("there are ",
                                colors.size(),
                                " colors; where the color weight is above 0 there must "
                                "be one for each of the ",
                                points,
                                " points"));
}

void
requireInRange(const PreparationSettings& settings)
{
  require(setting::subsample, settings.subsample);
  require(setting::density_power, settings.density_power);
  require(setting::isolated_neighbors, settings.isolated_neighbors);
  require(setting::color, settings.color);
  require(setting::normals, settings.normals);
  if (settings.start_index)
    require(setting::start_index, *settings.start_index);
}

} // namespace

void
requireUsable(const RawScan& scan, const PreparationSettings& settings)
{
  requireInRange(settings);
  requirePoints(scan.points.points);
  requireIndices(scan.points, scan.cloud_size);
  if (settings.color > 0.0f)
    requireColors(scan.colors, scan.points.size());
  requireFiniteAndModerate(scan.points.points);
  requireFiniteAndModerate(scan.surface);
  requireNotTiny(scan);
}

} // namespace pcl_cid
