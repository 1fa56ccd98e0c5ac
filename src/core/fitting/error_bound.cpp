/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The bound on the error of hulls, asked of one body at a time.
 */

#include "base/parallel_for.h"
#include "base/requirements.h"
#include "hull_cover.h"
#include "hull_search.h"
#include "seen_space.h"

#include <pcl_cid/core/hull_simplification.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl_cid {
namespace {

void
requireUsable(const PreparedScan::ConstPtr& scan,
              double max_error,
              const std::vector<Eigen::Vector3d>& viewpoints)
{
  if (!scan)
    throw CIDException("there is no scan; a bound on the error needs one");
  require(setting::max_error, max_error);
  requireFinite(viewpoints);
}

} // namespace

/** Places farther than T that were seen, and what tells of others. */
struct ErrorBound::SeenPlaces {
  SeenPlaces(const PreparedScan& scan,
             double max_error,
             const std::vector<Eigen::Vector3d>& viewpoints,
             int threads,
             Progress& progress)
  : deep(scan.points().points, scan.field(), max_error, viewpoints, threads, progress)
  , seen(scan.points().points, viewpoints, deep.step())
  {
  }

  FreeSpace deep;
  SeenSpace seen;
};

double
paddedBound(double max_error, double padding)
{
  return max_error + std::sqrt(3.0) * padding;
}

ErrorBound::ErrorBound(const PreparedScan::ConstPtr& scan,
                       double max_error,
                       const std::vector<Eigen::Vector3d>& viewpoints,
                       const ExecutionOptions& execution)
: scan_(scan), max_error_(max_error)
{
  requireUsable(scan, max_error, viewpoints);
  if (viewpoints.empty())
    return;
  Progress progress(execution.progress);
  seen_ = std::make_unique<SeenPlaces>(*scan,
                                       max_error,
                                       scan->points().frame.toLocal(viewpoints),
                                       threadCount(execution.threads),
                                       progress);
}

ErrorBound::~ErrorBound() = default;

bool
ErrorBound::isKeptBy(const TriangleMesh& body) const
{
  const FastHull hull = fastHull(scan_->points().frame.toLocal(body.vertices));
  if (hull.faces.empty())
    return false;
  if (!seen_)
    return !straysFarther(hull, scan_->field(), max_error_);
  // Corners stand out farthest, and may do so between the places of the grid.
  return std::none_of(hull.vertices.begin(),
                      hull.vertices.end(),
                      [&](const Eigen::Vector3d& corner) {
                        const auto distance = static_cast<double>(
                            scan_->field().distance(corner.cast<float>()));
                        return distance > max_error_ && seen_->seen.isSeen(corner);
                      }) &&
         visitPlacesNear(
             hull, seen_->deep, 0.0, [](const PlaceRange&) { return false; });
}

} // namespace pcl_cid
