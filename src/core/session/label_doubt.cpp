/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where the labels of a session may be wrong.
 */

#include "inmost_point.h"
#include "radius_graph.h"

#include "base/infinity.h"
#include "base/joined_sets.h"
#include "base/parallel_for.h"
#include "base/requirements.h"
#include "base/sentence.h"
#include "cid/cost_search.h"
#include "cid/working_points.h"

#include <pcl_cid/core/label_doubt.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace pcl_cid {
namespace {

/** Points that a thread takes at a time. */
constexpr std::size_t compared_at_a_time = 256;

constexpr float no_margin = std::numeric_limits<float>::quiet_NaN();

Points
positionsOf(const PreparedScan& scan, const pcl::Indices& working)
{
  Points positions;
  for (const pcl::index_t i : working)
    positions.push_back(scan.working().points()[static_cast<std::size_t>(i)]);
  return positions;
}

} // namespace

/** \brief The points that are looked at, and which of them are neighbors. */
class SampleGraph {
public:
  SampleGraph(Points points, const ExecutionOptions& execution)
  : silent_({})
  , points_(std::move(points))
  , tree_(points_, threadCount(execution.threads), silent_)
  , graph_(points_, tree_, execution)
  {
  }

  /** The set of each point that hangs together, by its earliest point.
   *  \param[in] is_in whether a point belongs to any */
  template <typename IsIn>
  std::vector<std::uint32_t>
  connectedSets(const IsIn& is_in) const
  {
    return joinedSets(points_.size(), [&](const auto& join) {
      for (std::size_t i = 0; i < points_.size(); ++i)
        if (is_in(i))
          for (const pcl::index_t j : graph_.earlierNeighbors(i))
            if (is_in(static_cast<std::size_t>(j)))
              join(i, static_cast<std::size_t>(j));
    });
  }

  pcl::index_t
  inmostOf(const pcl::Indices& region) const
  {
    return InmostPoints(points_, tree_).of({region}, 1).front().point;
  }

private:
  Progress silent_;
  const Points points_;
  BlockTree tree_;
  RadiusGraph graph_;
};

LabelDoubt::LabelDoubt(PreparedScan::ConstPtr scan,
                       int samples,
                       const pcl::Indices& points,
                       const ExecutionOptions& execution)
: scan_(std::move(scan)), samples_(samples), points_(points), order_(points.size())
{
  require(setting::samples, samples);
  if (!scan_)
    throw CIDException("there is no prepared scan whose labels may be in doubt");
  if (points.empty())
    throw CIDException("there is no point to look at; at least 1 is needed");
  std::set<pcl::index_t> known;
  for (const pcl::index_t point : points) {
    working_.push_back(scan_->workingIndex(point, "point to look at"));
    if (!known.insert(point).second)
      throw CIDException(
          sentence("point ", point, " to look at was given twice; give each once"));
  }
  const auto slot = [&](std::size_t i) {
    return scan_->working().slotOf(static_cast<std::size_t>(working_[i]));
  };
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    return slot(a) < slot(b);
  });
  graph_ = std::make_unique<SampleGraph>(positionsOf(*scan_, working_), execution);
}

LabelDoubt::~LabelDoubt() = default;

std::vector<float>
LabelDoubt::margins(const LabelSession& session, const ExecutionOptions& execution)
{
  if (&session.scan() != scan_.get() ||
      session.grouping().settings().samples != samples_)
    throw CIDException("the session is of another scan, or has other settings, than "
                       "what tells the doubt of its labels");
  const std::vector<SessionSeed> seeds = session.seeds();
  updateCosts(seeds, execution);
  std::vector<float> margins(points_.size(), no_margin);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto group = session.groups()[static_cast<std::size_t>(points_[i])];
    if (group < 0 || session.isPainted(points_[i]))
      continue;
    const std::optional<std::uint32_t> own =
        seeds[static_cast<std::size_t>(group)].label;
    if (!own)
      continue;
    float nearest_own = infinity;
    float nearest_other = infinity;
    for (const SessionSeed& seed : seeds)
      if (seed.label) {
        float& nearest = seed.label == own ? nearest_own : nearest_other;
        nearest = std::min(nearest, costs_.at(seed.point)[i]);
      }
    if (nearest_other < infinity)
      margins[i] = nearest_other - nearest_own;
  }
  return margins;
}

/** Find out the costs of the seeds that have a label, and forget those that are no
 *  seeds any more. */
void
LabelDoubt::updateCosts(const std::vector<SessionSeed>& seeds,
                        const ExecutionOptions& execution)
{
  std::map<pcl::index_t, Costs> costs;
  double done = 0.0;
  for (const SessionSeed& seed : seeds) {
    const double begin = done / static_cast<double>(seeds.size());
    const double end = ++done / static_cast<double>(seeds.size());
    const auto known = costs_.find(seed.point);
    if (known == costs_.end() && seed.label)
      costs_[seed.point] = costsOf(seed.point, partOf(execution, begin, end));
  }
  for (const SessionSeed& seed : seeds)
    if (const auto known = costs_.find(seed.point); known != costs_.end())
      costs.insert(costs_.extract(known));
  costs_ = std::move(costs);
}

LabelDoubt::Costs
LabelDoubt::costsOf(pcl::index_t seed, const ExecutionOptions& execution) const
{
  const auto q = static_cast<std::size_t>(scan_->workingIndex(seed, "seed"));
  const WorkingPoints& points = scan_->working();
  const SampleOrder sample_order(samples_);
  Costs costs(points_.size());
  Progress progress(execution.progress);
  const auto compare = [&](std::size_t begin, std::size_t end) {
    SegmentSearch search(points.field(), sample_order);
    std::size_t hint = sample_order.last() / 2;
    for (std::size_t k = begin; k < end; ++k) {
      const auto p = static_cast<std::size_t>(working_[order_[k]]);
      const Segment segment{
          points.points()[q], points.points()[p], points.areOnSurface()};
      costs[order_[k]] =
          searchCost(search, segment, points.costs().between(q, p), infinity, hint);
    }
  };
  parallelFor(points_.size(),
              compared_at_a_time,
              threadCount(execution.threads),
              progress,
              {0.0, 1.0},
              compare);
  return costs;
}

std::optional<DoubtfulArea>
LabelDoubt::area(const std::vector<float>& margins, float below, std::size_t rank) const
{
  if (margins.size() != points_.size())
    throw CIDException(sentence("there are ",
                                margins.size(),
                                " margins; there must be one for each of the ",
                                points_.size(),
                                " points that are looked at"));
  const auto is_doubtful = [&](std::size_t i) { return margins[i] < below; };
  const std::vector<std::uint32_t> set_of = graph_->connectedSets(is_doubtful);
  std::map<std::uint32_t, pcl::Indices> members; // by set
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (is_doubtful(i))
      members[set_of[i]].push_back(static_cast<pcl::index_t>(i));
  if (rank >= members.size())
    return std::nullopt;
  std::vector<const pcl::Indices*> by_size;
  for (const auto& [set, each] : members)
    by_size.push_back(&each);
  std::stable_sort(by_size.begin(), by_size.end(), [](const auto* a, const auto* b) {
    return a->size() > b->size();
  });
  const pcl::Indices& chosen = *by_size[rank];
  DoubtfulArea area{points_[static_cast<std::size_t>(graph_->inmostOf(chosen))], {}};
  for (const pcl::index_t i : chosen)
    area.points.push_back(points_[static_cast<std::size_t>(i)]);
  return area;
}

} // namespace pcl_cid
