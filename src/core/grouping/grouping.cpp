/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Seeds and the group of every point: a result that can be changed.
 */

#include "connected_groups.h"
#include "seed_proposal.h"

#include "base/requirements.h"
#include "scan/surface_graph.h"
#include "scan/working_set.h"

#include <pcl_cid/core/grouping.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace pcl_cid {
namespace {

constexpr float no_coverage = std::numeric_limits<float>::quiet_NaN();

std::unique_ptr<BlockGroups>
emptyGroups(const PreparedScan& scan, const GroupingSettings& settings)
{
  auto groups = std::make_unique<BlockGroups>(scan.working(), settings.samples);
  groups->setIsolated(scan.isolated());
  if (!scan.candidates().empty())
    groups->setCandidates(scan.candidates());
  return groups;
}

const PreparedScan&
notNull(const PreparedScan::ConstPtr& scan)
{
  if (!scan)
    throw CIDException("there is no prepared scan to group; give one");
  return *scan;
}

} // namespace

/** A verb takes effect as a whole or not at all. Where it can be cancelled it works on
 *  a copy, which costs little beside any verb. */
class Grouping::Verb {
public:
  Verb(Grouping& grouping, const ExecutionOptions& execution)
  : grouping_(grouping)
  , progress_(execution.progress)
  , work_{threadCount(execution.threads), progress_}
  , coverages_(grouping.coverages_)
  , comparisons_(grouping.comparisons_)
  , copy_(execution.progress ? std::make_unique<BlockGroups>(*grouping.groups_)
                             : std::move(grouping.groups_))
  {
  }

  ~Verb()
  {
    if (grouping_.groups_)
      return;
    grouping_.groups_ = std::move(copy_);
    grouping_.clear();
  }

  BlockGroups&
  groups()
  {
    return *copy_;
  }

  BlockGroups::Work
  work() const
  {
    return work_;
  }

  bool
  knowsCoverages() const
  {
    return coverages_.size() == copy_->numberOfSeeds();
  }

  /** Run a traversal, and take over its coverages.
   *  \param[in] run called with it */
  template <typename Run>
  void
  traverse(const Run& run)
  {
    const bool knows = knowsCoverages();
    const std::size_t before = copy_->numberOfSeeds();
    Traversal traversal(*copy_, grouping_.coverage_, work_);
    run(traversal);
    traversal.finish(grouping_.settings_.keep_cid);
    const std::vector<float>& added = traversal.coverages();
    if (knows)
      coverages_.insert(coverages_.end(), added.begin(), added.end());
    comparisons_ += copy_->numberOfSeeds() - before;
    if (!added.empty())
      coverage_ = added.back();
  }

  /** Forget the coverages of the seeds from a number on, and find out the last. */
  void
  forgetCoverages(std::size_t number)
  {
    coverages_.resize(std::min(coverages_.size(), number));
    coverage_ = copy_->coverage(work_, {1.0, 1.0});
    if (coverages_.size() + 1 == copy_->numberOfSeeds())
      coverages_.push_back(coverage_);
  }

  void
  commit()
  {
    grouping_.groups_ = std::move(copy_);
    grouping_.coverages_ = std::move(coverages_);
    grouping_.coverage_ = coverage_;
    grouping_.comparisons_ = comparisons_;
  }

private:
  Grouping& grouping_;
  Progress progress_;
  BlockGroups::Work work_;
  std::vector<float> coverages_;
  float coverage_ = grouping_.coverage_;
  std::size_t comparisons_;
  std::unique_ptr<BlockGroups> copy_;
};

Grouping::Grouping(PreparedScan::ConstPtr scan, const GroupingSettings& settings)
: scan_(std::move(scan)), settings_(settings)
{
  require(setting::samples, settings.samples);
  groups_ = emptyGroups(notNull(scan_), settings_);
  if (scan_->graph())
    connected_ = std::make_shared<ConnectedGroups>(
        *scan_->graph(), scan_->working(), settings_.samples);
  coverage_ = no_coverage;
}

Grouping::Grouping(const Grouping& other)
: scan_(other.scan_)
, settings_(other.settings_)
, groups_(std::make_unique<BlockGroups>(*other.groups_))
, connected_(other.connected_)
, coverages_(other.coverages_)
, coverage_(other.coverage_)
, comparisons_(other.comparisons_)
{
}

Grouping::Grouping(Grouping&& other) noexcept = default;

Grouping&
Grouping::operator=(Grouping other) noexcept
{
  std::swap(scan_, other.scan_);
  std::swap(settings_, other.settings_);
  std::swap(groups_, other.groups_);
  std::swap(connected_, other.connected_);
  std::swap(coverages_, other.coverages_);
  std::swap(coverage_, other.coverage_);
  std::swap(comparisons_, other.comparisons_);
  return *this;
}

Grouping::~Grouping() = default;

void
Grouping::clear() noexcept
{
  groups_->clear();
  coverages_.clear();
  coverage_ = no_coverage;
}

ProposalStop
Grouping::propose(std::size_t seeds, float coverage, const ExecutionOptions& execution)
{
  requireAtLeast("number of seeds", seeds, std::size_t{1});
  require(setting::coverage, coverage);
  ProposalStop stop = ProposalStop::seeds;
  Verb verb(*this, execution);
  verb.traverse([&](Traversal& traversal) {
    stop = traversal.run(scan_->start(),
                         {seeds, coverage, settings_.seeding, scan_->softSeed()});
  });
  verb.commit();
  return stop;
}

void
Grouping::addSeeds(const pcl::Indices& seeds, const ExecutionOptions& execution)
{
  const pcl::Indices indices = newSeeds(seeds);
  Verb verb(*this, execution);
  verb.traverse([&](Traversal& traversal) {
    const std::size_t planned = verb.groups().numberOfSeeds() + indices.size();
    for (const pcl::index_t index : indices)
      traversal.addSeed(index, verb.groups().numberOfSeeds(), planned);
  });
  verb.commit();
}

void
Grouping::insertSeeds(const pcl::Indices& seeds,
                      std::size_t number,
                      const ExecutionOptions& execution)
{
  if (number > numberOfSeeds())
    throw CIDException(sentence("the number to insert seeds at is ",
                                number,
                                "; it must be 0 to ",
                                numberOfSeeds(),
                                " (after the last)"));
  if (number == numberOfSeeds()) {
    addSeeds(seeds, execution);
    return;
  }
  const pcl::Indices indices = newSeeds(seeds);
  Verb verb(*this, execution);
  verb.traverse([&](Traversal& traversal) {
    std::size_t rank = number;
    for (const pcl::index_t index : indices)
      traversal.addSeed(index, rank++, verb.groups().numberOfSeeds() + 1);
  });
  verb.forgetCoverages(number);
  verb.commit();
}

void
Grouping::removeSeeds(std::vector<std::size_t> numbers,
                      const ExecutionOptions& execution)
{
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (numbers[k] >= numberOfSeeds() || (k > 0 && numbers[k] == numbers[k - 1]))
      throw CIDException(sentence("the number of a seed to take away is ",
                                  numbers[k],
                                  "; each must be 0 to ",
                                  numberOfSeeds(),
                                  " - 1 (the seeds), and be given once"));
  if (numbers.empty())
    return;
  if (numbers.size() == numberOfSeeds()) {
    clear();
    return;
  }
  Verb verb(*this, execution);
  verb.groups().removeSeeds(numbers, settings_.keep_cid, verb.work());
  verb.forgetCoverages(numbers.front());
  verb.commit();
}

std::size_t
Grouping::numberOfSeeds() const
{
  return groups_->numberOfSeeds();
}

pcl::Indices
Grouping::seeds() const
{
  pcl::Indices seeds = groups_->seeds();
  for (pcl::index_t& seed : seeds)
    seed = scan_->workingSet().cloudIndexOf(seed);
  return seeds;
}

/** Given seeds as indices among the points that are worked on.
 *  \throws CIDException when one is no such point, or a seed already */
pcl::Indices
Grouping::newSeeds(const pcl::Indices& seeds) const
{
  pcl::Indices indices;
  const pcl::Indices known = groups_->seeds();
  std::set<pcl::index_t> taken(known.begin(), known.end());
  for (const pcl::index_t seed : seeds) {
    indices.push_back(scan_->workingIndex(seed, "seed"));
    if (!taken.insert(indices.back()).second)
      throw CIDException(sentence(
          "point ", seed, " is a seed already; a point can be a seed only once"));
  }
  return indices;
}

std::vector<pcl::index_t>
Grouping::groupsOfWorkingPoints(const ExecutionOptions& execution) const
{
  if (numberOfSeeds() == 0)
    return std::vector<pcl::index_t>(scan_->working().size(), -1);
  Progress progress(execution.progress);
  const int threads = threadCount(execution.threads);
  std::vector<pcl::index_t> groups = groups_->groups({threads, progress});
  if (!connected_)
    return groups;
  return connected_->connect(groups_->seeds(), std::move(groups), threads, progress);
}

std::vector<pcl::index_t>
Grouping::groups(const ExecutionOptions& execution) const
{
  return scan_->workingSet().carryOn(
      groupsOfWorkingPoints(execution), scan_->cloudSize(), pcl::index_t{-1});
}

std::vector<float>
Grouping::cids(const ExecutionOptions& execution) const
{
  if (numberOfSeeds() == 0)
    return std::vector<float>(scan_->cloudSize(), no_coverage);
  Progress progress(execution.progress);
  const BlockGroups::Work work{threadCount(execution.threads), progress};
  const auto carried = [&](const BlockGroups& exact) {
    return scan_->workingSet().carryOn(
        exact.cids(work), scan_->cloudSize(), no_coverage);
  };
  if (settings_.keep_cid)
    return carried(*groups_);
  BlockGroups exact = *groups_;
  exact.decideAll(true, work, {0.0, 1.0});
  return carried(exact);
}

SeedProposal
Grouping::proposal(const ExecutionOptions& execution) const
{
  SeedProposal proposal{seeds(), groups(execution), {}, coverages_};
  if (coverages_.size() < numberOfSeeds()) {
    proposal.coverage.resize(numberOfSeeds(), no_coverage);
    proposal.coverage.back() = coverage_;
  }
  if (settings_.keep_cid)
    proposal.cid = cids(execution);
  return proposal;
}

} // namespace pcl_cid
