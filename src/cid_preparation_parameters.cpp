/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings by which all classes prepare their input.
 */

#include <pcl_cid/cid_preparation_parameters.h>

namespace pcl_cid {

void
CIDPreparationParameters::setPaperSettings()
{
  preparation_.setPaperSettings();
  forgetScan();
}

void
CIDPreparationParameters::setSubsample(int subsample)
{
  require(setting::subsample, subsample);
  preparation_.subsample = subsample;
  forgetScan();
}

void
CIDPreparationParameters::setRandomSeed(std::uint64_t random_seed)
{
  preparation_.random_seed = random_seed;
  forgetScan();
}

void
CIDPreparationParameters::setStartIndex(pcl::index_t start_index)
{
  require(setting::start_index, start_index);
  preparation_.start_index = start_index;
  forgetScan();
}

void
CIDPreparationParameters::resetStartIndex()
{
  preparation_.start_index.reset();
  forgetScan();
}

void
CIDPreparationParameters::setSeedCandidates(
    const pcl::shared_ptr<const pcl::Indices>& seed_candidates)
{
  preparation_.seed_candidates = seed_candidates;
  forgetScan();
}

void
CIDPreparationParameters::setDensityWeight(DensityWeight density_weight)
{
  preparation_.density = density_weight;
  forgetScan();
}

void
CIDPreparationParameters::setDensityPower(float density_power)
{
  require(setting::density_power, density_power);
  preparation_.density_power = density_power;
  forgetScan();
}

void
CIDPreparationParameters::setIsolatedNeighbors(int isolated_neighbors)
{
  require(setting::isolated_neighbors, isolated_neighbors);
  preparation_.isolated_neighbors = isolated_neighbors;
  forgetScan();
}

void
CIDPreparationParameters::setNormalWeight(float normal_weight)
{
  require(setting::normals, normal_weight);
  preparation_.normals = normal_weight;
  forgetScan();
}

void
CIDPreparationParameters::setConnectedGroups(bool connected_groups)
{
  preparation_.connected = connected_groups;
  forgetScan();
}

void
CIDPreparationParameters::setColorWeight(float color_weight)
{
  require(setting::color, color_weight);
  preparation_.color = color_weight;
  forgetScan();
}

void
CIDPreparationParameters::setColors(const ColorsConstPtr& colors)
{
  colors_ = colors;
  forgetScan();
}

void
CIDPreparationParameters::setFillBlindSpot(bool fill_blind_spot)
{
  preparation_.blind_spot = fill_blind_spot;
  forgetScan();
}

void
CIDPreparationParameters::setSearchMethod(const SearchPtr& search_method)
{
  preparation_.search_method = search_method;
  forgetScan();
}

void
CIDPreparationParameters::setMemoryBudget(std::size_t memory_budget)
{
  preparation_.memory_budget = memory_budget;
  forgetScan();
}

} // namespace pcl_cid
