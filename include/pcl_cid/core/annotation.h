/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A simulated annotator: what a few clicks with true labels make of a scan.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/instance_overlaps.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief A scan and its truth, which an annotator is asked for. A click is a seed with
 *  its true label; every point has the label of its seed. */
struct AnnotationTask {
  /** Not null. With a subsample, only the points that were drawn are clicked on. */
  PreparedScan::ConstPtr scan;
  GroupingSettings grouping;
  /** Whether the annotator sees, and is scored by, labels with their boundaries mended:
   *  see cleanBoundaries(). */
  bool clean_up = setting::clean_up.initial;
  /** The true instance of each point of the cloud; 0 for none, which is never wrong. */
  std::vector<std::uint32_t> truth;
};

/** \brief What the labels are worth after some clicks. */
struct AnnotationState {
  /** Clicks that were made: fewer than asked for where nothing is wrong any more, or
   *  nothing is left to propose. */
  std::size_t clicks = 0;
  /** Each true instance, and all points that have its label, of those with a true one:
   *  see sameLabelOverlaps(). */
  InstanceOverlaps overlaps;
};

/** \brief The protocol of the paper: Algorithm 1 proposes where to click.
 *  \param[in] counts numbers of clicks, ascending, each at least 1
 *  \return the state at each of them
 *  \throws CIDException when a number is not allowed, when there is not a true label
 *  for each point of the cloud, or when no point has one but 0; CIDCancelled
 *  \note Cost: that of Grouping::propose(). */
PCL_CID_EXPORT std::vector<AnnotationState>
annotateProposals(const AnnotationTask& task,
                  const std::vector<std::size_t>& counts,
                  const ExecutionOptions& execution = {});

/** \brief An annotator who looks at the labels and clicks where most is wrong.
 *
 *  A region is a largest set of points with the same true and the same predicted label
 *  that is connected: two points are neighbors when each is within two local spacings
 *  of the other, the local spacing being the distance to the eighth place. The click is
 *  in the region with most points, on its point that is farthest from all points
 *  outside (in a region with no outside: its first). The first click, where nothing was
 *  proposed, is in the instance with most points. At equal numbers or distances the
 *  lowest index counts.
 *
 *  A point that is a seed has its true label and is never wrong, so none is clicked on
 *  twice, and all is right after at most as many clicks as there are points.
 *  \param[in] proposals clicks that Algorithm 1 proposes before the others; 0 for none
 *  \note Cost: each click that of Grouping::addSeeds(), with `clean_up` that of
 *  cleanBoundaries(), and linear in the points but for the search of the point to click
 *  on, which is about N log N. About 150 bytes a point.
 *  \see annotateProposals() for the rest */
PCL_CID_EXPORT std::vector<AnnotationState>
annotateCorrections(const AnnotationTask& task,
                    const std::vector<std::size_t>& counts,
                    std::size_t proposals,
                    const ExecutionOptions& execution = {});

/** \brief An annotator who clicks where labels are in doubt (*ours*), right or wrong:
 *  nobody has to look for mistakes.
 *
 *  A click is on the DoubtfulArea::point of the largest area of doubt that is no seed
 *  yet. LabelDoubt::enough_points of the points are looked at, or all, and in doubt are
 *  the 6 % of them with the least margins. Where nothing is in doubt, the click is on
 *  what Algorithm 1 proposes.
 *
 *  \note Cost: each click as with annotateCorrections(), and what LabelDoubt needs.
 *
 *  \see annotateCorrections() for the rest */
PCL_CID_EXPORT std::vector<AnnotationState>
annotateDoubts(const AnnotationTask& task,
               const std::vector<std::size_t>& counts,
               std::size_t proposals,
               const ExecutionOptions& execution = {});

/** \brief How annotateVoxels() works. */
struct VoxelAnnotationOptions {
  /** Side of a voxel, metres; above 0. */
  float voxel = 0.05f;
  /** The most clicks for each true instance, on average; at least 1. */
  std::size_t clicks_per_instance = 20;
};

/** \brief The protocol of AGILE3D (Yue et al., ICLR 2024) for several objects, every
 *  instance being one: there is no background.
 *
 *  The annotator sees voxels, each as its first point. A region is all voxels with the
 *  same true and the same predicted label, connected or not; its size is the largest
 *  distance from one of them to the nearest voxel outside, and there the click is. In
 *  the first round each region gets a click, in each later one the largest region.
 *  Every point has the label of its voxel.
 *  \return the state after each round
 *  \throws CIDException as annotateProposals(), and when an option is not allowed;
 *  CIDCancelled */
PCL_CID_EXPORT std::vector<AnnotationState>
annotateVoxels(const AnnotationTask& task,
               const VoxelAnnotationOptions& options = {},
               const ExecutionOptions& execution = {});

/** \brief What labels have in common with the truth, all instances being of one class.
 *  Points without a true label do not count: nobody can tell whether theirs is right.
 *
 *  It goes through sameLabelOverlaps() where the labels are those of the truth, and
 *  through pairedOverlaps() where they are a person's numbers, before it is scored.
 *  \param[in] labels of each point, 0 for none
 *  \param[in] truth the same of the true instances
 *  \throws CIDException when the lists differ in length */
PCL_CID_EXPORT InstanceOverlaps
annotationOverlaps(std::vector<std::uint32_t> labels,
                   const std::vector<std::uint32_t>& truth);

/** \brief Scores over all true instances of one or more scans; NaN where there are
 *  none. */
struct AnnotationScore {
  std::size_t instances = 0;
  /** Mean IoU of an instance with the points that have its label. */
  double mean_iou = 0.0;
  /** Share of the instances with an IoU of at least 0.25, 0.50 and 0.75. */
  double recall25 = 0.0;
  double recall50 = 0.0;
  double recall75 = 0.0;
  /** Average precision at IoU above 0.50, all instances being of one class; that of
   *  EvaluationProtocol::paper where labels are those of the truth. */
  double ap50 = 0.0;
};

/** \brief Score scans, pooled.
 *  \param[in] scans `overlaps` of a state of each, or others of class 1 in which no
 *  instance has two overlaps */
PCL_CID_EXPORT AnnotationScore
scoreAnnotations(const std::vector<InstanceOverlaps>& scans);

/** \brief `IoU@k`: the mean IoU of a scan at k clicks for each instance, on average:
 *  that of the last state with no more clicks.
 *  \param[in] states of one scan, at least one, as annotateVoxels() returns them */
PCL_CID_EXPORT double
meanIouAt(const std::vector<AnnotationState>& states, double clicks_per_instance);

/** \brief `NoC@q`: the clicks for each instance, on average, with which the mean IoU of
 *  a scan is q for the first time.
 *  \param[in] budget what is returned where it never is */
PCL_CID_EXPORT double
clicksToReach(const std::vector<AnnotationState>& states, double iou, double budget);

} // namespace pcl_cid
