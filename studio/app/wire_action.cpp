/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a page wants done, as an action.
 */

#include "wire_action.h"
#include "header_fields.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>

namespace pcl_cid::studio {
namespace {

using Json = nlohmann::json;

/** 0, an instance, or a new one. */
action::Answer
answerIn(const Json& header)
{
  const bool is_new = header.contains("class");
  if (is_new == header.contains("label"))
    throw CIDException("an answer has either 'label' or 'class'");
  if (!is_new)
    return numberIn(header, "label");
  return action::NewInstance{textIn(header, "class"), textIn(header, "name", ""), {}};
}

pcl::index_t
pointIn(const Json& header, const char* name, const Places& places)
{
  return places.requirePoint(numberIn(header, name));
}

/** Ascending, each once. */
pcl::Indices
paintedPoints(const Frame& frame, const Places& places)
{
  const auto* const given = frame.array<std::uint32_t>("places");
  if (!given)
    throw CIDException("the array 'places' is missing");
  pcl::Indices points;
  points.reserve(given->size());
  for (const std::uint32_t place : *given)
    points.push_back(places.requirePoint(place));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

LabelAction
paintFrom(const Frame& frame, const Places& places)
{
  pcl::Indices points = paintedPoints(frame, places);
  const auto label = frame.header.find("label");
  if (label != frame.header.end() && label->is_null())
    return action::Unpaint{std::move(points)};
  return action::Paint{std::move(points), answerIn(frame.header)};
}

} // namespace

LabelAction
actionFrom(const Frame& frame, const Places& places)
{
  const Json& header = frame.header;
  const std::string word = textIn(header, "do");
  if (word == "propose")
    return action::Propose{numberIn(header, "seeds")};
  if (word == "answer")
    return action::Label{pointIn(header, "seed", places), answerIn(header)};
  if (word == "click")
    return action::Click{{pointIn(header, "place", places)}, answerIn(header)};
  if (word == "remove")
    return action::Remove{pointIn(header, "seed", places)};
  if (word == "paint")
    return paintFrom(frame, places);
  if (word == "edit")
    return action::Edit{
        numberIn(header, "label"), textIn(header, "class"), textIn(header, "name")};
  if (word == "merge")
    return action::Merge{numberIn(header, "from"), numberIn(header, "into")};
  if (word == "delete")
    return action::Delete{numberIn(header, "label")};
  if (word == "settle")
    return action::Settle{};
  if (word == "undo")
    return action::Undo{};
  if (word == "redo")
    return action::Redo{};
  throw CIDException("nothing is called '" + word + "' that can be done");
}

} // namespace pcl_cid::studio
