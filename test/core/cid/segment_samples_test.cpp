/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Bisection order of the samples; the samples in float.
 */

#include "cid/segment_samples.h"

#include "clouds.h"

#include <cstddef>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(SampleOrder, HasEverySampleOnceAndHalvesEveryGap)
{
  for (const int samples : {2, 3, 4, 7, 100, 1025}) {
    const SampleOrder order(samples);
    EXPECT_EQ(order.samples(), samples);
    std::set<std::size_t> known = {0, order.last()};
    std::size_t widest = order.last();
    for (const SampleOrder::Level& level : order.levels()) {
      for (const std::size_t l : level)
        EXPECT_TRUE(known.insert(l).second);
      widest = (widest + 1) / 2;
      for (auto l = known.begin(); std::next(l) != known.end(); ++l)
        EXPECT_LE(*std::next(l) - *l, widest);
    }
    EXPECT_EQ(known.size(), static_cast<std::size_t>(samples));
    EXPECT_EQ(*known.rbegin(), order.last());
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

} // namespace
} // namespace pcl_cid::test
