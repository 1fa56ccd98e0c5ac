/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts of a scan while a person chooses them.
 */

#include "part_choice.h"

#include <pcl_cid/core/part_session.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <string>
#include <utility>

namespace pcl_cid {

struct PartSession::State {
  std::shared_ptr<const Decomposition> decomposition;
  PartChoices choices;
};

/** What a state becomes by an action. */
class PartSession::Editor {
public:
  Editor(const PartSession& session, const ExecutionOptions& execution)
  : session_(session), execution_(execution), state_(*session.state_)
  {
  }

  std::shared_ptr<const State>
  after(const PartAction& action)
  {
    std::visit(*this, action);
    return std::make_shared<State>(std::move(state_));
  }

  void
  operator()(const part_action::Decompose& decompose)
  {
    Grouping grouping(session_.scan_, session_.grouping_);
    grouping.propose(decompose.groups, 0.0f, partOf(execution_, 0.0, 0.5));
    MergeTree tree =
        mergeGroups(grouping, session_.merging_, partOf(execution_, 0.5, 0.95));
    state_.choices = cut(tree, partsAtElbow(tree));
    state_.decomposition = std::make_shared<Decomposition>(
        Decomposition{grouping.groups(partOf(execution_, 0.95, 1.0)), std::move(tree)});
  }

  void
  operator()(const part_action::Cut& cut_at)
  {
    const MergeTree& tree = requireTree();
    if (cut_at.parts < 1 || cut_at.parts > tree.numberOfGroups())
      throw CIDException("there cannot be " + std::to_string(cut_at.parts) +
                         " parts; there must be 1 to " +
                         std::to_string(tree.numberOfGroups()) + ", the groups");
    PartChoices choices = cut(tree, cut_at.parts);
    copyMarks(state_.choices, choices);
    state_.choices = std::move(choices);
  }

  void
  operator()(const part_action::Split& split)
  {
    const PartChoice whole = *find(split.part);
    if (!whole.node->first)
      throw CIDException("part " + std::to_string(split.part) +
                         " is one group, which cannot be split; decompose the scan "
                         "into more groups");
    *find(split.part) = {whole.node->first, whole.dropped, whole.exact};
    insert({whole.node->second, whole.dropped, whole.exact});
  }

  void
  operator()(const part_action::Join& join)
  {
    PartChoice first = *find(join.part);
    PartChoice second = *find(join.with);
    if (join.part == join.with)
      throw CIDException("part " + std::to_string(join.part) +
                         " cannot be joined with itself; name another one");
    if (isLower(second, first))
      std::swap(first, second);
    state_.choices.erase(find(second.node->lowest_group));
    *find(first.node->lowest_group) = {
        std::make_shared<PartNode>(
            PartNode{first.node->lowest_group, std::nullopt, first.node, second.node}),
        first.dropped && second.dropped,
        first.exact || second.exact};
  }

  void
  operator()(const part_action::Drop& drop)
  {
    find(drop.part)->dropped = true;
  }

  void
  operator()(const part_action::Keep& keep)
  {
    find(keep.part)->dropped = false;
  }

  void
  operator()(const part_action::Exact& exact)
  {
    find(exact.part)->exact = exact.exact;
  }

  // Never done to a state, see PartSession::apply().
  void
  operator()(const part_action::Undo&)
  {
  }

  void
  operator()(const part_action::Redo&)
  {
  }

private:
  const MergeTree&
  requireTree() const
  {
    if (!state_.decomposition)
      throw CIDException("there are no parts yet; decompose the scan first");
    return state_.decomposition->tree;
  }

  PartChoices::iterator
  find(int part)
  {
    requireTree();
    PartChoices& choices = state_.choices;
    const auto found =
        std::find_if(choices.begin(), choices.end(), [&](const PartChoice& choice) {
          return choice.node->lowest_group == part;
        });
    if (found == choices.end())
      throw CIDException("there is no part " + std::to_string(part) +
                         "; a part goes by the number of its lowest group");
    return found;
  }

  void
  insert(PartChoice choice)
  {
    PartChoices& choices = state_.choices;
    choices.insert(std::upper_bound(choices.begin(), choices.end(), choice, isLower),
                   choice);
  }

  const PartSession& session_;
  const ExecutionOptions& execution_;
  State state_;
};

PartSession::PartSession(PreparedScan::ConstPtr scan,
                         const GroupingSettings& grouping,
                         std::size_t group_samples)
: scan_(std::move(scan)), grouping_(grouping), state_(std::make_shared<State>())
{
  if (!scan_)
    throw CIDException("there is no prepared scan to choose parts of; give one");
  require(setting::samples, grouping.samples);
  require(setting::group_samples, static_cast<int>(group_samples));
  merging_.group_samples = group_samples;
}

void
PartSession::apply(const PartAction& action, const ExecutionOptions& execution)
{
  if (std::holds_alternative<part_action::Undo>(action)) {
    move(done_, undone_, "take back");
    return;
  }
  if (std::holds_alternative<part_action::Redo>(action)) {
    move(undone_, done_, "do again");
    return;
  }
  std::shared_ptr<const State> next = Editor(*this, execution).after(action);
  const bool is_cut = std::holds_alternative<part_action::Cut>(action);
  if (!is_cut || !is_cutting_)
    done_.push_back(state_);
  state_ = std::move(next);
  is_cutting_ = is_cut;
  undone_.clear();
}

/** Go to the last of some states; the present one is kept among others. */
void
PartSession::move(States& from, States& to, const char* what)
{
  if (from.empty())
    throw CIDException("there is no action on parts to " + std::string(what));
  to.push_back(std::exchange(state_, std::move(from.back())));
  from.pop_back();
  is_cutting_ = false;
}

const std::shared_ptr<const Decomposition>&
PartSession::decomposition() const
{
  return state_->decomposition;
}

std::vector<ChosenPart>
PartSession::parts() const
{
  std::vector<ChosenPart> parts;
  for (const PartChoice& choice : state_->choices) {
    ChosenPart part;
    part.groups = groupsOf(*choice.node);
    for (const int group : part.groups)
      part.size +=
          state_->decomposition->tree.groupSizes()[static_cast<std::size_t>(group)];
    part.height = choice.node->height;
    part.splits = choice.node->first != nullptr;
    part.dropped = choice.dropped;
    part.exact = choice.exact;
    parts.push_back(std::move(part));
  }
  return parts;
}

} // namespace pcl_cid
