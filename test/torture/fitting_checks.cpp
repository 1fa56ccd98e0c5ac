/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What must hold of parts that are chosen by their hulls.
 */

#include "fitting_checks.h"

#include "part_checks.h"
#include "torture_fault.h"

#include <pcl_cid/core/hull_cid.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <string>

#include <Eigen/Geometry>

namespace pcl_cid::test {
namespace {

/** A run by hull, and what came of it. */
struct FittingRun {
  CIDConvexAbstraction<TorturePoint> abstraction;
  std::vector<ConvexPart> parts;
  std::string refusal;

  FittingRun(const TortureCase& one, unsigned int threads)
  : abstraction(one.abstraction(threads))
  {
    try {
      choose(one.fitting);
      abstraction.reconstruct(parts);
    }
    catch (const CIDException& exception) {
      refusal = exception.what();
    }
  }

private:
  void
  choose(const FittingCase& fitting)
  {
    const HullFittingSettings& settings = fitting.settings;
    abstraction.setMergingRule(MergingRule::hull);
    abstraction.resetMergeCut();
    if (fitting.has_parts)
      abstraction.setNumberOfParts(static_cast<int>(settings.parts));
    if (settings.hasBound())
      abstraction.setMaxError(settings.max_error);
    abstraction.setMinThickness(settings.min_thickness);
    abstraction.setRobotRadius(settings.robot_radius);
    abstraction.setViewpoints(settings.viewpoints);
  }
};

bool
hasWords(const std::string& text, const char* words)
{
  return text.find(words) != std::string::npos;
}

/** A bound that is refused because hulls of a scan so large are thicker. */
bool
isBelowTolerance(const TortureCase& one, const std::string& refusal)
{
  Eigen::AlignedBox3d box;
  for (const TorturePoint& point : *one.cloud)
    if (point.getVector3fMap().allFinite())
      box.extend(point.getVector3fMap().cast<double>());
  return hasWords(refusal, "not above the least thickness") &&
         one.fitting.settings.max_error <= hull_tolerance * box.diagonal().norm();
}

/** Refused is what has to be, and no more. */
void
checkRefusal(const TortureCase& one, const std::string& refusal)
{
  const HullFittingSettings& settings = one.fitting.settings;
  const bool is_somewhere = std::all_of(
      settings.viewpoints.begin(),
      settings.viewpoints.end(),
      [](const Eigen::Vector3d& viewpoint) { return viewpoint.allFinite(); });
  if (!is_somewhere)
    expect(hasWords(refusal, "is not finite"), "a viewpoint nowhere: " + refusal);
  else if (!one.fitting.has_parts && !settings.hasBound())
    expect(hasWords(refusal, "needs a number of parts"), "no number: " + refusal);
  else if (settings.hasBound() && settings.max_error <= settings.min_thickness)
    expect(hasWords(refusal, "not above the least thickness"),
           "a bound that cannot be: " + refusal);
  else if (!refusal.empty() && !isBelowTolerance(one, refusal))
    expect(hasWords(refusal, "points, the least number asked for"),
           "by hull, an exception: " + refusal);
}

void
checkNumbers(const TortureCase& one, const HullFitting& fitting, std::size_t points)
{
  const HullFittingSettings& settings = one.fitting.settings;
  expect(fitting.part.size() == points, "by hull: not a part for each point");
  int next = 0;
  for (const int part : fitting.part) {
    expect(part >= 0 && part <= next, "by hull: numbers of parts have a gap");
    next += part == next ? 1 : 0;
  }
  expect(fitting.parts == static_cast<std::size_t>(next), "by hull: how many parts");
  if (!settings.hasBound())
    expect(fitting.parts <= settings.parts, "by hull: too many parts");
  expect(fitting.refused_places <= fitting.free_places, "by hull: refused places");
}

/** Without viewpoints: with them, it is a promise of seen places alone. */
void
checkBound(const TortureCase& one, const HullFitting& fitting, const PreparedScan& scan)
{
  const HullFittingSettings& settings = one.fitting.settings;
  if (!settings.hasBound() || !settings.viewpoints.empty())
    return;
  std::vector<std::vector<Eigen::Vector3d>> parts(fitting.parts);
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < fitting.part.size(); ++i) {
    const Eigen::Vector3d p = scan.points().points[i].cast<double>();
    parts[static_cast<std::size_t>(fitting.part[i])].push_back(p);
    box.extend(p);
  }
  const double rounding = 1e-6 * (settings.max_error + box.diagonal().norm());
  for (const auto& part : parts) {
    // A subsample, or a surface that was given, may be far from a point: no hull can be
    // nearer than its points.
    if (std::count(part.begin(), part.end(), part.front()) ==
        static_cast<std::ptrdiff_t>(part.size()))
      continue;
    const HullCID cid = hullCID(part, scan.field(), 0.1 * settings.max_error);
    expect(cid.low <= settings.max_error + rounding,
           "by hull: CID_h is at least " + std::to_string(cid.low));
  }
}

void
checkThreads(const FittingRun& one, const FittingRun& other)
{
  expect(one.refusal == other.refusal, "by hull: more threads refuse other things");
  const HullFitting& a = one.abstraction.getHullFitting();
  const HullFitting& b = other.abstraction.getHullFitting();
  expect(a.part == b.part && a.free_places == b.free_places &&
             a.refused_places == b.refused_places && sameParts(one.parts, other.parts),
         "by hull: other parts on more threads");
}

} // namespace

void
checkFitting(const TortureCase& one, const PreparedScan& scan)
{
  const FittingRun run(one, 1);
  checkRefusal(one, run.refusal);
  checkThreads(run, FittingRun(one, one.fitting.threads));
  if (!run.refusal.empty())
    return;
  const HullFitting& fitting = run.abstraction.getHullFitting();
  checkNumbers(one, fitting, scan.points().size());
  checkBound(one, fitting, scan);
  checkParts(*one.cloud,
             run.parts,
             run.abstraction.getHullOptions(),
             scan.points().size(),
             run.abstraction.getNumberOfDroppedPoints());
}

} // namespace pcl_cid::test
