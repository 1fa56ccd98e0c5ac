/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The kinds of work that are measured.
 */

#pragma once

#include "benchmark_cloud.h"
#include "child_process.h"

#include <string>

namespace pcl_cid::benchmarks {

/** \brief One kind of work with its settings. */
struct Work {
  /** See isWork(). */
  std::string name = "segment";
  /** K. */
  int seeds = 100;
  /** M. */
  int samples = 100;
  unsigned int threads = 2;
  /** Only for `literal`: the seeds that `segment` found, indices of the cloud. */
  pcl::Indices given_seeds;
  /** Only for `literal`: how long to go on with pairs. */
  double literal_seconds = 15.0;
};

/** \brief Whether there is such a work:
 *  \li `segment`: CIDLabelPropagation::segment, from the cloud to the labels
 *  \li `defaults`: the same with the defaults, which look at the density of the scan;
 *  all else is done with the settings of the paper
 *  \li `sample`: CIDSampler::sample, seeds and groups with the CID of every point
 *  \li `extend`: CIDSampler::extend by the last ten of the K seeds, nothing else
 *  \li `seeds`: Algorithm 1 on a field that is there already
 *  \li `merge`: the matrix of group CIDs and Algorithm 2, nothing else
 *  \li `cut`: as `merge`, stopped at 30 parts
 *  \li `literal`: LiteralMethod on random pairs of a point and a seed, in runs of 16
 *  consecutive points, scaled up to all pairs; building the tree counts and is not
 *  scaled
 *  \li `check`: not a measurement; LiteralMethod for some points and all seeds must
 *  find the groups that `segment` finds
 *  \li `handle`: labels and 30 hulls from the groups that CIDSampler has found
 *  \li `hulls`, `fit`: 60 hulls from the cloud, by CID and by hull
 *  \li `read_pcd`, `read_ascii_pcd`, `read_ply`: the cloud from a file of its points;
 *  `pcl_pcd` and so on: the same by PCL
 *  \li `add`, `remove`: one seed joins, or leaves, a grouping with K seeds; the median
 * of 100 */
bool
isWork(const std::string& name);

/** \brief Whether given_seeds are needed. */
bool
needsSeeds(const Work& work);

/** \brief Do the work in this process and take the time.
 *  \throws std::runtime_error when a check fails, and what the library throws */
Measurement
perform(const Work& work, const Cloud::ConstPtr& cloud);

} // namespace pcl_cid::benchmarks
