/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Expected results of the literal definitions, made elsewhere.
 */

#include "clouds.h"
#include "oracle.h"

#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>

#include <fstream>

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

class Golden : public testing::TestWithParam<std::string> {
protected:
  void
  load(const std::string& size)
  {
    const std::string name = "golden/" + GetParam() + "_" + size;
    if (sharedFile(name + ".json").empty())
      GTEST_SKIP() << "../shared/" << name << ".json is absent";
    std::ifstream(sharedFile(name + ".json")) >> expected_;
    pcl::PointCloud<pcl::PointXYZ> cloud;
    ASSERT_EQ(pcl::io::loadPCDFile(sharedFile(name + ".pcd"), cloud), 0);
    for (const pcl::PointXYZ& p : cloud)
      points_.push_back(p.getVector3fMap());
    tolerance_ = agreementTolerance(points_);
  }

  /** Algorithm 1 with the settings of the file. */
  SeedProposal
  propose() const
  {
    SeedProposalOptions options;
    options.seeds = expected_["seeds"].size();
    options.samples = expected_["samples"];
    return proposeSeeds(DistanceField(points_), points_, 0, options);
  }

  /** Whether a point is equally near to two seeds, as far as rounding can tell. */
  bool
  isTied(std::size_t point, pcl::index_t seed, pcl::index_t other) const
  {
    const Oracle oracle(points_, expected_["samples"]);
    const Eigen::Vector3f p = points_[point];
    return std::abs(oracle.pointCID(p, points_[static_cast<std::size_t>(seed)]) -
                    oracle.pointCID(p, points_[static_cast<std::size_t>(other)])) <
           tolerance_;
  }

  void
  expectSeedsAndGroups(const SeedProposal& proposal) const
  {
    ASSERT_EQ(proposal.seeds, expected_["seeds"].get<pcl::Indices>());
    const auto group = expected_["group"].get<std::vector<pcl::index_t>>();
    ASSERT_EQ(proposal.group.size(), group.size());
    for (std::size_t i = 0; i < group.size(); ++i)
      if (proposal.group[i] != group[i]) {
        EXPECT_TRUE(isTied(i,
                           proposal.seeds[static_cast<std::size_t>(proposal.group[i])],
                           proposal.seeds[static_cast<std::size_t>(group[i])]))
            << "point " << i << " is in group " << proposal.group[i] << ", not "
            << group[i];
      }
  }

  nlohmann::json expected_;
  Points points_;
  double tolerance_ = 0.0;
};

TEST_P(Golden, Algorithm1)
{
  load("2500");
  if (IsSkipped())
    return;
  const SeedProposal proposal = propose();
  expectSeedsAndGroups(proposal);
  const auto coverage = expected_["coverage"].get<std::vector<double>>();
  for (std::size_t k = 0; k < coverage.size(); ++k)
    EXPECT_NEAR(static_cast<double>(proposal.coverage[k]), coverage[k], tolerance_);
  const auto cid = expected_["cid"].get<std::vector<double>>();
  for (std::size_t i = 0; i < cid.size(); ++i)
    EXPECT_NEAR(static_cast<double>(proposal.cid[i]), cid[i], tolerance_);
}

TEST_P(Golden, Algorithm2)
{
  load("500");
  if (IsSkipped())
    return;
  const SeedProposal proposal = propose();
  expectSeedsAndGroups(proposal);
  GroupMergingOptions options;
  options.samples = expected_["samples"];
  options.group_samples = 1u << 20; // all pairs
  const MergeTree tree = mergeGroups(
      DistanceField(points_), points_, proposal.group, proposal.seeds.size(), options);
  ASSERT_EQ(tree.steps().size(), expected_["merges"].size());
  for (std::size_t n = 0; n < tree.steps().size(); ++n) {
    const nlohmann::json& merge = expected_["merges"][n];
    EXPECT_EQ(tree.steps()[n].first, merge["first"]);
    EXPECT_EQ(tree.steps()[n].second, merge["second"]);
    EXPECT_NEAR(tree.steps()[n].height, merge["height"], tolerance_);
    EXPECT_EQ(tree.steps()[n].size, merge["size"]);
  }
}

INSTANTIATE_TEST_SUITE_P(Files,
                         Golden,
                         testing::Values("helix",
                                         "milk_cartoon",
                                         "mosd_learn41",
                                         "office1",
                                         "room",
                                         "two_spheres"),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace pcl_cid::test
