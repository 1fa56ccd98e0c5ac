/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the instances of a prediction and of the truth have in common.
 */

#include "base/sentence.h"

#include <pcl_cid/core/instance_overlaps.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

using Numbers = std::vector<std::uint32_t>;

/** How often each pair of numbers occurs; the pairs ascend. */
std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t>
countPairs(const Numbers& first, const Numbers& second)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> counts;
  for (std::size_t i = 0; i < first.size(); ++i)
    ++counts[{first[i], second[i]}];
  return counts;
}

/** The instances in the order of their labels, each with its most frequent class. */
template <typename AnyInstance>
std::vector<AnyInstance>
instancesOf(const Numbers& labels, const Numbers& classes)
{
  std::vector<AnyInstance> instances;
  std::size_t most = 0;
  for (const auto& [label_and_class, count] : countPairs(labels, classes)) {
    const auto [label, semantic] = label_and_class;
    if (label == 0)
      continue;
    if (instances.empty() || instances.back().label != label) {
      instances.emplace_back();
      instances.back().label = label;
      most = 0;
    }
    instances.back().points += count;
    if (count > most) {
      instances.back().semantic = semantic;
      most = count;
    }
  }
  return instances;
}

/** Index of the instance of this label; the number of instances when there is none. */
template <typename AnyInstance>
std::size_t
indexOf(std::uint32_t label, const std::vector<AnyInstance>& instances)
{
  const auto found =
      std::lower_bound(instances.begin(),
                       instances.end(),
                       label,
                       [](const Instance& instance, std::uint32_t value) {
                         return instance.label < value;
                       });
  const bool is_there = found != instances.end() && found->label == label;
  return static_cast<std::size_t>((is_there ? found : instances.end()) -
                                  instances.begin());
}

void
requireAsMany(const char* name, std::size_t size, std::size_t points)
{
  if (size != points)
    throw CIDException(sentence("there are ",
                                size,
                                " ",
                                name,
                                "; there must be one for each of the ",
                                points,
                                " points"));
}

} // namespace

double
InstanceOverlaps::iou(const InstanceOverlap& overlap) const
{
  const std::size_t either = truths[overlap.truth].points +
                             predictions[overlap.prediction].points - overlap.points;
  return static_cast<double>(overlap.points) / static_cast<double>(either);
}

InstanceOverlaps
overlapsOf(const PointLabels& prediction, const PointLabels& truth)
{
  const std::size_t points = truth.label.size();
  requireAsMany("predicted labels", prediction.label.size(), points);
  requireAsMany("true classes", truth.semantic.size(), points);
  if (!prediction.semantic.empty())
    requireAsMany("predicted classes", prediction.semantic.size(), points);

  InstanceOverlaps result;
  result.truths = instancesOf<Instance>(truth.label, truth.semantic);
  result.predictions = instancesOf<PredictedInstance>(
      prediction.label,
      prediction.semantic.empty() ? truth.semantic : prediction.semantic);
  for (const auto& [labels, count] : countPairs(truth.label, prediction.label))
    if (labels.first != 0 && labels.second != 0)
      result.overlaps.push_back({indexOf(labels.first, result.truths),
                                 indexOf(labels.second, result.predictions),
                                 count});
  return result;
}

InstanceOverlaps
sameLabelOverlaps(const InstanceOverlaps& overlaps)
{
  InstanceOverlaps result = overlaps;
  for (PredictedInstance& prediction : result.predictions) {
    const std::size_t truth = indexOf(prediction.label, result.truths);
    if (truth == result.truths.size())
      throw CIDException(sentence("the predicted label ",
                                  prediction.label,
                                  " is not one of the truth; labels must come from the "
                                  "truth here, as those of an annotator do"));
    prediction.semantic = result.truths[truth].semantic;
  }
  const auto differ = [&](const InstanceOverlap& overlap) {
    return result.truths[overlap.truth].label !=
           result.predictions[overlap.prediction].label;
  };
  result.overlaps.erase(
      std::remove_if(result.overlaps.begin(), result.overlaps.end(), differ),
      result.overlaps.end());
  return result;
}

InstanceOverlaps
pairedOverlaps(const InstanceOverlaps& overlaps)
{
  const std::vector<InstanceOverlap>& all = overlaps.overlaps;
  std::vector<double> ious;
  for (const InstanceOverlap& overlap : all)
    ious.push_back(overlaps.iou(overlap));
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return ious[a] > ious[b];
  });

  std::vector<bool> has_truth(overlaps.predictions.size(), false);
  std::vector<bool> has_prediction(overlaps.truths.size(), false);
  std::vector<bool> is_pair(all.size(), false);
  for (const std::size_t k : order) {
    if (has_prediction[all[k].truth] || has_truth[all[k].prediction])
      continue;
    has_prediction[all[k].truth] = has_truth[all[k].prediction] = is_pair[k] = true;
  }

  InstanceOverlaps result{overlaps.truths, overlaps.predictions, {}};
  for (std::size_t k = 0; k < all.size(); ++k)
    if (is_pair[k])
      result.overlaps.push_back(all[k]);
  return result;
}

} // namespace pcl_cid
