/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Simulated annotators: one clicks where Algorithm 1 asks, one where most is wrong, one
 * where there is most doubt.
 */

#include "base/sentence.h"
#include "cid/working_points.h"
#include "scan/working_set.h"

#include "clicked_session.h"
#include "session/inmost_point.h"
#include "session/radius_graph.h"
#include "wrong_regions.h"
#include <pcl_cid/core/label_doubt.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_cid {
namespace {

/** Share of the points that are in doubt, as in pcl_cid_studio. */
constexpr double doubtful_share = 0.06;

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

/** The annotator who goes where labels are in doubt. */
class Doubts {
public:
  Doubts(ClickedSession& clicked, unsigned int threads)
  : clicked_(clicked)
  , threads_(threads)
  , doubt_(clicked.session().grouping().sharedScan(),
           clicked.session().grouping().settings().samples,
           pointsToLookAt(clicked.scan()),
           {threads, {}})
  {
  }

  /** Click once, on what is proposed where nothing is in doubt.
   *  \return whether there was a click */
  bool
  click()
  {
    const std::size_t before = clicked_.clicks();
    if (const std::optional<pcl::index_t> point = mostDoubtful())
      clicked_.click({clicked_.scan().workingIndex(*point, "point")}, {threads_, {}});
    else
      clicked_.propose(before + 1, {threads_, {}});
    return clicked_.clicks() > before;
  }

private:
  /** Some of all, evenly; of the cloud. */
  static pcl::Indices
  pointsToLookAt(const PreparedScan& scan)
  {
    const std::size_t size = scan.working().size();
    const std::size_t count = std::min(size, LabelDoubt::enough_points);
    pcl::Indices points;
    for (std::size_t k = 0; k < count; ++k)
      points.push_back(
          scan.workingSet().cloudIndexOf(static_cast<pcl::index_t>(k * size / count)));
    return points;
  }

  /** In the largest area whose inmost point is no seed yet. */
  std::optional<pcl::index_t>
  mostDoubtful()
  {
    const std::vector<float> margins =
        doubt_.margins(clicked_.session(), {threads_, {}});
    const float limit = limitOf(margins);
    const pcl::Indices seeds = clicked_.session().grouping().seeds();
    for (std::size_t rank = 0;; ++rank) {
      const auto area = doubt_.area(margins, limit, rank);
      if (!area)
        return std::nullopt;
      if (std::find(seeds.begin(), seeds.end(), area->point) == seeds.end())
        return area->point;
    }
  }

  /** The margin that the given share of the points is below. */
  static float
  limitOf(std::vector<float> margins)
  {
    const auto is_none = [](float margin) { return std::isnan(margin); };
    margins.erase(std::remove_if(margins.begin(), margins.end(), is_none),
                  margins.end());
    if (margins.empty())
      return 0.0f;
    const auto nth =
        margins.begin() + static_cast<std::ptrdiff_t>(
                              doubtful_share * static_cast<double>(margins.size()));
    std::nth_element(margins.begin(), nth, margins.end());
    return *nth;
  }

  ClickedSession& clicked_;
  unsigned int threads_;
  LabelDoubt doubt_;
};

/** Click as often as is asked for: first on what is proposed.
 *  \param[in] click clicks once; returns whether there was anything to click on */
template <typename Click>
std::vector<AnnotationState>
annotate(ClickedSession& clicked,
         const std::vector<std::size_t>& counts,
         std::size_t proposals,
         const ExecutionOptions& execution,
         const Click& click)
{
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
    while (clicked.clicks() < count && click())
      progress.check(std::max(done, share(clicked.clicks(), counts)));
    done = std::max(done, share(clicked.clicks(), counts));
    states.push_back(clicked.state());
  }
  return states;
}

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
  return annotate(
      clicked, counts, proposals, execution, [&] { return corrections.click(); });
}

std::vector<AnnotationState>
annotateDoubts(const AnnotationTask& task,
               const std::vector<std::size_t>& counts,
               std::size_t proposals,
               const ExecutionOptions& execution)
{
  requireCounts(counts);
  ClickedSession clicked(task, ClickedSession::Looks::after_click);
  Doubts doubts(clicked, execution.threads);
  return annotate(
      clicked, counts, proposals, execution, [&] { return doubts.click(); });
}

} // namespace pcl_cid
