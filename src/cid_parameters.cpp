/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What all classes share that does not depend on the point type.
 */

#include <pcl_cid/cid_parameters.h>
#include <pcl_cid/exceptions.h>

#include <pcl/console/print.h>

#include <utility>

namespace pcl_cid {

void
CIDParameters::setPaperSettings()
{
  CIDPreparationParameters::setPaperSettings();
  setSeedingRule(setting::seeding.paper());
}

void
CIDParameters::setNumberOfSeeds(int number_of_seeds)
{
  require(setting::seeds, number_of_seeds);
  number_of_seeds_ = number_of_seeds;
}

void
CIDParameters::setCoverage(float coverage)
{
  require(setting::coverage, coverage);
  coverage_ = coverage;
}

void
CIDParameters::setNumberOfSamples(int number_of_samples)
{
  require(setting::samples, number_of_samples);
  grouping_settings_.samples = number_of_samples;
}

void
CIDParameters::setNumberOfThreads(unsigned int number_of_threads)
{
  require(setting::threads, number_of_threads);
  number_of_threads_ = number_of_threads;
}

ExecutionOptions
CIDParameters::execution(double begin, double end) const
{
  return partOf({number_of_threads_, progress_}, begin, end);
}

void
CIDParameters::forgetScan()
{
  // A subsample is drawn anew, without seeds of before.
  PreparationSettings settings = preparation();
  settings.required.clear();
  adoptPreparation(settings);
  scan_.reset();
  scan_is_given_ = false;
  grouping_.reset();
  grouping_is_given_ = false;
  own_.reset();
  proposed_.reset();
  proposal_ = SeedProposal();
}

void
CIDParameters::setPreparedScan(const PreparedScan::ConstPtr& scan)
{
  if (!scan)
    throw CIDException("the prepared scan is null; it must be one");
  forgetScan();
  adoptPreparation(scan->settings());
  scan_ = scan;
  scan_is_given_ = true;
}

const PreparedScan::ConstPtr&
CIDParameters::prepare()
{
  if (!scan_)
    scan_ = std::make_shared<const PreparedScan>(
        gatherScan(), preparation(), execution(0.0, 0.0));
  return scan_;
}

/** Whether there is a scan for some seeds: a subsample that is drawn here holds those
 *  that were given, and is drawn again for others. */
bool
CIDParameters::holdsInSubsample(const pcl::Indices& seeds) const
{
  return scan_ && (scan_is_given_ || preparation().subsample == 0 ||
                   preparation().required == seeds);
}

PreparedScan::ConstPtr
CIDParameters::scanThatHolds(const pcl::Indices& seeds) const
{
  if (holdsInSubsample(seeds))
    return scan_;
  PreparationSettings settings = preparation();
  settings.required = seeds;
  return std::make_shared<const PreparedScan>(
      gatherScan(), settings, execution(0.0, 0.0));
}

void
CIDParameters::takeScan(const PreparedScan::ConstPtr& scan)
{
  if (scan == scan_)
    return;
  forgetScan();
  adoptPreparation(scan->settings());
  scan_ = scan;
}

/** Whether a grouping is what the settings would make, CIDs aside. */
bool
CIDParameters::fits(const Grouping& grouping) const
{
  return grouping.settings().samples == grouping_settings_.samples &&
         grouping.settings().seeding == grouping_settings_.seeding;
}

/** Whether a run of Algorithm 1 by the settings would pass through the seeds that there
 *  are: it would not have stopped before the last of them. */
bool
CIDParameters::canGoOn() const
{
  if (!proposed_ || !fits(*grouping_))
    return false;
  const std::vector<float> coverage = grouping_->proposal().coverage;
  const std::size_t seeds = coverage.size();
  return seeds > 0 && seeds <= static_cast<std::size_t>(number_of_seeds_) &&
         (seeds == 1 || coverage[seeds - 2] > coverage_);
}

void
CIDParameters::proposeSeeds(const char* caller, const ExecutionOptions& execution)
{
  proposal_ = SeedProposal();
  if (grouping_is_given_ && fits(*grouping_)) {
    publish(execution);
    return;
  }
  takeScan(scanThatHolds({}));
  const bool goes_on = canGoOn();
  const auto wanted = static_cast<std::size_t>(number_of_seeds_);
  if (goes_on && proposed_->seeds == number_of_seeds_ &&
      proposed_->coverage == coverage_)
    publish(execution);
  else {
    const auto grouping = goes_on
                              ? changeableGrouping()
                              : std::make_shared<Grouping>(scan_, grouping_settings_);
    grouping->propose(wanted, coverage_, execution);
    publish(grouping, execution);
  }
  proposed_ = Request{number_of_seeds_, coverage_};
  warnIfShort(caller, wanted);
}

void
CIDParameters::extendSeeds(int number_of_seeds,
                           const char* caller,
                           const ExecutionOptions& execution)
{
  proposal_ = SeedProposal();
  require(setting::seeds, number_of_seeds);
  if (!grouping_)
    throw CIDException("there is no sample of this input cloud to extend, or a setting "
                       "of the preparation has changed since; call sample");
  if (!fits(*grouping_))
    throw CIDException("the number of samples on a segment or the seeding rule has "
                       "changed since the sample; what is extended must keep them");
  const auto wanted = static_cast<std::size_t>(number_of_seeds);
  const auto grouping = changeableGrouping();
  grouping->propose(wanted, coverage_, execution);
  publish(grouping, execution);
  proposed_ = Request{number_of_seeds, coverage_};
  warnIfShort(caller, wanted);
}

void
CIDParameters::groupBySeeds(const pcl::Indices& seeds,
                            const ExecutionOptions& execution)
{
  proposal_ = SeedProposal();
  if (grouping_ && fits(*grouping_) && grouping_->seeds() == seeds)
    publish(execution);
  else
    regroup(seeds, execution);
}

void
CIDParameters::regroup(const pcl::Indices& seeds, const ExecutionOptions& execution)
{
  const PreparedScan::ConstPtr scan = scanThatHolds(seeds);
  const auto grouping = std::make_shared<Grouping>(scan, grouping_settings_);
  grouping->addSeeds(seeds, execution);
  takeScan(scan);
  publish(grouping, execution);
}

void
CIDParameters::adoptGrouping(const Grouping::ConstPtr& grouping)
{
  if (!grouping)
    throw CIDException("the grouping is null; it must be one");
  setPreparedScan(grouping->sharedScan());
  grouping_settings_ = grouping->settings();
  grouping_ = grouping;
  grouping_is_given_ = true;
}

void
CIDParameters::requireNoGrouping() const
{
  if (grouping_is_given_ && fits(*grouping_))
    throw CIDException(
        "groups of seeds were given, and the group rule says patches; set "
        "the rule to cid, or share the prepared scan only");
}

std::shared_ptr<Grouping>
CIDParameters::changeableGrouping() const
{
  constexpr long here = 2; // own_ and grouping_
  if (own_ && own_.use_count() <= here)
    return own_;
  return std::make_shared<Grouping>(*grouping_);
}

void
CIDParameters::publish(const std::shared_ptr<Grouping>& grouping,
                       const ExecutionOptions& execution)
{
  own_ = grouping;
  grouping_ = grouping;
  grouping_is_given_ = false;
  proposed_.reset();
  publish(execution);
}

void
CIDParameters::publish(const ExecutionOptions& execution)
{
  const ExecutionOptions silent{execution.threads, {}};
  proposal_ = grouping_->proposal(silent);
  if (grouping_settings_.keep_cid && proposal_.cid.empty())
    proposal_.cid = grouping_->cids(silent);
}

void
CIDParameters::warnIfShort(const char* caller, std::size_t wanted) const
{
  const std::size_t found = proposal_.seeds.size();
  const float reached = proposal_.coverage.back();
  const bool covered = reached <= coverage_;
  if (found < wanted && !(covered && coverage_ > 0.0f))
    PCL_WARN("[pcl_cid::%s] only %zu seeds instead of %zu: no other candidate is apart "
             "from them\n",
             caller,
             found,
             wanted);
  if (coverage_ > 0.0f && !covered)
    PCL_WARN("[pcl_cid::%s] coverage is %g instead of %g metres after %zu seeds\n",
             caller,
             static_cast<double>(reached),
             static_cast<double>(coverage_),
             found);
}

} // namespace pcl_cid
