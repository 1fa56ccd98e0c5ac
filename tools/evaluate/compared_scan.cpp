/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Two clouds of the same scan, reduced to what the scores need.
 */

#include "compared_scan.h"

#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/scannet.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <Eigen/Geometry>

namespace pcl_cid::tools {
namespace {

/** How much of the largest coordinate ascii files with 6 digits may round away. */
constexpr double rounding = 1e-5;
/** The most of it that is put down to rounding, as a share of the scan's diagonal: far
 *  from the origin, neighbors would else pass for each other. */
constexpr double most_rounding = 1e-4;

struct ReadScan {
  LabelledCloud cloud;
  CloudPoints points; ///< zeros, too: files are compared as they are
  RemarkCallback remark;

  ReadScan(const std::string& path, const ScanOptions& options)
  : cloud(readScan(path, options))
  , points(pointsOf(cloud, {true, options.remark}))
  , remark(options.remark)
  {
  }

  Eigen::Vector3d
  point(std::size_t i) const
  {
    return points.frame.toFile((*points.points)[i].getVector3fMap().cast<double>());
  }

  std::vector<std::uint32_t>
  numbers(const std::string& field) const
  {
    return labelsOf(cloud, field, points, remark);
  }
};

/** How far apart equal coordinates may be, metres. */
double
toleranceFor(const ReadScan& scan)
{
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i)
    if (const Eigen::Vector3d point = scan.point(i); point.allFinite())
      box.extend(point);
  if (box.isEmpty())
    return 0.0;
  const double largest =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::min(rounding * largest, most_rounding * box.diagonal().norm());
}

bool
areSame(double a, double b, double tolerance)
{
  if (!std::isfinite(a) || !std::isfinite(b))
    return std::isfinite(a) == std::isfinite(b);
  return std::abs(a - b) <= tolerance;
}

bool
areSame(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double tolerance)
{
  return areSame(a.x(), b.x(), tolerance) && areSame(a.y(), b.y(), tolerance) &&
         areSame(a.z(), b.z(), tolerance);
}

std::string
text(const Eigen::Vector3d& point)
{
  std::ostringstream stream;
  stream.precision(9);
  stream << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
  return stream.str();
}

void
requireSamePoints(const ReadScan& prediction, const ReadScan& truth)
{
  const std::string names = prediction.cloud.name + " and " + truth.cloud.name;
  const std::size_t size = prediction.cloud.size();
  if (size != truth.cloud.size())
    throw CIDException(names + ": have " + std::to_string(size) + " and " +
                       std::to_string(truth.cloud.size()) +
                       " points; they must have the same points in the same order");
  const double tolerance = toleranceFor(truth);
  for (std::size_t i = 0; i < size; ++i)
    if (const Eigen::Vector3d p = prediction.point(i), t = truth.point(i);
        !areSame(p, t, tolerance))
      throw CIDException(names + ": differ in point " + std::to_string(i) + " of " +
                         std::to_string(size) + ", which is at " + text(p) + " and " +
                         text(t) +
                         "; they must have the same points in the same order");
}

void
requireKnown(const std::vector<std::uint32_t>& semantic,
             const SemanticClasses& known,
             const std::string& place)
{
  std::string unknown;
  for (const std::uint32_t number :
       std::set<std::uint32_t>(semantic.begin(), semantic.end()))
    if (number != 0 && !className(known, number))
      unknown += (unknown.empty() ? "" : ", ") + std::to_string(number);
  if (!unknown.empty())
    throw CIDException(place + " has classes that are not known: " + unknown +
                       "; --classes says which are");
}

std::vector<std::uint32_t>
classesOf(const ReadScan& scan, const std::string& field, const SemanticClasses& known)
{
  std::vector<std::uint32_t> semantic = scan.numbers(field);
  requireKnown(semantic, known, scan.cloud.name + ": field '" + field + "'");
  return semantic;
}

} // namespace

const char*
nameOf(ClassRule rule)
{
  switch (rule) {
  case ClassRule::same_label:
    return "same_label";
  case ClassRule::prediction:
    return "prediction";
  default:
    return "truth";
  }
}

ComparedScan
compareScans(const ScanPair& pair,
             const std::string& class_table,
             const FieldNames& fields,
             const SemanticClasses& known,
             EvaluationProtocol protocol)
{
  ComparedScan scan;
  const auto remark = [&](const std::string& sentence) {
    scan.remarks.push_back(sentence);
  };
  // A prediction is a file most of the time, which has no use for the table.
  const ReadScan prediction(
      pair.prediction,
      {isScannetScan(pair.prediction) ? class_table : std::string(), remark});
  const ReadScan truth(pair.truth, {class_table, remark});
  requireSamePoints(prediction, truth);

  scan.points = truth.points.finite;
  scan.has_classes = hasField(truth.cloud, fields.semantic);
  PointLabels predicted{prediction.numbers(fields.prediction), {}};
  PointLabels actual{truth.numbers(fields.truth), {}};
  if (scan.has_classes)
    actual.semantic = classesOf(truth, fields.semantic, known);
  else
    actual.semantic.assign(actual.label.size(), 1);
  if (protocol != EvaluationProtocol::paper) {
    scan.class_rule = ClassRule::truth;
    if (scan.has_classes && hasField(prediction.cloud, fields.semantic)) {
      predicted.semantic = classesOf(prediction, fields.semantic, known);
      scan.class_rule = ClassRule::prediction;
    }
  }
  scan.overlaps = overlapsOf(predicted, actual);
  return scan;
}

} // namespace pcl_cid::tools
