/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Actions as JSON.
 */

#include "action_json.h"
#include "json_fields.h"

#include <pcl_cid/io/session_file.h>

#include <array>
#include <cstdint>
#include <utility>

namespace pcl_cid {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

/** How many points are left out, then how many are in, and so on. */
OrderedJson
runsOf(const pcl::Indices& points)
{
  OrderedJson runs = OrderedJson::array();
  pcl::index_t next = 0; // the first point that no run has told of
  for (std::size_t k = 0; k < points.size();) {
    const std::size_t begin = k++;
    while (k < points.size() && points[k] == points[k - 1] + 1)
      ++k;
    runs.push_back(points[begin] - next);
    runs.push_back(k - begin);
    next = points[k - 1] + 1;
  }
  return runs;
}

/** \throws CIDException when they are no runs, or too long */
pcl::Indices
pointsOfRuns(const Json& json)
{
  constexpr std::int64_t most = std::numeric_limits<pcl::index_t>::max();
  const Json& runs = field(json, "runs");
  if (!runs.is_array() || runs.size() % 2 != 0)
    throw CIDException("'runs' must be a list of pairs of whole numbers");
  pcl::Indices points;
  std::int64_t next = 0;
  for (std::size_t k = 0; k < runs.size(); k += 2) {
    next += wholeNumber<std::uint32_t>(runs[k], "runs");
    const std::int64_t end = next + wholeNumber<std::uint32_t>(runs[k + 1], "runs");
    if (end > most)
      throw CIDException("'runs' go to point " + std::to_string(end) +
                         "; no cloud has so many points");
    for (; next < end; ++next)
      points.push_back(static_cast<pcl::index_t>(next));
  }
  return points;
}

pcl::Indices
pointsOfList(const Json& json)
{
  const Json& list = field(json, "points");
  if (!list.is_array())
    throw CIDException("'points' must be a list of whole numbers");
  pcl::Indices points;
  for (const Json& point : list)
    points.push_back(wholeNumber<pcl::index_t>(point, "points"));
  return points;
}

void
put(const action::Answer& answer, OrderedJson& json)
{
  if (const auto* instance = std::get_if<action::NewInstance>(&answer)) {
    OrderedJson made{{"class", instance->class_name}, {"name", instance->name}};
    if (instance->label)
      made["label"] = *instance->label;
    json["new"] = std::move(made);
  }
  else
    json["label"] = std::get<std::uint32_t>(answer);
}

action::Answer
answerFrom(const Json& json)
{
  if (!json.contains("new"))
    return wholeNumberIn<std::uint32_t>(json, "label");
  const Json& made = json["new"];
  action::NewInstance instance{textIn(made, "class"), textIn(made, "name"), {}};
  if (made.contains("label"))
    instance.label = wholeNumberIn<std::uint32_t>(made, "label");
  return instance;
}

/** Writes the fields of an action; the first one is there already. */
struct ActionWriter {
  OrderedJson& json;

  void
  operator()(const action::Propose& propose)
  {
    json["seeds"] = propose.seeds;
  }

  void
  operator()(const action::Label& label)
  {
    json["seed"] = label.seed;
    put(label.answer, json);
  }

  void
  operator()(const action::Click& click)
  {
    json["points"] = click.points;
    put(click.answer, json);
  }

  void
  operator()(const action::Remove& remove)
  {
    json["seed"] = remove.seed;
  }

  void
  operator()(const action::Paint& paint)
  {
    put(paint.answer, json);
    json["runs"] = runsOf(paint.points);
  }

  void
  operator()(const action::Unpaint& unpaint)
  {
    json["runs"] = runsOf(unpaint.points);
  }

  void
  operator()(const action::Edit& edit)
  {
    json["label"] = edit.label;
    json["class"] = edit.class_name;
    json["name"] = edit.name;
  }

  void
  operator()(const action::Merge& merge)
  {
    json["from"] = merge.from;
    json["into"] = merge.into;
  }

  void
  operator()(const action::Delete& deletion)
  {
    json["label"] = deletion.label;
  }

  void
  operator()(const action::Settle&)
  {
  }

  void
  operator()(const action::Undo&)
  {
  }

  void
  operator()(const action::Redo&)
  {
  }
};

/** A word, and how to read the action that it stands for. */
struct Verb {
  const char* word;
  LabelAction (*read)(const Json& json);
};

using Seed = pcl::index_t;
using Label = std::uint32_t;

/** In the order of LabelAction. */
constexpr std::array<Verb, std::variant_size_v<LabelAction>> verbs{{
    {"propose",
     [](const Json& json) -> LabelAction {
       return action::Propose{wholeNumberIn<std::size_t>(json, "seeds")};
     }},
    {"label",
     [](const Json& json) -> LabelAction {
       return action::Label{wholeNumberIn<Seed>(json, "seed"), answerFrom(json)};
     }},
    {"click",
     [](const Json& json) -> LabelAction {
       return action::Click{pointsOfList(json), answerFrom(json)};
     }},
    {"remove",
     [](const Json& json) -> LabelAction {
       return action::Remove{wholeNumberIn<Seed>(json, "seed")};
     }},
    {"paint",
     [](const Json& json) -> LabelAction {
       return action::Paint{pointsOfRuns(json), answerFrom(json)};
     }},
    {"unpaint",
     [](const Json& json) -> LabelAction {
       return action::Unpaint{pointsOfRuns(json)};
     }},
    {"edit",
     [](const Json& json) -> LabelAction {
       return action::Edit{wholeNumberIn<Label>(json, "label"),
                           textIn(json, "class"),
                           textIn(json, "name")};
     }},
    {"merge",
     [](const Json& json) -> LabelAction {
       return action::Merge{wholeNumberIn<Label>(json, "from"),
                            wholeNumberIn<Label>(json, "into")};
     }},
    {"delete",
     [](const Json& json) -> LabelAction {
       return action::Delete{wholeNumberIn<Label>(json, "label")};
     }},
    {"settle", [](const Json&) -> LabelAction { return action::Settle{}; }},
    {"undo", [](const Json&) -> LabelAction { return action::Undo{}; }},
    {"redo", [](const Json&) -> LabelAction { return action::Redo{}; }},
}};

} // namespace

const char*
wordOf(const LabelAction& action)
{
  return verbs[action.index()].word;
}

OrderedJson
toJson(const LabelAction& action)
{
  OrderedJson json{{"do", wordOf(action)}};
  std::visit(ActionWriter{json}, action);
  return json;
}

LabelAction
actionFrom(const Json& json)
{
  const std::string word = textIn(json, "do");
  for (const Verb& verb : verbs)
    if (word == verb.word)
      return verb.read(json);
  throw CIDException("nothing is called '" + word + "' that can be done");
}

} // namespace pcl_cid
