/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a restless annotator does.
 */

#include "random_actions.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>

namespace pcl_cid::test {
namespace {

class RestlessAnnotator {
public:
  RestlessAnnotator(const LabelSession& session, std::mt19937_64& random)
  : session_(session), random_(random), seeds_(session.seeds())
  {
  }

  LabelAction
  act()
  {
    switch (below(14)) {
    case 0:
      return action::Propose{1 + below(4)};
    case 1:
    case 2:
      return action::Label{anySeed(), anyAnswer()};
    case 3:
    case 4:
    case 5:
      return action::Click{{anyPoint()}, anyAnswer()};
    case 6:
      return action::Remove{anySeed()};
    case 7:
      return action::Paint{anyPoints(), anyAnswer()};
    case 8:
      return action::Unpaint{anyPoints()};
    case 9:
      return action::Edit{anyLabel(), "class " + std::to_string(below(3)), "\"\n\\ü"};
    case 10:
      return below(2) == 0 ? LabelAction(action::Merge{anyLabel(), anyLabel()})
                           : LabelAction(action::Delete{anyLabel()});
    case 11:
      return below(4) == 0 ? LabelAction(action::Settle{})
                           : LabelAction(action::Click{anyPoints(), anyAnswer()});
    case 12:
      return action::Redo{};
    default:
      return action::Undo{};
    }
  }

private:
  std::size_t
  below(std::size_t limit)
  {
    return static_cast<std::size_t>(random_() % limit);
  }

  pcl::index_t
  anyPoint()
  {
    return static_cast<pcl::index_t>(below(session_.labels().size()));
  }

  pcl::index_t
  anySeed()
  {
    return seeds_.empty() ? anyPoint() : seeds_[below(seeds_.size())].point;
  }

  std::uint32_t
  anyLabel()
  {
    const auto& instances = session_.instances();
    return instances.empty() ? 1 : instances[below(instances.size())].label;
  }

  action::Answer
  anyAnswer()
  {
    if (below(3) == 0)
      return action::NewInstance{"class " + std::to_string(below(3)), "", {}};
    return below(5) == 0 ? 0 : anyLabel();
  }

  pcl::Indices
  anyPoints()
  {
    pcl::Indices points;
    for (std::size_t k = 0; k <= below(12); ++k)
      points.push_back(anyPoint());
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  const LabelSession& session_;
  std::mt19937_64& random_;
  const std::vector<SessionSeed> seeds_;
};

} // namespace

LabelAction
randomAction(const LabelSession& session, std::mt19937_64& random)
{
  return RestlessAnnotator(session, random).act();
}

std::vector<LabelAction>
doRandomActions(std::size_t count, std::uint64_t seed, LabelSession& session)
{
  std::mt19937_64 random(seed);
  std::vector<LabelAction> actions;
  // On a tiny cloud hardly anything is possible.
  for (std::size_t tries = 0; actions.size() < count && tries < 100 * count; ++tries)
    try {
      const LabelAction action = randomAction(session, random);
      session.apply(action);
      actions.push_back(action);
    }
    catch (const CIDException&) {
      continue;
    }
  return actions;
}

} // namespace pcl_cid::test
