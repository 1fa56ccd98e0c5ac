/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan while a person labels it: actions happen, and are taken back.
 */

#include "session_plan.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

/** Points that a thread takes at a time. */
constexpr std::size_t labelled_at_a_time = std::size_t{1} << 16;

/** Values of seeds by the number of a group + 1, so that there is one for no group. */
template <typename Value>
std::vector<Value>
byGroup(std::vector<Value> of_seeds, Value of_none)
{
  of_seeds.insert(of_seeds.begin(), of_none);
  return of_seeds;
}

} // namespace

LabelSession::LabelSession(PreparedScan::ConstPtr scan,
                           const GroupingSettings& settings)
: grouping_(scan, settings)
, tables_(std::make_shared<Tables>())
, is_selected_(scan->cloudSize(), false)
, painted_(scan->cloudSize(), not_painted)
, groups_(scan->cloudSize(), -1)
, labels_(scan->cloudSize(), 0)
{
  for (const pcl::index_t point : scan->points().source)
    is_selected_[static_cast<std::size_t>(point)] = true;
}

LabelSession::LabelSession(LabelSession&& other) noexcept = default;

LabelSession&
LabelSession::operator=(LabelSession&& other) noexcept = default;

LabelSession::~LabelSession() = default;

std::size_t
LabelSession::undoable() const
{
  return done_.size();
}

std::size_t
LabelSession::redoable() const
{
  return undone_.size();
}

std::vector<SessionSeed>
LabelSession::seeds() const
{
  std::vector<SessionSeed> seeds;
  const pcl::Indices points = grouping_.seeds();
  for (std::size_t k = 0; k < points.size(); ++k)
    seeds.push_back({points[k], tables_->label_of_seed[k]});
  return seeds;
}

const std::vector<NamedInstance>&
LabelSession::instances() const
{
  return tables_->instances;
}

pcl::Indices
LabelSession::apply(const LabelAction& action, const ExecutionOptions& execution)
{
  const pcl::Indices old_seeds = grouping_.seeds();
  const bool changes_seeds = perform(action, execution);
  return updateLabels(old_seeds, changes_seeds, execution.threads);
}

std::size_t
LabelSession::replay(const std::vector<LabelAction>& actions,
                     const ExecutionOptions& execution)
{
  const pcl::Indices old_seeds = grouping_.seeds();
  Progress progress(execution.progress);
  bool changes_seeds = false;
  std::size_t done = 0;
  try {
    for (; done < actions.size() && !progress.cancelled(); ++done) {
      changes_seeds |= perform(actions[done], {execution.threads, {}});
      progress.report(static_cast<double>(done + 1) /
                      static_cast<double>(actions.size()));
    }
  }
  catch (const CIDException&) {
    // The caller sees how far it came.
  }
  updateLabels(old_seeds, changes_seeds, execution.threads);
  progress.check(1.0);
  return done;
}

/** \return whether seeds have come or gone */
bool
LabelSession::perform(const LabelAction& action, const ExecutionOptions& execution)
{
  if (std::holds_alternative<action::Undo>(action))
    return undo(execution.threads);
  const bool again = std::holds_alternative<action::Redo>(action);
  if (again && undone_.empty())
    throw CIDException("there is no action to do again");
  const LabelAction& next = again ? undone_.back() : action;
  done_.push_back(carryOut(Planner(*this).plan(next), next, execution));
  if (again)
    undone_.pop_back();
  else
    undone_.clear();
  return done_.back().changesSeeds();
}

bool
LabelSession::undo(unsigned int threads)
{
  if (done_.empty())
    throw CIDException("there is no action to take back");
  const bool changes_seeds = done_.back().changesSeeds();
  takeBack(done_.back(), threads);
  undone_.push_back(std::move(done_.back().action));
  done_.pop_back();
  return changes_seeds;
}

LabelSession::Step
LabelSession::carryOut(Plan plan,
                       const LabelAction& action,
                       const ExecutionOptions& execution)
{
  Step step{action, tables_, {}, 0, {}};
  const pcl::Indices seeds = grouping_.seeds();
  for (const std::size_t number : plan.removed)
    step.removed.push_back({number, seeds[number]});
  if (plan.proposed > 0)
    propose(plan.proposed, plan, execution);
  else if (!plan.added.empty())
    grouping_.addSeeds(plan.added, execution);
  else if (!plan.removed.empty())
    grouping_.removeSeeds(plan.removed, execution);
  // From here on nothing can be cancelled: it happens as a whole.
  step.added = grouping_.numberOfSeeds() + plan.removed.size() - seeds.size();
  paint(plan.painted, plan.paint, step);
  tables_ = std::make_shared<Tables>(std::move(plan.tables));
  return step;
}

/** Let Algorithm 1 go on, as far as there is a point that would gain. */
void
LabelSession::propose(std::size_t seeds, Plan& plan, const ExecutionOptions& execution)
{
  grouping_.propose(grouping_.numberOfSeeds() + seeds, 0.0f, execution);
  plan.tables.label_of_seed.resize(grouping_.numberOfSeeds());
}

void
LabelSession::paint(const pcl::Indices& points, std::uint32_t label, Step& step)
{
  for (const pcl::index_t point : points) {
    std::uint32_t& painted = painted_[static_cast<std::size_t>(point)];
    if (painted == label)
      continue;
    step.painted.push_back({point, painted});
    painted = label;
  }
}

void
LabelSession::takeBack(const Step& step, unsigned int threads)
{
  const ExecutionOptions execution{threads, {}};
  std::vector<std::size_t> added(step.added);
  std::iota(added.begin(), added.end(), grouping_.numberOfSeeds() - step.added);
  grouping_.removeSeeds(added, execution);
  for (const auto& [number, point] : step.removed)
    grouping_.insertSeeds({point}, number, execution);
  for (const auto& [point, label] : step.painted)
    painted_[static_cast<std::size_t>(point)] = label;
  tables_ = step.tables;
}

/** The labels of all points, from their seeds and from what was painted.
 *  \param[in] old_seeds those that the groups are still of
 *  \return the points whose label or seed is another one than before */
pcl::Indices
LabelSession::updateLabels(const pcl::Indices& old_seeds,
                           bool has_new_groups,
                           unsigned int threads)
{
  std::vector<pcl::index_t> groups =
      has_new_groups ? grouping_.groups({threads, {}}) : groups_;
  const auto label_of = byGroup(labelsOfSeeds(), 0u);
  const auto old_seed_of = byGroup(old_seeds, -1);
  const auto new_seed_of = byGroup(grouping_.seeds(), -1);
  std::vector<pcl::Indices> changed(labels_.size() / labelled_at_a_time +
                                    1); // by range
  const auto update = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto group = static_cast<std::size_t>(groups[i] + 1);
      const auto old_group = static_cast<std::size_t>(groups_[i] + 1);
      const std::uint32_t label =
          painted_[i] == not_painted ? label_of[group] : painted_[i];
      if (label != labels_[i] || new_seed_of[group] != old_seed_of[old_group])
        changed[begin / labelled_at_a_time].push_back(static_cast<pcl::index_t>(i));
      labels_[i] = label;
    }
  };
  Progress silent({});
  parallelFor(
      labels_.size(), labelled_at_a_time, threadCount(threads), silent, {}, update);
  groups_ = std::move(groups);
  pcl::Indices all;
  for (const pcl::Indices& range : changed)
    all.insert(all.end(), range.begin(), range.end());
  return all;
}

/** 0 for questions. */
std::vector<std::uint32_t>
LabelSession::labelsOfSeeds() const
{
  std::vector<std::uint32_t> labels;
  for (const std::optional<std::uint32_t>& label : tables_->label_of_seed)
    labels.push_back(label.value_or(0));
  return labels;
}

std::vector<std::uint32_t>
LabelSession::cleanedLabels(const CleaningSettings& settings,
                            const ExecutionOptions& execution) const
{
  if (grouping_.numberOfSeeds() == 0)
    return labels_;
  std::vector<std::uint32_t> labels =
      cleanBoundaries(grouping_, labelsOfSeeds(), settings, execution);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (painted_[i] != not_painted)
      labels[i] = painted_[i];
  return labels;
}

std::optional<Question>
LabelSession::nextQuestion(std::optional<pcl::index_t> after) const
{
  const std::vector<SessionSeed> all = seeds();
  std::vector<std::size_t> size(all.size(), 0);
  for (const pcl::index_t group : groups_)
    if (group >= 0)
      ++size[static_cast<std::size_t>(group)];
  std::vector<std::size_t> questions;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!all[k].label)
      questions.push_back(k);
  std::stable_sort(questions.begin(),
                   questions.end(),
                   [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
  auto next = questions.begin();
  if (after) {
    next = std::find_if(questions.begin(), questions.end(), [&](std::size_t k) {
      return all[k].point == *after;
    });
    next = next == questions.end() ? questions.begin() : next + 1;
  }
  if (next == questions.end())
    return std::nullopt;
  return Question{all[*next].point, size[*next], questions.size()};
}

pcl::Indices
LabelSession::preview(pcl::index_t point, const ExecutionOptions& execution) const
{
  scan().workingIndex(point, "point");
  const pcl::Indices seeds = grouping_.seeds();
  const auto seed = std::find(seeds.begin(), seeds.end(), point);
  const auto number = static_cast<pcl::index_t>(seed - seeds.begin());
  std::vector<pcl::index_t> clicked;
  if (seed == seeds.end()) {
    Grouping copy = grouping_;
    // A copy may be left half done, so it need not be copied again to be cancelled.
    copy.addSeeds({point}, {execution.threads, {}});
    clicked = copy.groups(execution);
  }
  const std::vector<pcl::index_t>& groups = clicked.empty() ? groups_ : clicked;
  pcl::Indices points;
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (groups[i] == number)
      points.push_back(static_cast<pcl::index_t>(i));
  return points;
}

} // namespace pcl_cid
