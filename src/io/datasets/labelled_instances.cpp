/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a person has labelled in a scan, for the writers of datasets.
 */

#include "base/sentence.h"
#include "instance_points.h"
#include "text/numbers.h"

#include <pcl_cid/io/labelled_instances.h>

#include <algorithm>
#include <unordered_map>

namespace pcl_cid {
namespace {

/** Where each label stands in the list of instances. */
std::unordered_map<std::uint32_t, std::size_t>
placeOfLabel(const std::vector<NamedInstance>& instances)
{
  std::unordered_map<std::uint32_t, std::size_t> place;
  place.reserve(instances.size());
  for (std::size_t i = 0; i < instances.size(); ++i)
    place.emplace(instances[i].label, i);
  return place;
}

void
requireOwnLabels(const std::vector<NamedInstance>& instances, const std::string& name)
{
  const auto place = placeOfLabel(instances);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const std::uint32_t label = instances[i].label;
    if (label == 0)
      throw CIDException(sentence(name,
                                  ": instance ",
                                  i,
                                  " ('",
                                  instances[i].class_name,
                                  "') has the label 0, which means none; the label of "
                                  "an instance must be at least 1"));
    if (place.at(label) != i)
      throw CIDException(sentence(
          name, ": two instances have the label ", label, "; each must have its own"));
  }
}

} // namespace

void
requireConsistent(const LabelledInstances& scan,
                  std::size_t points,
                  const std::string& name)
{
  if (scan.label.size() != points)
    throw CIDException(sentence(name,
                                ": has ",
                                countOf(points, "point"),
                                ", but there are labels for ",
                                scan.label.size(),
                                "; there must be one for each"));
  requireOwnLabels(scan.instances, name);
  const auto place = placeOfLabel(scan.instances);
  for (std::size_t i = 0; i < points; ++i)
    if (scan.label[i] != 0 && place.count(scan.label[i]) == 0)
      throw CIDException(sentence(name,
                                  ": point ",
                                  i,
                                  " has the label ",
                                  scan.label[i],
                                  ", which is of no instance; it must be that of one, "
                                  "or 0"));
}

std::vector<InstancePoints>
pointsOfInstances(const LabelledInstances& scan,
                  const std::function<bool(std::size_t)>& counts)
{
  const auto place = placeOfLabel(scan.instances);
  std::vector<InstancePoints> all;
  for (const NamedInstance& instance : scan.instances)
    all.push_back({instance, {}});
  for (std::size_t i = 0; i < scan.label.size(); ++i)
    if (scan.label[i] != 0 && counts(i))
      all[place.at(scan.label[i])].points.push_back(i);
  const auto isEmpty = [](const InstancePoints& each) { return each.points.empty(); };
  all.erase(std::remove_if(all.begin(), all.end(), isEmpty), all.end());
  std::sort(
      all.begin(), all.end(), [](const InstancePoints& a, const InstancePoints& b) {
        return a.instance.label < b.instance.label;
      });
  return all;
}

} // namespace pcl_cid
