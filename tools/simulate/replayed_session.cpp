/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A session of pcl_cid_studio, and what each of its actions brought.
 */

#include "replayed_session.h"

#include "run/loaded_scan.h"
#include "run/parameter.h"
#include "run/raw_scan_options.h"
#include "run/session_settings.h"

#include <pcl_cid/core/label_session.h>
#include <pcl_cid/exceptions.h>

#include <utility>
#include <variant>

namespace pcl_cid::tools {
namespace {

/** Tells what an action was about, once it is done. */
class ActionTeller {
public:
  /** \param[in] before the instances that there were before it
   *  \param[in] now those that there are after it
   *  \param[in,out] told has the effort before it */
  ActionTeller(const std::vector<NamedInstance>& before,
               const std::vector<NamedInstance>& now,
               ReplayedAction& told)
  : before_(before), now_(now), told_(told)
  {
  }

  void
  operator()(const action::Label& label)
  {
    ++told_.effort.answers;
    tellPoints({label.seed});
    tellAnswer(label.answer);
  }

  void
  operator()(const action::Click& click)
  {
    ++told_.effort.corrections;
    tellPoints(click.points);
    tellAnswer(click.answer);
  }

  void
  operator()(const action::Remove& removal)
  {
    tellPoints({removal.seed});
  }

  void
  operator()(const action::Paint& paint)
  {
    ++told_.effort.strokes;
    tellPoints(paint.points);
    tellAnswer(paint.answer);
  }

  void
  operator()(const action::Unpaint& unpaint)
  {
    ++told_.effort.strokes;
    tellPoints(unpaint.points);
  }

  void
  operator()(const action::Edit& edit)
  {
    tellInstance(edit.label, now_);
  }

  void
  operator()(const action::Merge& merge)
  {
    tellInstance(merge.into, now_);
  }

  void
  operator()(const action::Delete& deletion)
  {
    tellInstance(deletion.label, before_);
  }

  /** Other actions are about no point and no instance. */
  template <typename Action>
  void
  operator()(const Action&)
  {
  }

private:
  void
  tellPoints(const pcl::Indices& points)
  {
    told_.points = points.size();
    told_.point = points.front();
  }

  /** An instance that an action makes is the last of all. */
  void
  tellAnswer(const action::Answer& answer)
  {
    const auto* const label = std::get_if<std::uint32_t>(&answer);
    tellInstance(label ? *label : now_.back().label, now_);
  }

  void
  tellInstance(std::uint32_t label, const std::vector<NamedInstance>& instances)
  {
    told_.label = label;
    for (const NamedInstance& instance : instances)
      if (instance.label == label)
        told_.class_name = instance.class_name;
  }

  const std::vector<NamedInstance>& before_;
  const std::vector<NamedInstance>& now_;
  ReplayedAction& told_;
};

/** Does the actions of a record, and scores the labels after each. */
class Replay {
public:
  Replay(const SimulateSettings& settings,
         const SessionRecord& record,
         LabelSession session,
         std::vector<std::uint32_t> truth)
  : settings_(settings)
  , record_(record)
  , session_(std::move(session))
  , truth_(std::move(truth))
  {
  }

  /** \throws CIDException when an action is not possible, CIDCancelled */
  std::vector<ReplayedAction>
  run(const ExecutionOptions& execution)
  {
    const auto count = static_cast<double>(record_.actions.size());
    std::vector<ReplayedAction> actions;
    Effort effort;
    for (std::size_t k = 0; k < record_.actions.size(); ++k) {
      const std::vector<NamedInstance> before = session_.instances();
      const auto begin = static_cast<double>(k);
      if (!act(k, partOf(execution, begin / count, (begin + 1.0) / count)))
        break;
      actions.push_back(told(k, before, effort));
      actions.back().score = score(execution.threads);
      effort = actions.back().effort;
      if (execution.progress && !execution.progress((begin + 1.0) / count))
        throw CIDCancelled();
    }
    return actions;
  }

private:
  /** \return whether it could be done: the last line may have been written down and
   * then not been possible */
  bool
  act(std::size_t action, const ExecutionOptions& execution)
  {
    try {
      session_.apply(record_.actions[action], execution);
      return true;
    }
    catch (const CIDCancelled&) {
      throw;
    }
    catch (const CIDException& error) {
      if (record_.lines[action] == record_.lastLine())
        return false;
      throw CIDException(settings_.session + ": line " +
                         std::to_string(record_.lines[action]) + ": " + error.what());
    }
  }

  ReplayedAction
  told(std::size_t action,
       const std::vector<NamedInstance>& instances_before,
       const Effort& effort_before) const
  {
    ReplayedAction told;
    told.line = record_.lines[action];
    told.word = wordOf(record_.actions[action]);
    told.effort = effort_before;
    std::visit(ActionTeller(instances_before, session_.instances(), told),
               record_.actions[action]);
    return told;
  }

  AnnotationScore
  score(unsigned int threads) const
  {
    std::vector<std::uint32_t> labels = settings_.clean_up
                                            ? session_.cleanedLabels({}, {threads, {}})
                                            : session_.labels();
    return scoreAnnotations(
        {pairedOverlaps(annotationOverlaps(std::move(labels), truth_))});
  }

  const SimulateSettings& settings_;
  const SessionRecord& record_;
  LabelSession session_;
  std::vector<std::uint32_t> truth_;
};

} // namespace

ReplayedSession
scoreSession(const SessionRecord& record, const SimulateSettings& settings, Run& run)
{
  if (record.actions.empty())
    throw CIDException(settings.session +
                       ": nothing was done in this session; there is nothing to score");
  const LoadedScan scan = loadScan(settings, run);
  requireScanOf(record, identityOf(scan.cloud), settings.session);
  std::vector<std::uint32_t> truth = trueLabels(settings, scan, run);

  run.begin("Preparing");
  const ExecutionOptions execution{settings.threads, run.console.progress()};
  LabelSession session = prepareSession(settings, scan, execution);
  run.end(std::to_string(scan.points.finite) + " finite points", "prepare");
  describeDensity(session.scan().density(), run);
  describeBlindSpot(session.scan().blindSpot(), scan.points.frame, run);

  run.begin("Replaying " + settings.session);
  Replay replay(settings, record, std::move(session), std::move(truth));
  std::vector<ReplayedAction> actions = replay.run(execution);
  run.end(std::to_string(actions.size()) + " actions", "replay");

  std::vector<Report::Parameter> used = sessionParametersOf(settings.session, settings);
  used.push_back(parameter(setting::clean_up, settings.clean_up));
  return {scoredScan(settings, scan, std::move(used), run), std::move(actions)};
}

} // namespace pcl_cid::tools
