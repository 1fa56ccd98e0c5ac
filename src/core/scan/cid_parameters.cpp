/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings that do not depend on the point type.
 */

#include "base/requirements.h"

#include <pcl_cid/core/cid_parameters.h>
#include <pcl_cid/core/settings.h>

#include <tuple>

namespace pcl_cid {

bool
RawScanSettings::operator==(const RawScanSettings& other) const
{
  const auto all = [](const RawScanSettings& s) {
    return std::tie(s.density_weight,
                    s.density_power,
                    s.isolated_neighbors,
                    s.seeding_rule,
                    s.color_weight,
                    s.fill_blind_spot);
  };
  return all(*this) == all(other);
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
  number_of_samples_ = number_of_samples;
}

void
CIDParameters::setSubsample(int subsample)
{
  require(setting::subsample, subsample);
  subsample_ = subsample;
}

void
CIDParameters::setStartIndex(pcl::index_t start_index)
{
  require(setting::start_index, start_index);
  start_index_ = start_index;
}

void
CIDParameters::setDensityPower(float density_power)
{
  require(setting::density_power, density_power);
  raw_scan_.density_power = density_power;
}

void
CIDParameters::setIsolatedNeighbors(int isolated_neighbors)
{
  require(setting::isolated_neighbors, isolated_neighbors);
  raw_scan_.isolated_neighbors = isolated_neighbors;
}

void
CIDParameters::setColorWeight(float color_weight)
{
  require(setting::color, color_weight);
  raw_scan_.color_weight = color_weight;
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
  ExecutionOptions options;
  options.threads = number_of_threads_;
  if (progress_)
    options.progress = [callback = progress_, begin, end](double fraction) {
      return callback(begin + (end - begin) * fraction);
    };
  return options;
}

} // namespace pcl_cid
