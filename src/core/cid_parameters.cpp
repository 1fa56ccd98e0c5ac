/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings that do not depend on the point type.
 */

#include "validation.h"

#include <pcl_cid/core/cid_parameters.h>

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
  requireAtLeast("number of seeds", number_of_seeds, 1);
  number_of_seeds_ = number_of_seeds;
}

void
CIDParameters::setCoverage(float coverage)
{
  requireNotNegative("coverage", coverage, "metres");
  coverage_ = coverage;
}

void
CIDParameters::setNumberOfSamples(int number_of_samples)
{
  requireSamples(number_of_samples);
  number_of_samples_ = number_of_samples;
}

void
CIDParameters::setSubsample(int subsample)
{
  requireAtLeast("subsample", subsample, 0);
  subsample_ = subsample;
}

void
CIDParameters::setStartIndex(pcl::index_t start_index)
{
  requireAtLeast("start index", start_index, pcl::index_t{0});
  start_index_ = start_index;
}

void
CIDParameters::setDensityPower(float density_power)
{
  requireDensityPower(density_power);
  raw_scan_.density_power = density_power;
}

void
CIDParameters::setIsolatedNeighbors(int isolated_neighbors)
{
  requireNearNeighbors(isolated_neighbors);
  raw_scan_.isolated_neighbors = isolated_neighbors;
}

void
CIDParameters::setColorWeight(float color_weight)
{
  requireNotNegative("color weight", color_weight, "metres for a unit of L*a*b*");
  raw_scan_.color_weight = color_weight;
}

void
CIDParameters::setNumberOfThreads(unsigned int number_of_threads)
{
  constexpr unsigned int most_threads = 1024;
  if (number_of_threads > most_threads)
    throw CIDException(sentence("the number of threads is ",
                                number_of_threads,
                                "; it must be at most ",
                                most_threads));
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
