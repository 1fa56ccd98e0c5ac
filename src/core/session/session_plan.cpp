/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What an action will do to a session.
 */

#include "session_plan.h"

#include "base/sentence.h"

#include <algorithm>

namespace pcl_cid {
namespace {

/** Labels stay below the mark of points that are not painted. */
constexpr std::uint32_t highest_label = 0xFFFFFFFEu;

} // namespace

LabelSession::Planner::Planner(const LabelSession& session)
: session_(session)
, seeds_(session.grouping_.seeds())
, plan_{*session.tables_, 0, {}, {}, {}, not_painted}
{
}

LabelSession::Plan
LabelSession::Planner::plan(const LabelAction& action)
{
  std::visit(*this, action);
  return std::move(plan_);
}

std::vector<NamedInstance>::iterator
LabelSession::Planner::find(std::uint32_t label)
{
  auto& instances = plan_.tables.instances;
  return std::find_if(instances.begin(), instances.end(), [&](const auto& each) {
    return each.label == label;
  });
}

/** \throws CIDException when the answer names an instance that is not there */
std::uint32_t
LabelSession::Planner::labelFor(const action::Answer& answer)
{
  if (const auto* instance = std::get_if<action::NewInstance>(&answer))
    return add(*instance);
  const std::uint32_t label = std::get<std::uint32_t>(answer);
  if (label != 0 && find(label) == plan_.tables.instances.end())
    throw CIDException(
        sentence("there is no instance ", label, "; make one, or give 0 for none"));
  return label;
}

std::uint32_t
LabelSession::Planner::add(const action::NewInstance& instance)
{
  Tables& tables = plan_.tables;
  const std::uint32_t label = instance.label.value_or(tables.next_label);
  if (label == 0 || label > highest_label)
    throw CIDException(sentence(
        "the label of a new instance is ", label, "; it must be 1 to ", highest_label));
  if (find(label) != tables.instances.end())
    throw CIDException(sentence("there is an instance ", label, " already"));
  tables.instances.push_back({label, instance.class_name, instance.name});
  tables.next_label = std::max(tables.next_label, label + 1);
  return label;
}

std::size_t
LabelSession::Planner::numberOf(pcl::index_t seed) const
{
  const auto found = std::find(seeds_.begin(), seeds_.end(), seed);
  if (found == seeds_.end())
    throw CIDException(sentence("point ", seed, " is not a seed"));
  return static_cast<std::size_t>(found - seeds_.begin());
}

void
LabelSession::Planner::requirePoints(const pcl::Indices& points) const
{
  if (points.empty())
    throw CIDException("there is no point to paint; at least 1 is needed");
  pcl::index_t before = -1;
  for (const pcl::index_t point : points) {
    if (point < 0 || static_cast<std::size_t>(point) >= session_.is_selected_.size() ||
        !session_.is_selected_[static_cast<std::size_t>(point)])
      throw CIDException(
          sentence("point ", point, " to be painted is not a finite, selected point"));
    if (point <= before)
      throw CIDException(sentence("point ",
                                  point,
                                  " to be painted comes after point ",
                                  before,
                                  "; each must be given once, in ascending order"));
    before = point;
  }
}

/** \param[in] numbers ascending */
void
LabelSession::Planner::removeSeeds(std::vector<std::size_t> numbers)
{
  auto& labels = plan_.tables.label_of_seed;
  for (auto number = numbers.rbegin(); number != numbers.rend(); ++number)
    labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(*number));
  plan_.removed = std::move(numbers);
}

pcl::Indices
LabelSession::Planner::paintedWith(std::uint32_t label) const
{
  pcl::Indices points;
  for (std::size_t i = 0; i < session_.painted_.size(); ++i)
    if (session_.painted_[i] == label)
      points.push_back(static_cast<pcl::index_t>(i));
  return points;
}

void
LabelSession::Planner::operator()(const action::Propose& propose)
{
  const std::size_t most = session_.painted_.size();
  if (propose.seeds == 0 || propose.seeds > most)
    throw CIDException(sentence("the number of questions to add is ",
                                propose.seeds,
                                "; it must be 1 to ",
                                most,
                                " (the points)"));
  plan_.proposed = propose.seeds;
}

void
LabelSession::Planner::operator()(const action::Label& label)
{
  const std::size_t number = numberOf(label.seed);
  plan_.tables.label_of_seed[number] = labelFor(label.answer);
}

void
LabelSession::Planner::operator()(const action::Click& click)
{
  if (click.points.empty())
    throw CIDException("there is no point to click on; at least 1 is needed");
  const std::uint32_t label = labelFor(click.answer);
  for (const pcl::index_t point : click.points) {
    const auto seed = std::find(seeds_.begin(), seeds_.end(), point);
    if (seed != seeds_.end()) {
      plan_.tables.label_of_seed[static_cast<std::size_t>(seed - seeds_.begin())] =
          label;
      continue;
    }
    session_.scan().workingIndex(point, "point to click on");
    plan_.added.push_back(point);
    plan_.tables.label_of_seed.push_back(label);
  }
}

void
LabelSession::Planner::operator()(const action::Remove& remove)
{
  removeSeeds({numberOf(remove.seed)});
}

void
LabelSession::Planner::operator()(const action::Paint& paint)
{
  requirePoints(paint.points);
  plan_.painted = paint.points;
  plan_.paint = labelFor(paint.answer);
}

void
LabelSession::Planner::operator()(const action::Unpaint& unpaint)
{
  requirePoints(unpaint.points);
  plan_.painted = unpaint.points;
}

void
LabelSession::Planner::operator()(const action::Edit& edit)
{
  const auto instance = find(edit.label);
  if (instance == plan_.tables.instances.end())
    throw CIDException(sentence("there is no instance ", edit.label));
  instance->class_name = edit.class_name;
  instance->name = edit.name;
}

void
LabelSession::Planner::operator()(const action::Merge& merge)
{
  const auto from = find(merge.from);
  const auto end = plan_.tables.instances.end();
  if (merge.from == merge.into || from == end || find(merge.into) == end)
    throw CIDException(sentence("instances ",
                                merge.from,
                                " and ",
                                merge.into,
                                " cannot be merged; they must be two that are there"));
  plan_.tables.instances.erase(from);
  for (std::optional<std::uint32_t>& label : plan_.tables.label_of_seed)
    if (label == merge.from)
      label = merge.into;
  plan_.painted = paintedWith(merge.from);
  plan_.paint = merge.into;
}

void
LabelSession::Planner::operator()(const action::Delete& deletion)
{
  const auto instance = find(deletion.label);
  if (instance == plan_.tables.instances.end())
    throw CIDException(sentence("there is no instance ", deletion.label));
  plan_.tables.instances.erase(instance);
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < seeds_.size(); ++k)
    if (plan_.tables.label_of_seed[k] == deletion.label)
      numbers.push_back(k);
  removeSeeds(std::move(numbers));
  plan_.painted = paintedWith(deletion.label);
}

void
LabelSession::Planner::operator()(const action::Settle&)
{
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < seeds_.size(); ++k)
    if (!plan_.tables.label_of_seed[k])
      numbers.push_back(k);
  if (numbers.empty())
    throw CIDException("there is no question to take away");
  removeSeeds(std::move(numbers));
}

void
LabelSession::Planner::operator()(const action::Undo&)
{
  throw CIDException("an action that is taken back has no plan of its own");
}

void
LabelSession::Planner::operator()(const action::Redo&)
{
  throw CIDException("an action that is done again has no plan of its own");
}

} // namespace pcl_cid
