/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Actions on parts as JSON.
 */

#include "action_json.h"
#include "json_fields.h"

#include <array>

namespace pcl_cid {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

int
partIn(const Json& json, const char* name = "part")
{
  return wholeNumberIn<int>(json, name);
}

/** Writes the fields of an action; the first one is there already. */
struct PartActionWriter {
  OrderedJson& json;

  void
  operator()(const part_action::Decompose& decompose)
  {
    json["groups"] = decompose.groups;
  }

  void
  operator()(const part_action::Cut& cut)
  {
    json["parts"] = cut.parts;
  }

  void
  operator()(const part_action::Join& join)
  {
    json["part"] = join.part;
    json["with"] = join.with;
  }

  void
  operator()(const part_action::Exact& exact)
  {
    json["part"] = exact.part;
    json["exact"] = exact.exact;
  }

  void
  operator()(const part_action::Undo&)
  {
  }

  void
  operator()(const part_action::Redo&)
  {
  }

  /** All others name a part. */
  template <typename Action>
  void
  operator()(const Action& action)
  {
    json["part"] = action.part;
  }
};

bool
exactIn(const Json& json)
{
  const Json& exact = field(json, "exact");
  if (!exact.is_boolean())
    throw CIDException("'exact' must be true or false");
  return exact.get<bool>();
}

/** A word, and how to read the action that it stands for. */
struct PartVerb {
  const char* word;
  PartAction (*read)(const Json& json);
};

/** In the order of PartAction. */
constexpr std::array<PartVerb, std::variant_size_v<PartAction>> part_verbs{{
    {"decompose",
     [](const Json& json) -> PartAction {
       return part_action::Decompose{wholeNumberIn<std::size_t>(json, "groups")};
     }},
    {"cut",
     [](const Json& json) -> PartAction {
       return part_action::Cut{wholeNumberIn<std::size_t>(json, "parts")};
     }},
    {"split",
     [](const Json& json) -> PartAction { return part_action::Split{partIn(json)}; }},
    {"join",
     [](const Json& json) -> PartAction {
       return part_action::Join{partIn(json), partIn(json, "with")};
     }},
    {"drop",
     [](const Json& json) -> PartAction { return part_action::Drop{partIn(json)}; }},
    {"keep",
     [](const Json& json) -> PartAction { return part_action::Keep{partIn(json)}; }},
    {"exact",
     [](const Json& json) -> PartAction {
       return part_action::Exact{partIn(json), exactIn(json)};
     }},
    {"undo parts", [](const Json&) -> PartAction { return part_action::Undo{}; }},
    {"redo parts", [](const Json&) -> PartAction { return part_action::Redo{}; }},
}};

} // namespace

OrderedJson
toJson(const PartAction& action)
{
  OrderedJson json{{"do", part_verbs[action.index()].word}};
  std::visit(PartActionWriter{json}, action);
  return json;
}

std::optional<PartAction>
partActionFrom(const Json& json)
{
  const std::string word = textIn(json, "do");
  for (const PartVerb& verb : part_verbs)
    if (word == verb.word)
      return verb.read(json);
  return std::nullopt;
}

} // namespace pcl_cid
