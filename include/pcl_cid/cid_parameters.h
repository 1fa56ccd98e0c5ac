/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What all classes share that does not depend on the point type.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <pcl/memory.h>
#include <pcl/types.h>

namespace pcl_cid {

/** \brief The color of each point of a cloud. */
using ColorsConstPtr = std::shared_ptr<const std::vector<ColorRGB>>;

/** \brief The settings that all classes of pcl_cid share, and the results they share:
 *  the prepared scan and the grouping.
 *
 *  The settings of the preparation are marked as such: setting one makes the next verb
 *  prepare the input again. No other setting does, so consecutive verbs on one input
 *  prepare it once. Algorithm 1, too, runs again only when one of its settings was
 *  changed, and goes on where only the number of seeds has grown.
 *
 *  Every setter refuses a bad value at once with a CIDException and then changes
 *  nothing. Ranges and defaults: the rows of `setting` (settings.h). */
class PCL_CID_EXPORT CIDParameters {
public:
  using SearchPtr = DistanceField::SearchPtr;

  /** \brief K, the number of seeds. Fewer come back when the cloud has fewer distinct
   *  points. */
  void
  setNumberOfSeeds(int number_of_seeds);

  int
  getNumberOfSeeds() const
  {
    return number_of_seeds_;
  }

  /** \brief Stop adding seeds as soon as every point is within this CID of its seed
   *  (*ours*), metres; 0, the default, never does. Whichever of the two stops comes
   *  first counts, so ask for as many seeds as the guarantee may cost. */
  void
  setCoverage(float coverage);

  float
  getCoverage() const
  {
    return coverage_;
  }

  /** \brief M, the samples on a segment (Eq. 2). */
  void
  setNumberOfSamples(int number_of_samples);

  int
  getNumberOfSamples() const
  {
    return grouping_settings_.samples;
  }

  /** \brief How the next seed is chosen; default SeedingRule::farthest, the paper. */
  void
  setSeedingRule(SeedingRule seeding_rule)
  {
    grouping_settings_.seeding = seeding_rule;
  }

  SeedingRule
  getSeedingRule() const
  {
    return grouping_settings_.seeding;
  }

  /** \brief Work on a random draw of this many points (the paper: 20,000), and let
   *  every other point follow its Euclidean-nearest one; 0, the default, works on all
   *  of them. A setting of the preparation. */
  void
  setSubsample(int subsample);

  int
  getSubsample() const
  {
    return preparation_.subsample;
  }

  /** \brief Seed of every draw (start, subsample, samples of groups). A setting of the
   *  preparation. */
  void
  setRandomSeed(std::uint64_t random_seed);

  std::uint64_t
  getRandomSeed() const
  {
    return preparation_.random_seed;
  }

  /** \brief Begin the traversal at this point of the input cloud instead of a random
   *  one; the verb then requires it to be a finite, selected point. A setting of the
   *  preparation. */
  void
  setStartIndex(pcl::index_t start_index);

  /** \brief Begin at a random point again (the default). */
  void
  resetStartIndex();

  std::optional<pcl::index_t>
  getStartIndex() const
  {
    return preparation_.start_index;
  }

  /** \brief The points of the input cloud that may become seeds; null, the default,
   *  means all that are grouped. Those that are not grouped are skipped. A setting of
   *  the preparation. */
  void
  setSeedCandidates(const pcl::shared_ptr<const pcl::Indices>& seed_candidates);

  pcl::shared_ptr<const pcl::Indices>
  getSeedCandidates() const
  {
    return preparation_.seed_candidates;
  }

  /** \brief Whether CIDs are weighted by `2 / (s(p) + s(q))`, s being the local spacing
   *  of the points: where a scan is sparse, a point is far from the surface without any
   *  concavity. The default, automatic, is on where the spacing is uneven: for a single
   *  depth view or a lidar scan, but not for points drawn evenly. A setting of the
   *  preparation. */
  void
  setDensityWeight(DensityWeight density_weight);

  DensityWeight
  getDensityWeight() const
  {
    return preparation_.density;
  }

  /** \brief The power of the spacing in that weight; 0 means off. A setting of the
   *  preparation. */
  void
  setDensityPower(float density_power);

  float
  getDensityPower() const
  {
    return preparation_.density_power;
  }

  /** \brief A point with fewer others near it is isolated: it never becomes a seed,
   *  unless it is the start or a seed that was given, and does not count in the
   *  coverage, but belongs to a group like all others. 0: no point is isolated. A
   *  setting of the preparation. */
  void
  setIsolatedNeighbors(int isolated_neighbors);

  int
  getIsolatedNeighbors() const
  {
    return preparation_.isolated_neighbors;
  }

  /** \brief What a difference in color adds to the cost of a pair: metres for a unit of
   *  CIE L*a*b* (black to white: 100), the colors being averaged over neighbors; 0, the
   *  default, ignores colors. Above 0 the verbs need colors: from a point type with
   *  `rgb` or `rgba`, or from setColors(). A setting of the preparation. */
  void
  setColorWeight(float color_weight);

  float
  getColorWeight() const
  {
    return preparation_.color;
  }

  /** \brief Colors of the points of the input cloud, one for each; null, the default,
   *  means those of its point type. A setting of the preparation. */
  void
  setColors(const ColorsConstPtr& colors);

  ColorsConstPtr
  getColors() const
  {
    return colors_;
  }

  /** \brief Whether the floor that a scanner hides from itself is a part of the
   *  surface: a disc under the sensor's origin of the input cloud (`sensor_origin_`,
   *  `sensor_orientation_`), where there is such a hole. Points of it belong to no
   *  group. Default true; of no effect with a search surface. A setting of the
   *  preparation. */
  void
  setFillBlindSpot(bool fill_blind_spot);

  bool
  getFillBlindSpot() const
  {
    return preparation_.blind_spot;
  }

  /** \brief What answers nearest-neighbor queries away from the surface; null, the
   *  default, leaves it to pcl_cid and pcl::KdTreeFLANN (see DistanceField). It is
   *  given the surface about a local origin, as PointXYZ; it must be exact and safe for
   *  concurrent queries. A setting of the preparation. */
  void
  setSearchMethod(const SearchPtr& search_method);

  SearchPtr
  getSearchMethod() const
  {
    return preparation_.search_method;
  }

  /** \brief Bytes that the grid of the surface may take (see DistanceField); 0, the
   *  default, means a quarter of the machine's memory. Never changes a result. A
   *  setting of the preparation. */
  void
  setMemoryBudget(std::size_t memory_budget = 0);

  std::size_t
  getMemoryBudget() const
  {
    return preparation_.memory_budget;
  }

  /** \brief Number of threads, at most 1024; 0, the default, means all. */
  void
  setNumberOfThreads(unsigned int number_of_threads = 0);

  unsigned int
  getNumberOfThreads() const
  {
    return number_of_threads_;
  }

  /** \brief Called during every verb (see ProgressCallback); empty, the default, means
   *  none. A verb that was cancelled throws CIDCancelled. */
  void
  setProgressCallback(const ProgressCallback& progress)
  {
    progress_ = progress;
  }

  ProgressCallback
  getProgressCallback() const
  {
    return progress_;
  }

  /** \brief Work on a scan that was prepared elsewhere: by another object, or by
   *  PreparedScan itself. Its settings become those of this object. Setting one of the
   *  preparation, or another input, drops it.
   *
   *  The input cloud, where a verb needs it, must be the one that was prepared.
   *  \throws CIDException when it is null */
  void
  setPreparedScan(const PreparedScan::ConstPtr& scan);

  /** \brief Prepare the input now, unless that is done: what the first verb does.
   *  \return never null
   *  \throws CIDException when the input is missing or unusable, CIDCancelled */
  const PreparedScan::ConstPtr&
  prepare();

  /** \brief The scan that the last verb prepared or that was set; null before. */
  const PreparedScan::ConstPtr&
  getPreparedScan() const
  {
    return scan_;
  }

  /** \brief Seeds and groups of the last verb, for other objects to take; null before.
   *  It never changes: later verbs work on a copy where it is still in use. */
  const Grouping::ConstPtr&
  getGrouping() const
  {
    return grouping_;
  }

  /** \brief Seeds, groups and coverage of the last verb; indices of the input cloud,
   *  groups and CIDs for each of its points. */
  const SeedProposal&
  getProposal() const
  {
    return proposal_;
  }

  /** \brief What the last verb measured about the density of the input, and decided. */
  DensityDecision
  getDensityDecision() const
  {
    return scan_ ? scan_->density() : DensityDecision();
  }

  /** \brief The blind spot that the last verb filled, if any. */
  std::optional<FilledBlindSpot>
  getBlindSpot() const
  {
    return scan_ ? scan_->blindSpot() : std::nullopt;
  }

protected:
  CIDParameters() = default;
  CIDParameters(const CIDParameters&) = default;
  CIDParameters&
  operator=(const CIDParameters&) = default;
  virtual ~CIDParameters() = default;

  /** \brief The input as it is now.
   *  \throws CIDException when there is none, or it is unusable */
  virtual RawScan
  gatherScan() const = 0;

  /** \brief Threads, and the callback told fractions from \a begin to \a end: the share
   *  of a verb that one of its steps makes up. */
  ExecutionOptions
  execution(double begin, double end) const;

  /** \brief The input or a setting of the preparation has changed: drop what was
   *  computed. */
  void
  forgetScan();

  /** \brief Let a verb keep exact CIDs in the proposal. */
  void
  setKeepCIDs(bool keep_cid)
  {
    grouping_settings_.keep_cid = keep_cid;
  }

  bool
  keepsCIDs() const
  {
    return grouping_settings_.keep_cid;
  }

  /** \brief Algorithm 1 by the settings; warns when fewer seeds than asked for come
   *  back.
   *  \param[in] caller class and verb, for the warning */
  void
  proposeSeeds(const char* caller, const ExecutionOptions& execution);

  /** \brief Go on with Algorithm 1.
   *  \throws CIDException when there is nothing to go on from */
  void
  extendSeeds(int number_of_seeds,
              const char* caller,
              const ExecutionOptions& execution);

  /** \brief Groups by given seeds, unless there are these already.
   *  \param[in] seeds distinct points of the input cloud */
  void
  groupBySeeds(const pcl::Indices& seeds, const ExecutionOptions& execution);

  /** \brief Groups by given seeds, in a subsample that holds them: the object is as
   *  before when an exception is thrown. */
  void
  regroup(const pcl::Indices& seeds, const ExecutionOptions& execution);

  /** \brief Take the result of a verb back: a later step of it has failed. */
  void
  clearProposal()
  {
    proposal_ = SeedProposal();
  }

  /** \brief Take over the groups of another object, and its scan: they stand in the
   *  place of what proposeSeeds() would find.
   *  \throws CIDException when it is null */
  void
  adoptGrouping(const Grouping::ConstPtr& grouping);

  /** \brief The grouping of the last verb, for changing: a copy where others hold it,
   *  too. publish() makes it the result. */
  std::shared_ptr<Grouping>
  changeableGrouping() const;

  void
  publish(const std::shared_ptr<Grouping>& grouping, const ExecutionOptions& execution);

private:
  /** What the grouping was proposed for. */
  struct Request {
    int seeds;
    float coverage;
  };

  bool
  fits(const Grouping& grouping) const;

  bool
  canGoOn() const;

  bool
  holdsInSubsample(const pcl::Indices& seeds) const;

  PreparedScan::ConstPtr
  scanThatHolds(const pcl::Indices& seeds) const;

  void
  takeScan(const PreparedScan::ConstPtr& scan);

  void
  publish(const ExecutionOptions& execution);

  void
  warnIfShort(const char* caller, std::size_t wanted) const;

  int number_of_seeds_ = setting::seeds.initial;
  float coverage_ = setting::coverage.initial;
  PreparationSettings preparation_;
  GroupingSettings grouping_settings_;
  ColorsConstPtr colors_;
  unsigned int number_of_threads_ = setting::threads.initial;
  ProgressCallback progress_;

  PreparedScan::ConstPtr scan_;
  bool scan_is_given_ = false;
  Grouping::ConstPtr grouping_;
  bool grouping_is_given_ = false;
  std::shared_ptr<Grouping> own_;   ///< the same, where it was made here
  std::optional<Request> proposed_; ///< none: the seeds were given, or there is nothing
  SeedProposal proposal_;
};

} // namespace pcl_cid
