/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Bisection order of the samples, and bounds concluded from neighbours.
 */

#include "../../src/core/segment_samples.h"

#include "clouds.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(SampleOrder, HasEverySampleOnceEachBetweenTwoKnownOnes)
{
  for (const int samples : {2, 3, 4, 7, 100, 1025}) {
    const SampleOrder order(samples);
    EXPECT_EQ(order.samples(), samples);
    std::vector<int> known(static_cast<std::size_t>(samples), 0);
    known.front() = known.back() = 1;
    for (const SampleOrder::Level& level : order.levels()) {
      for (const SampleOrder::Entry& entry : level) {
        EXPECT_LT(entry.left, entry.sample);
        EXPECT_LT(entry.sample, entry.right);
        EXPECT_EQ(known[entry.left], 1) << "known before the level";
        EXPECT_EQ(known[entry.right], 1) << "known before the level";
        EXPECT_EQ(known[entry.sample], 0);
      }
      for (const SampleOrder::Entry& entry : level)
        known[entry.sample] = 1;
    }
    EXPECT_EQ(known, std::vector<int>(static_cast<std::size_t>(samples), 1));
  }
}

TEST(SegmentSamples, AreWithinTheSlackOfTheDefinition)
{
  for (const float scale : {1e-3f, 1.0f, 1e4f})
    for (const int samples : {2, 7, 100}) {
      const Points ends = randomCube(200, 151);
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Eigen::Vector3f p = scale * ends[i];
        const Eigen::Vector3f q =
            scale * (ends[i + 1] - Eigen::Vector3f::Constant(3.0f));
        const SegmentSamples segment(p, q, samples);
        for (int l = 0; l < samples; ++l) {
          const Eigen::Vector3f x = segmentSample(p, q, l, samples);
          EXPECT_LE((segment.at(static_cast<std::size_t>(l)) - x).norm(),
                    segment.slack);
        }
        const float apart = (segmentSample(p, q, 1, samples) - p).norm();
        EXPECT_LE(apart, segment.spacing + segment.slack);
      }
    }
}

TEST(SegmentSamples, BoundBetweenTwoSamplesHolds)
{
  const Points surface = twoBoxes(500, 152);
  const DistanceField field(surface);
  const SampleOrder order(33);
  for (std::size_t i = 0; i + 1 < surface.size(); ++i) {
    const SegmentSamples segment(surface[i], surface[i + 1], 33);
    std::vector<float> high(33);
    for (std::size_t l = 0; l < 33; ++l)
      high[l] = field.distance(segment.at(l));
    for (const SampleOrder::Level& level : order.levels())
      for (const SampleOrder::Entry& entry : level)
        EXPECT_LE(high[entry.sample], segment.between(entry, high));
  }
}

} // namespace
} // namespace pcl_cid::test
