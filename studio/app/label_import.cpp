/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels that were given elsewhere, as actions.
 */

#include "label_import.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl_cid::studio {
namespace {

/** An answer for a label: the instance is made where it is not there. */
action::Answer
answerFor(std::uint32_t label, const ClassOf& class_of, const LabelSession& session)
{
  if (label == 0)
    return 0u;
  const auto& instances = session.instances();
  const bool is_there =
      std::any_of(instances.begin(), instances.end(), [&](const NamedInstance& each) {
        return each.label == label;
      });
  if (is_there)
    return label;
  return action::NewInstance{class_of(label), "", label};
}

} // namespace

void
importLabels(const std::vector<std::uint32_t>& labels,
             const ClassOf& class_of,
             std::size_t seeds,
             RecordedSession& session,
             const ExecutionOptions& execution)
{
  session.apply(action::Propose{seeds}, execution);
  for (const SessionSeed& seed : session.session().seeds()) {
    const std::uint32_t label = labels[static_cast<std::size_t>(seed.point)];
    session.apply(
        action::Label{seed.point, answerFor(label, class_of, session.session())});
  }
  std::map<std::uint32_t, pcl::Indices> painted;
  const pcl::Indices& points = session.session().scan().points().source;
  for (const pcl::index_t point : points) {
    const auto i = static_cast<std::size_t>(point);
    if (session.session().labels()[i] != labels[i])
      painted[labels[i]].push_back(point);
  }
  for (auto& [label, with_label] : painted)
    session.apply(action::Paint{std::move(with_label),
                                answerFor(label, class_of, session.session())});
}

void
importSeeds(const SeedTable& table,
            RecordedSession& session,
            const ExecutionOptions& execution)
{
  const ClassOf class_of = [&](std::uint32_t label) {
    const auto name = table.names.find(label);
    return name == table.names.end() ? std::string() : name->second;
  };
  std::map<std::uint32_t, pcl::Indices> seeds_of;
  for (std::size_t k = 0; k < table.seeds.size(); ++k)
    seeds_of[table.labels[k]].push_back(table.seeds[k]);
  for (const auto& [label, seeds] : seeds_of)
    session.apply(action::Click{seeds, answerFor(label, class_of, session.session())},
                  execution);
}

} // namespace pcl_cid::studio
