/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A prepared scan and the seeds on it, for any number of threads.
 */

#pragma once

#include "seeding.h"

#include <pcl_cid/core/color.h>
#include <pcl_cid/core/frame.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/io/cloud_points.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace pcl_cid::python {

/** \brief The settings that a scan is made with. */
struct ScanSettings {
  PreparationSettings preparation;
  GroupingSettings grouping;
  unsigned int threads = setting::threads.initial;

  void
  setPaperSettings()
  {
    preparation.setPaperSettings();
    grouping.seeding = setting::seeding.paper();
  }
};

/** \brief Call \a visit with the row and the value of each. */
template <typename Settings, typename Visitor>
void
forEachSettingOf(Settings& settings, Visitor&& visit)
{
  auto& preparation = settings.preparation;
  visit(setting::samples, settings.grouping.samples);
  visit(setting::subsample, preparation.subsample);
  visit(setting::random_seed, preparation.random_seed);
  visit(setting::start_index, preparation.start_index);
  visit(setting::density, preparation.density);
  visit(setting::density_power, preparation.density_power);
  visit(setting::isolated_neighbors, preparation.isolated_neighbors);
  visit(setting::seeding, settings.grouping.seeding);
  visit(setting::color, preparation.color);
  visit(setting::normals, preparation.normals);
  visit(setting::connected, preparation.connected);
  visit(setting::blind_spot, preparation.blind_spot);
  visit(setting::threads, settings.threads);
}

/** \brief A prepared scan, and the seeds on it. Reading sees the state that was there
 *  when it began; changes come one after another. */
class Scan {
public:
  /** \brief Prepare a cloud.
   *  \param[in] colors one for each point, or empty
   *  \throws CIDException, CIDCancelled */
  Scan(const CloudPoints& cloud,
       const std::vector<ColorRGB>& colors,
       const ScanSettings& settings,
       const ExecutionOptions& execution);

  const PreparedScan::ConstPtr&
  prepared() const
  {
    return prepared_;
  }

  const ScanSettings&
  settings() const
  {
    return settings_;
  }

  /** \brief From the coordinates that were given to those of the prepared cloud. */
  const Frame&
  frame() const
  {
    return frame_;
  }

  std::size_t
  size() const
  {
    return prepared_->cloudSize();
  }

  std::shared_ptr<const Seeding>
  seeding() const;

  /** \brief Algorithm 1. Seeds without a label get the next ones, see nextLabel(). */
  ProposalStop
  propose(std::size_t seeds, float coverage, const ExecutionOptions& execution);

  /** \param[in] labels one for each of the seeds; none: the next ones */
  void
  addSeeds(const pcl::Indices& seeds,
           const std::optional<std::vector<std::uint32_t>>& labels,
           const ExecutionOptions& execution);

  /** \param[in] seeds points that are seeds, each once */
  void
  removeSeeds(const pcl::Indices& seeds, const ExecutionOptions& execution);

  /** \brief Other labels for points that are seeds. */
  void
  labelSeeds(const pcl::Indices& seeds,
             const std::vector<std::uint32_t>& labels,
             const ExecutionOptions& execution);

private:
  class Change;

  void
  publish(std::shared_ptr<const Seeding> next);

  PreparedScan::ConstPtr prepared_;
  Frame frame_;
  ScanSettings settings_;
  mutable std::mutex state_mutex_; ///< of seeding_
  std::shared_ptr<const Seeding> seeding_;
  std::timed_mutex change_mutex_; ///< held by the thread that changes the seeds
  std::atomic<std::thread::id> changer_{};
};

} // namespace pcl_cid::python
