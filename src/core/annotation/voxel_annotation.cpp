/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The protocol of AGILE3D, on voxels.
 */

#include "base/parallel_for.h"
#include "base/sentence.h"
#include "cid/working_points.h"

#include "clicked_session.h"
#include "session/inmost_point.h"
#include "wrong_regions.h"
#include <pcl_cid/exceptions.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace pcl_cid {
namespace {

/** The voxels that have a point. */
struct Voxels {
  pcl::Indices first;          ///< the point of lowest index, of each voxel
  std::vector<std::size_t> of; ///< the voxel of each point
};

/** In the order of their first points. */
Voxels
findVoxels(const Points& points, float side)
{
  Voxels voxels;
  std::map<std::array<double, 3>, std::size_t> known;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Array3d cell =
        (points[i].cast<double>().array() / double{side}).floor();
    const auto [voxel, is_new] =
        known.emplace(std::array{cell.x(), cell.y(), cell.z()}, voxels.first.size());
    if (is_new)
      voxels.first.push_back(static_cast<pcl::index_t>(i));
    voxels.of.push_back(voxel->second);
  }
  return voxels;
}

template <typename Value>
std::vector<Value>
valuesAt(const pcl::Indices& indices, const std::vector<Value>& values)
{
  std::vector<Value> chosen;
  chosen.reserve(indices.size());
  for (const pcl::index_t i : indices)
    chosen.push_back(values[static_cast<std::size_t>(i)]);
  return chosen;
}

void
requireOptions(const VoxelAnnotationOptions& options)
{
  if (!(options.voxel > 0.0f) || !std::isfinite(options.voxel))
    throw CIDException(sentence(
        "the side of a voxel is ", options.voxel, "; it must be above 0 and finite"));
  if (options.clicks_per_instance == 0)
    throw CIDException("the number of clicks for each instance is 0; it must be at "
                       "least 1");
}

/** The annotator, who sees voxels by their first points. */
class VoxelAnnotator {
public:
  VoxelAnnotator(ClickedSession& clicked, float side, unsigned int threads)
  : clicked_(clicked)
  , threads_(threads)
  , voxels_(findVoxels(clicked.scan().working().points(), side))
  , truth_(valuesAt(voxels_.first, clicked.truth()))
  , silent_({})
  , points_(valuesAt(voxels_.first, clicked.scan().working().points()))
  , tree_(points_, threadCount(threads), silent_)
  , inmost_points_(points_, tree_)
  {
  }

  /** The point to click on of each region. */
  std::vector<InmostPoint>
  targets()
  {
    std::vector<InmostPoint> found = inmost_points_.of(
        wrongRegions(truth_, valuesAt(voxels_.first, clicked_.labels())), threads_);
    for (InmostPoint& each : found)
      each.point = voxels_.first[static_cast<std::size_t>(each.point)];
    return found;
  }

  /** Click in each region. */
  void
  clickAll(const ExecutionOptions& execution)
  {
    pcl::Indices points;
    for (const InmostPoint& target : targets())
      points.push_back(target.point);
    clicked_.click(points, execution);
  }

  /** Click in the largest region.
   *  \return whether there is one */
  bool
  clickLargest()
  {
    InmostPoint largest;
    for (const InmostPoint& target : targets())
      if (target.squared_distance > largest.squared_distance ||
          (target.squared_distance == largest.squared_distance &&
           target.point < largest.point))
        largest = target;
    if (largest.point < 0)
      return false;
    clicked_.click({largest.point}, {threads_, {}});
    return true;
  }

  /** With the labels of voxels on all of their points. */
  AnnotationState
  state() const
  {
    const Labels of_voxels = valuesAt(voxels_.first, clicked_.labels());
    Labels labels;
    labels.reserve(voxels_.of.size());
    for (const std::size_t voxel : voxels_.of)
      labels.push_back(of_voxels[voxel]);
    return clicked_.state(labels);
  }

private:
  ClickedSession& clicked_;
  unsigned int threads_;
  Voxels voxels_;
  Labels truth_; ///< of voxels
  Progress silent_;
  Points points_; ///< of voxels
  BlockTree tree_;
  InmostPoints inmost_points_;
};

} // namespace

std::vector<AnnotationState>
annotateVoxels(const AnnotationTask& task,
               const VoxelAnnotationOptions& options,
               const ExecutionOptions& execution)
{
  requireOptions(options);
  ClickedSession clicked(task, ClickedSession::Looks::after_click);
  VoxelAnnotator annotator(clicked, options.voxel, execution.threads);
  Progress progress(execution.progress);
  annotator.clickAll(partOf(execution, 0.0, 0.0));
  std::vector<AnnotationState> states{annotator.state()};
  const std::size_t budget =
      options.clicks_per_instance * states.front().overlaps.truths.size();
  while (clicked.clicks() < budget && annotator.clickLargest()) {
    states.push_back(annotator.state());
    progress.check(static_cast<double>(clicked.clicks()) / static_cast<double>(budget));
  }
  return states;
}

} // namespace pcl_cid
