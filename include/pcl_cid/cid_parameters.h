/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What all classes share that does not depend on the point type.
 */

#pragma once

#include <pcl_cid/cid_preparation_parameters.h>
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

/** \brief The settings that all classes of pcl_cid share, and the results they share:
 *  the prepared scan and the grouping.
 *
 *  Only a new input and the settings of the preparation make the next verb (a call that
 *  works: sample(), segment() ...) prepare the input again, so consecutive verbs on one
 *  input prepare it once. Algorithm 1, too, runs again only when one of its settings
 *  was changed, and goes on where only the number of seeds has grown.
 *
 *  Every setter refuses a bad value at once with a CIDException and then changes
 *  nothing. Ranges and defaults: the rows of `setting` (settings.h). */
class PCL_CID_EXPORT CIDParameters : public CIDPreparationParameters {
public:
  void
  setPaperSettings() override;

  /** \brief K, the number of seeds. Fewer come back when no other point would gain by
   *  being one, or the coverage is reached. */
  void
  setNumberOfSeeds(int number_of_seeds);

  int
  getNumberOfSeeds() const
  {
    return number_of_seeds_;
  }

  /** \brief Stop adding seeds as soon as every point is within this CID of its seed
   *  (*ours*), metres; 0, the default: no such stop. Whichever of the two stops comes
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

  /** \brief The settings by which points are compared with seeds, as Grouping takes
   *  them: for a grouping of one's own on what prepare() returns. */
  const GroupingSettings&
  getGroupingSettings() const
  {
    return grouping_settings_;
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

  /** \brief Seeds and groups of the last verb that had any, for other objects to take;
   *  null before.
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
  ~CIDParameters() override = default;

  /** \brief The input as it is now.
   *  \throws CIDException when there is none, or it is unusable */
  virtual RawScan
  gatherScan() const = 0;

  /** \brief Threads, and the callback told fractions from \a begin to \a end: the share
   *  of a verb that one of its steps makes up. */
  ExecutionOptions
  execution(double begin, double end) const;

  void
  forgetScan() override;

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

  /** \brief Take the proposal of a verb back: a later step of it has failed, or the
   * next verb has no seeds. */
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

  /** \brief For verbs that do without groups of seeds.
   *  \throws CIDException when adoptGrouping() has given some that count */
  void
  requireNoGrouping() const;

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
  GroupingSettings grouping_settings_;
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
