/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Two simulated annotators: one clicks where it is asked, one where most is wrong.
 */

#include "base/sentence.h"
#include "cid/working_points.h"

#include "clicked_session.h"
#include "session/inmost_point.h"
#include "session/radius_graph.h"
#include "wrong_regions.h"
#include <pcl_cid/exceptions.h>

#include <algorithm>

namespace pcl_cid {
namespace {

void
requireCounts(const std::vector<std::size_t>& counts)
{
  if (counts.empty())
    throw CIDException("there is no number of clicks; at least 1 is needed");
  std::size_t before = 0;
  for (const std::size_t count : counts) {
    if (count <= before)
      throw CIDException(sentence("a number of clicks is ",
                                  count,
                                  " after ",
                                  before,
                                  "; the numbers must be at least 1 and ascend"));
    before = count;
  }
}

/** How far this number of clicks is on the way to the last. */
double
share(std::size_t clicks, const std::vector<std::size_t>& counts)
{
  return static_cast<double>(clicks) / static_cast<double>(counts.back());
}

/** The annotator who corrects. */
class Corrections {
public:
  Corrections(ClickedSession& clicked, const ExecutionOptions& execution)
  : clicked_(clicked)
  , threads_(execution.threads)
  , graph_(
        clicked.scan().working().points(), clicked.scan().working().tree(), execution)
  , inmost_points_(clicked.scan().working().points(), clicked.scan().working().tree())
  {
  }

  /** Click once, unless nothing is wrong.
   *  \return whether there was a click */
  bool
  click()
  {
    const pcl::Indices region =
        clicked_.clicks() == 0
            ? largestInstance(clicked_.truth())
            : largestConnectedWrongRegion(graph_, clicked_.truth(), clicked_.labels());
    if (region.empty())
      return false;
    clicked_.click({inmost_points_.of({region}, threads_).front().point},
                   {threads_, {}});
    return true;
  }

private:
  ClickedSession& clicked_;
  unsigned int threads_;
  RadiusGraph graph_;
  InmostPoints inmost_points_;
};

} // namespace

std::vector<AnnotationState>
annotateProposals(const AnnotationTask& task,
                  const std::vector<std::size_t>& counts,
                  const ExecutionOptions& execution)
{
  requireCounts(counts);
  ClickedSession clicked(task, ClickedSession::Looks::rare);
  std::vector<AnnotationState> states;
  double done = 0.0; // of the progress
  for (const std::size_t count : counts) {
    const double end = share(count, counts);
    clicked.propose(count, partOf(execution, done, end));
    done = end;
    states.push_back(clicked.state());
  }
  return states;
}

std::vector<AnnotationState>
annotateCorrections(const AnnotationTask& task,
                    const std::vector<std::size_t>& counts,
                    std::size_t proposals,
                    const ExecutionOptions& execution)
{
  requireCounts(counts);
  ClickedSession clicked(task, ClickedSession::Looks::after_click);
  Corrections corrections(clicked, partOf(execution, 0.0, 0.0));
  Progress progress(execution.progress);
  std::vector<AnnotationState> states;
  double done = 0.0; // of the progress
  for (const std::size_t count : counts) {
    const std::size_t proposed = std::min(count, proposals);
    if (clicked.clicks() < proposed) {
      const double end = share(proposed, counts);
      clicked.propose(proposed, partOf(execution, done, end));
      done = end;
    }
    while (clicked.clicks() < count && corrections.click())
      progress.check(std::max(done, share(clicked.clicks(), counts)));
    done = std::max(done, share(clicked.clicks(), counts));
    states.push_back(clicked.state());
  }
  return states;
}

} // namespace pcl_cid
