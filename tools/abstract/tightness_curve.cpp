/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How tightly hulls fit, over the cuts of a merge tree.
 */

#include "tightness_curve.h"

#include "run/words.h"

#include <algorithm>
#include <limits>
#include <ostream>
#include <utility>

namespace pcl_cid::tools {
namespace {

/** The numbers of parts that are tried: from all groups down to 1. */
std::vector<std::size_t>
numbersOfParts(std::size_t groups)
{
  std::vector<std::size_t> numbers;
  for (std::size_t parts = groups; parts > 0;
       parts -= std::max(parts / 6, std::size_t{1}))
    numbers.push_back(parts);
  return numbers;
}

} // namespace

TightnessMeter
measureTightness(const AbstractSettings& settings,
                 const PreparedScan::ConstPtr& scan,
                 const std::vector<ConvexPart>& parts,
                 Run& run)
{
  run.begin("Measuring hulls");
  TightnessOptions options;
  options.free_distance = settings.free_distance;
  options.execution = {settings.threads, run.console.progress()};
  TightnessMeter meter(scan, options);
  run.report.tightness = meter.measure(parts);
  run.end(percent(run.report.tightness->all.free_share) + " free space", "tightness");
  return meter;
}

std::vector<CurvePoint>
tightnessCurve(const TightnessMeter& meter, bool simplified, Abstraction& abstraction)
{
  const MergeTree tree = abstraction.getMergeTree();
  const std::size_t groups = tree.numberOfGroups();
  std::vector<CurvePoint> curve;
  for (const std::size_t parts : numbersOfParts(groups)) {
    std::vector<ConvexPart> hulls;
    abstraction.reconstruct(tree.cutAtParts(parts), hulls);
    if (simplified)
      abstraction.simplify(hulls);
    CurvePoint point = {hulls.size(), 0.0, 0, meter.measure(hulls)};
    if (parts < groups)
      point.height = tree.steps()[groups - parts - 1].height;
    for (const ConvexPart& part : hulls)
      point.vertices += part.hull.vertices.size();
    curve.push_back(std::move(point));
  }
  return curve;
}

void
writeCurve(std::ostream& stream, const std::vector<CurvePoint>& curve)
{
  stream.precision(std::numeric_limits<double>::max_digits10);
  stream << "parts,height,vertices,max_concavity,mean_concavity,free_share,free_volume,"
            "volume\n";
  for (const CurvePoint& point : curve) {
    const HullTightness& all = point.tightness.all;
    stream << point.parts << ',' << point.height << ',' << point.vertices << ','
           << all.max_concavity << ',' << all.mean_concavity << ',' << all.free_share
           << ',' << point.tightness.free_volume << ',' << point.tightness.volume
           << '\n';
  }
}

} // namespace pcl_cid::tools
