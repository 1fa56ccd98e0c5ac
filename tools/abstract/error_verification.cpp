/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --verify: the bound on the error of hulls, checked on what is in the files.
 */

#include "error_verification.h"

#include "run/words.h"

#include <pcl/common/point_tests.h>
#include <pcl/kdtree/kdtree_flann.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_cid::tools {
namespace {

/** Boxes smaller than this share of the bound are not cut further. */
constexpr double smallest_box = 0.05;
/** ... and smaller than this where places may be unseen, as all boxes about them are.
 */
constexpr double smallest_unseen_box = 0.2;

struct Plane {
  Eigen::Vector3d normal;
  double offset;
};

std::vector<Plane>
planesOf(const TriangleMesh& hull)
{
  std::vector<Plane> planes;
  for (const auto& t : hull.triangles) {
    const Eigen::Vector3d& a = hull.vertices[t[0]];
    const Eigen::Vector3d normal =
        (hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a).normalized();
    planes.push_back({normal, normal.dot(a)});
  }
  return planes;
}

/** Whether a plane separates a box from the hull. */
bool
isOutside(const Eigen::AlignedBox3d& box, const std::vector<Plane>& planes)
{
  const Eigen::Vector3d half = 0.5 * box.sizes();
  return std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
    return plane.normal.dot(box.center()) - plane.normal.cwiseAbs().dot(half) >
           plane.offset;
  });
}

bool
holds(const std::vector<Plane>& planes, const Eigen::Vector3d& place)
{
  return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
    return plane.normal.dot(place) <= plane.offset;
  });
}

/** The halves of a box across its longest side. */
std::pair<Eigen::AlignedBox3d, Eigen::AlignedBox3d>
halvesOfBox(const Eigen::AlignedBox3d& box)
{
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  std::pair<Eigen::AlignedBox3d, Eigen::AlignedBox3d> halves = {box, box};
  halves.first.max()[axis] = box.center()[axis];
  halves.second.min()[axis] = box.center()[axis];
  return halves;
}

/** Directions are told apart by half a degree of azimuth and of elevation. */
constexpr int azimuths = 720;
constexpr int elevations = 360;
constexpr std::size_t directions = std::size_t{azimuths} * elevations;

struct Direction {
  int row;
  int column;

  Direction
  beside(int rows, int columns) const
  {
    return {std::clamp(row + rows, 0, elevations - 1),
            (column + columns + azimuths) % azimuths};
  }

  std::size_t
  number() const
  {
    return static_cast<std::size_t>(row) * azimuths + static_cast<std::size_t>(column);
  }
};

Direction
directionOf(const Eigen::Vector3d& ray)
{
  constexpr double pi = 3.14159265358979323846;
  const double azimuth = (std::atan2(ray.y(), ray.x()) + pi) / (2.0 * pi);
  const double elevation = std::atan2(ray.z(), ray.head<2>().norm()) / pi + 0.5;
  return {std::clamp(static_cast<int>(elevation * elevations), 0, elevations - 1),
          std::clamp(static_cast<int>(azimuth * azimuths), 0, azimuths - 1)};
}

} // namespace

struct ErrorVerification::Tree {
  pcl::KdTreeFLANN<pcl::PointXYZ> search;
};

ErrorVerification::ErrorVerification(const CloudPoints& points,
                                     double max_error,
                                     const std::vector<Eigen::Vector3d>& viewpoints)
: points_(points)
, allowed_(viewpoints.empty() ? max_error : 4.0 / 3.0 * max_error)
, tree_(std::make_unique<Tree>())
{
  tree_->search.setInputCloud(points.points);
  for (const Eigen::Vector3d& from : viewpoints) {
    View view{from, std::vector<float>(directions, 0.0f)};
    for (const pcl::PointXYZ& p : *points.points) {
      if (!pcl::isFinite(p))
        continue;
      const Eigen::Vector3d ray = p.getVector3fMap().cast<double>() - from;
      float& nearest = view.nearest[directionOf(ray).number()];
      const auto range = static_cast<float>(ray.norm());
      nearest = nearest > 0.0f ? std::min(nearest, range) : range;
    }
    views_.push_back(std::move(view));
  }
}

ErrorVerification::~ErrorVerification() = default;

double
ErrorVerification::distance(const Eigen::Vector3d& place) const
{
  pcl::PointXYZ query;
  query.getVector3fMap() = place.cast<float>();
  pcl::Indices nearest;
  std::vector<float> squared;
  tree_->search.nearestKSearch(query, 1, nearest, squared);
  return std::sqrt(static_cast<double>(squared.front()));
}

/** Whether a place is nearer to a viewpoint than all points in its direction and in the
 *  directions beside it: then there is no doubt about it. */
bool
ErrorVerification::isSeen(const Eigen::Vector3d& place) const
{
  return views_.empty() ||
         std::any_of(views_.begin(), views_.end(), [&](const View& view) {
           const Eigen::Vector3d ray = place - view.from;
           const auto range = static_cast<float>(ray.norm());
           const Direction center = directionOf(ray);
           bool is_seen = view.nearest[center.number()] > 0.0f;
           for (int row = -1; row <= 1; ++row)
             for (int column = -1; column <= 1; ++column) {
               const float nearest = view.nearest[center.beside(row, column).number()];
               is_seen = is_seen && (nearest == 0.0f || range < nearest);
             }
           return is_seen;
         });
}

std::optional<std::string>
ErrorVerification::findTooFar(const TriangleMesh& hull) const
{
  const std::vector<Plane> planes = planesOf(hull);
  std::vector<Eigen::AlignedBox3d> boxes(1);
  for (const Eigen::Vector3d& v : hull.vertices)
    boxes[0].extend(v);
  while (!boxes.empty()) {
    const Eigen::AlignedBox3d box = boxes.back();
    boxes.pop_back();
    const Eigen::Vector3d center = box.center();
    const double radius = 0.5 * box.diagonal().norm();
    const double far = distance(center);
    if (far + radius <= allowed_ || isOutside(box, planes))
      continue;
    if (far > allowed_ && holds(planes, center) && isSeen(center))
      return "it holds a place that is " + shortNumber(far) +
             " m from the scan; the bound allows " + shortNumber(allowed_) + " m";
    if (radius > (views_.empty() ? smallest_box : smallest_unseen_box) * allowed_) {
      const auto halves = halvesOfBox(box);
      boxes.push_back(halves.first);
      boxes.push_back(halves.second);
    }
  }
  return std::nullopt;
}

} // namespace pcl_cid::tools
