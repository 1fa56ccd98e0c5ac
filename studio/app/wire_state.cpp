/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A session as pages see it.
 */

#include "wire_state.h"

#include <map>
#include <utility>

namespace pcl_cid::studio {
namespace {

using Json = nlohmann::json;
using Numbers = std::vector<std::uint32_t>;

/** The key of the seed of each group: its place. */
Numbers
keysOf(const std::vector<SessionSeed>& seeds, const Places& places)
{
  Numbers keys;
  for (const SessionSeed& seed : seeds)
    keys.push_back(places.placeOf(seed.point));
  return keys;
}

std::uint32_t
keyAt(const LabelSession& session, const Numbers& keys, pcl::index_t point)
{
  const pcl::index_t group = session.groups()[static_cast<std::size_t>(point)];
  return group < 0 ? Places::none : keys[static_cast<std::size_t>(group)];
}

Json
seedsOf(const std::vector<SessionSeed>& seeds,
        const std::vector<std::size_t>& size,
        const Places& places)
{
  Json list = Json::array();
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    const std::uint32_t place = places.placeOf(seeds[k].point);
    list.push_back({{"key", place},
                    {"place", place},
                    {"label", seeds[k].label ? Json(*seeds[k].label) : Json()},
                    {"size", size[k]}});
  }
  return list;
}

/** How many points there are of each group and label. */
struct Counts {
  std::vector<std::size_t> of_seed;
  std::map<std::uint32_t, std::size_t> of_label;

  Counts(const LabelSession& session, const std::vector<SessionSeed>& seeds)
  : of_seed(seeds.size(), 0)
  {
    std::vector<std::size_t> painted(seeds.size(), 0); // points of each group
    for (std::size_t i = 0; i < session.groups().size(); ++i) {
      const pcl::index_t group = session.groups()[i];
      if (group >= 0)
        ++of_seed[static_cast<std::size_t>(group)];
      if (!session.isPainted(static_cast<pcl::index_t>(i)))
        continue;
      ++of_label[session.labels()[i]];
      if (group >= 0)
        ++painted[static_cast<std::size_t>(group)];
    }
    for (std::size_t k = 0; k < seeds.size(); ++k)
      of_label[seeds[k].label.value_or(0)] += of_seed[k] - painted[k];
  }
};

} // namespace

Json
summaryOf(const LabelSession& session, const Places& places)
{
  const std::vector<SessionSeed> seeds = session.seeds();
  Counts counts(session, seeds);
  std::size_t unlabeled = places.size();
  Json instances = Json::array();
  for (const NamedInstance& instance : session.instances()) {
    const std::size_t size = counts.of_label[instance.label];
    unlabeled -= size;
    instances.push_back({{"label", instance.label},
                         {"class", instance.class_name},
                         {"name", instance.name},
                         {"size", size}});
  }
  return {{"seeds", seedsOf(seeds, counts.of_seed, places)},
          {"instances", std::move(instances)},
          {"undo", session.undoable()},
          {"redo", session.redoable()},
          {"unlabeled", unlabeled}};
}

std::vector<NamedArray>
allLabels(const LabelSession& session, const Places& places)
{
  const Numbers keys = keysOf(session.seeds(), places);
  Numbers labels(places.size());
  Numbers groups(places.size());
  for (std::size_t place = 0; place < places.size(); ++place) {
    const pcl::index_t point = places.point(place);
    labels[place] = session.labels()[static_cast<std::size_t>(point)];
    groups[place] = keyAt(session, keys, point);
  }
  return {{"labels", std::move(labels)}, {"groups", std::move(groups)}};
}

std::vector<NamedArray>
changedLabels(const LabelSession& session,
              const pcl::Indices& changed,
              const Places& places)
{
  const Numbers keys = keysOf(session.seeds(), places);
  Numbers labels;
  Numbers groups;
  labels.reserve(changed.size());
  groups.reserve(changed.size());
  for (const pcl::index_t point : changed) {
    labels.push_back(session.labels()[static_cast<std::size_t>(point)]);
    groups.push_back(keyAt(session, keys, point));
  }
  return {{"places", places.placesOf(changed)},
          {"labels", std::move(labels)},
          {"groups", std::move(groups)}};
}

pcl::Indices
groupOf(const LabelSession& session, pcl::index_t seed)
{
  const pcl::index_t group = session.groups()[static_cast<std::size_t>(seed)];
  pcl::Indices points;
  for (std::size_t i = 0; i < session.groups().size(); ++i)
    if (group >= 0 && session.groups()[i] == group)
      points.push_back(static_cast<pcl::index_t>(i));
  return points;
}

Json
partsOf(const PartSession& parts, std::size_t decomposition)
{
  Json heights = Json::array();
  const bool has_parts = parts.decomposition() != nullptr;
  if (has_parts)
    for (const MergeStep& step : parts.decomposition()->tree.steps())
      heights.push_back(step.height);
  Json list = Json::array();
  for (const ChosenPart& part : parts.parts())
    list.push_back({{"part", part.number()},
                    {"groups", part.groups},
                    {"size", part.size},
                    {"height", part.height ? Json(*part.height) : Json()},
                    {"splits", part.splits},
                    {"dropped", part.dropped},
                    {"exact", part.exact}});
  return {{"groups", has_parts ? parts.decomposition()->tree.numberOfGroups() : 0},
          {"decomposition", decomposition},
          {"heights", std::move(heights)},
          {"list", std::move(list)},
          {"undo", parts.undoable()},
          {"redo", parts.redoable()}};
}

std::vector<NamedArray>
partGroups(const PartSession& parts, const Places& places)
{
  Numbers groups;
  if (parts.decomposition()) {
    groups.reserve(places.size());
    for (std::size_t place = 0; place < places.size(); ++place)
      groups.push_back(static_cast<std::uint32_t>(
          parts.decomposition()
              ->groups[static_cast<std::size_t>(places.point(place))]));
  }
  return {{"part_groups", std::move(groups)}};
}

} // namespace pcl_cid::studio
