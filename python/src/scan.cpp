/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A prepared scan and the seeds on it, for any number of threads.
 */

#include "scan.h"

#include <pcl_cid/cid_sampler.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>

namespace pcl_cid::python {
namespace {

/** What the classes do before a scan is prepared, with settings of its own. */
class ScanMaker : public CIDSampler<pcl::PointXYZ> {
public:
  using CIDPreparationParameters::adoptPreparation;
};

PreparedScan::ConstPtr
prepare(const CloudPoints& cloud,
        const std::vector<ColorRGB>& colors,
        const ScanSettings& settings,
        const ExecutionOptions& execution)
{
  ScanMaker maker;
  maker.setInputCloud(cloud.points);
  maker.adoptPreparation(settings.preparation);
  if (!colors.empty())
    maker.setColors(std::make_shared<const std::vector<ColorRGB>>(colors));
  maker.setNumberOfThreads(execution.threads);
  maker.setProgressCallback(execution.progress);
  return maker.prepare();
}

/** The label of the first seed that has none of its own, when some have. */
std::uint64_t
nextLabel(const std::vector<std::uint32_t>& labels)
{
  const auto largest = std::max_element(labels.begin(), labels.end());
  return largest == labels.end() ? 1 : std::uint64_t{*largest} + 1;
}

/** Labels for the seeds from labels.size() on, up to \a seeds. */
void
addLabels(std::size_t seeds, std::vector<std::uint32_t>& labels)
{
  std::uint64_t next = nextLabel(labels);
  for (; labels.size() < seeds; ++next) {
    if (next > std::numeric_limits<std::uint32_t>::max())
      throw CIDException("the largest label of a seed is " + std::to_string(next - 1) +
                         ", after which there is none for a seed without a label; "
                         "give it one");
    labels.push_back(static_cast<std::uint32_t>(next));
  }
}

/** The numbers of seeds that are given by their points. */
std::vector<std::size_t>
numbersOf(const pcl::Indices& wanted, const pcl::Indices& seeds)
{
  std::vector<std::size_t> numbers;
  for (const pcl::index_t seed : wanted) {
    const auto found = std::find(seeds.begin(), seeds.end(), seed);
    if (found == seeds.end())
      throw CIDException("point " + std::to_string(seed) + " is none of the " +
                         std::to_string(seeds.size()) + " seeds; it must be one");
    numbers.push_back(static_cast<std::size_t>(found - seeds.begin()));
    if (std::count(numbers.begin(), numbers.end(), numbers.back()) > 1)
      throw CIDException("seed " + std::to_string(seed) +
                         " is given twice; it must be given once");
  }
  return numbers;
}

} // namespace

/** The right to change the seeds of a scan, and a grouping to do it on: what readers
 *  hold stays as it is. */
class Scan::Change {
public:
  /** Waits for the change that another thread is at. */
  Change(Scan& scan, const ExecutionOptions& execution)
  : scan_(scan), right_(scan.change_mutex_, std::defer_lock)
  {
    if (scan.changer_ == std::this_thread::get_id())
      throw CIDException("the seeds cannot be changed from the progress callback of "
                         "another change of them");
    while (!right_.try_lock_for(std::chrono::milliseconds(50)))
      if (execution.progress && !execution.progress(0.0))
        throw CIDCancelled();
    before = scan.seeding();
    labels = before->labelsOfSeeds();
    scan.changer_ = std::this_thread::get_id();
  }

  ~Change() { scan_.changer_ = std::thread::id(); }

  Change(const Change&) = delete;
  Change&
  operator=(const Change&) = delete;

  /** \brief A copy of the groups. */
  std::shared_ptr<Grouping>
  grouping() const
  {
    return std::make_shared<Grouping>(*before->grouping());
  }

  std::shared_ptr<const Seeding> before;
  std::vector<std::uint32_t> labels; ///< to be changed

private:
  Scan& scan_;
  std::unique_lock<std::timed_mutex> right_;
};

Scan::Scan(const CloudPoints& cloud,
           const std::vector<ColorRGB>& colors,
           const ScanSettings& settings,
           const ExecutionOptions& execution)
: prepared_(prepare(cloud, colors, settings, execution))
, frame_(cloud.frame)
, settings_(settings)
{
  publish(std::make_shared<const Seeding>(
      std::make_shared<const Grouping>(prepared_, settings.grouping),
      std::vector<std::uint32_t>()));
}

std::shared_ptr<const Seeding>
Scan::seeding() const
{
  const std::lock_guard<std::mutex> lock(state_mutex_);
  return seeding_;
}

void
Scan::publish(std::shared_ptr<const Seeding> next)
{
  const std::lock_guard<std::mutex> lock(state_mutex_);
  seeding_.swap(next); // the state before is let go of after the lock
}

ProposalStop
Scan::propose(std::size_t seeds, float coverage, const ExecutionOptions& execution)
{
  Change change(*this, execution);
  const std::shared_ptr<Grouping> grouping = change.grouping();
  const ProposalStop stop = grouping->propose(seeds, coverage, execution);
  addLabels(grouping->numberOfSeeds(), change.labels);
  publish(std::make_shared<const Seeding>(grouping, std::move(change.labels)));
  return stop;
}

void
Scan::addSeeds(const pcl::Indices& seeds,
               const std::optional<std::vector<std::uint32_t>>& labels,
               const ExecutionOptions& execution)
{
  Change change(*this, execution);
  const std::shared_ptr<Grouping> grouping = change.grouping();
  if (labels)
    change.labels.insert(change.labels.end(), labels->begin(), labels->end());
  else
    addLabels(change.labels.size() + seeds.size(), change.labels);
  grouping->addSeeds(seeds, execution);
  publish(std::make_shared<const Seeding>(grouping, std::move(change.labels)));
}

void
Scan::removeSeeds(const pcl::Indices& seeds, const ExecutionOptions& execution)
{
  Change change(*this, execution);
  const std::shared_ptr<Grouping> grouping = change.grouping();
  std::vector<std::size_t> numbers = numbersOf(seeds, grouping->seeds());
  grouping->removeSeeds(numbers, execution);
  std::sort(numbers.rbegin(), numbers.rend());
  for (const std::size_t number : numbers)
    change.labels.erase(change.labels.begin() + static_cast<std::ptrdiff_t>(number));
  publish(std::make_shared<const Seeding>(grouping, std::move(change.labels)));
}

void
Scan::labelSeeds(const pcl::Indices& seeds,
                 const std::vector<std::uint32_t>& labels,
                 const ExecutionOptions& execution)
{
  Change change(*this, execution);
  const std::vector<std::size_t> numbers =
      numbersOf(seeds, change.before->grouping()->seeds());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    change.labels[numbers[i]] = labels[i];
  publish(std::make_shared<const Seeding>(*change.before, std::move(change.labels)));
}

} // namespace pcl_cid::python
