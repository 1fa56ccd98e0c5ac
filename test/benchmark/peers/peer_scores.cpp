/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Purity, and how well the instances of a scan are found.
 */

#include "peer_scores.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pcl_cid::benchmarks {
namespace {

/** Points of a true instance, of the prediction of the same name, and of both. */
struct Overlap {
  std::size_t truth = 0;
  std::size_t predicted = 0;
  std::size_t both = 0;
  std::uint32_t semantic = 0;

  double
  iou() const
  {
    return static_cast<double>(both) / static_cast<double>(truth + predicted - both);
  }
};

std::map<std::uint32_t, Overlap>
overlapOfEach(const std::vector<std::uint32_t>& labels,
              const std::vector<std::uint32_t>& instance,
              const std::vector<std::uint32_t>& semantic)
{
  std::map<std::uint32_t, Overlap> overlaps;
  for (std::size_t i = 0; i < instance.size(); ++i) {
    if (instance[i] != 0) {
      Overlap& overlap = overlaps[instance[i]];
      if (overlap.truth++ == 0)
        overlap.semantic = semantic[i];
      overlap.both += labels[i] == instance[i] ? 1 : 0;
    }
    if (labels[i] != 0)
      ++overlaps[labels[i]].predicted;
  }
  return overlaps;
}

/** R (1 + P) / 2, the mean over the classes. */
double
averagePrecision(const std::map<std::uint32_t, Overlap>& overlaps, double threshold)
{
  struct Count {
    double truth = 0.0;
    double predicted = 0.0;
    double found = 0.0;
  };
  std::map<std::uint32_t, Count> classes;
  for (const auto& [instance, overlap] : overlaps) {
    Count& count = classes[overlap.semantic];
    count.truth += 1.0;
    count.predicted += overlap.predicted > 0 ? 1.0 : 0.0;
    count.found += overlap.iou() > threshold ? 1.0 : 0.0;
  }
  double sum = 0.0;
  for (const auto& [semantic, count] : classes)
    if (count.found > 0.0)
      sum += count.found / count.truth * (1.0 + count.found / count.predicted) / 2.0;
  return sum / static_cast<double>(classes.size());
}

} // namespace

std::size_t
countLabels(const std::vector<std::uint32_t>& labels)
{
  std::set<std::uint32_t> different(labels.begin(), labels.end());
  different.erase(0);
  return different.size();
}

double
purityOf(const std::vector<std::uint32_t>& group,
         const std::vector<std::uint32_t>& instance)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> points;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < group.size(); ++i)
    if (instance[i] != 0) {
      ++counted;
      if (group[i] != 0)
        ++points[{group[i], instance[i]}];
    }
  std::map<std::uint32_t, std::size_t> largest;
  for (const auto& [pair, count] : points)
    largest[pair.first] = std::max(largest[pair.first], count);
  std::size_t pure = 0;
  for (const auto& [name, count] : largest)
    pure += count;
  return static_cast<double>(pure) / static_cast<double>(counted);
}

std::vector<std::uint32_t>
labelsOfSeeds(const std::vector<std::uint32_t>& group,
              const pcl::Indices& seeds,
              const std::vector<std::uint32_t>& instance)
{
  std::vector<std::uint32_t> labels;
  for (const std::uint32_t number : group)
    labels.push_back(
        number == 0 ? 0 : instance[static_cast<std::size_t>(seeds[number - 1])]);
  return labels;
}

InstanceScores
scoreInstances(const std::vector<std::uint32_t>& labels,
               const std::vector<std::uint32_t>& instance,
               const std::vector<std::uint32_t>& semantic)
{
  const std::map<std::uint32_t, Overlap> overlaps =
      overlapOfEach(labels, instance, semantic);
  InstanceScores scores;
  scores.ap25 = averagePrecision(overlaps, 0.25);
  scores.ap50 = averagePrecision(overlaps, 0.5);
  scores.ap75 = averagePrecision(overlaps, 0.75);
  for (const auto& [name, overlap] : overlaps)
    scores.mean_iou += overlap.iou() / static_cast<double>(overlaps.size());
  return scores;
}

} // namespace pcl_cid::benchmarks
