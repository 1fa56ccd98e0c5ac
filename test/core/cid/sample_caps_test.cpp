/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Upper bounds of d at all samples of a segment, each from some surface points.
 */

#include "cid/sample_caps.h"

#include "base/random.h"
#include "clouds.h"

#include <pcl_cid/core/concavity.h>

#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(SampleCaps, AreNeverBelowTheSurface)
{
  RandomGenerator generator(161);
  for (const float scale : {1e-3f, 1.0f, 1e4f})
    for (const int samples : {2, 7, 100}) {
      Points surface = twoBoxes(400, 160);
      for (Eigen::Vector3f& point : surface)
        point = scale * (point + Eigen::Vector3f(40.0f, -7.0f, 0.0f));
      const DistanceField field(surface);
      const SampleOrder order(samples);
      for (std::size_t i = 0; i + 1 < surface.size(); ++i) {
        const Eigen::Vector3f &p = surface[i], &q = surface[i + 1];
        const SegmentSamples segment(p, q, samples);
        Eigen::ArrayXf storage;
        SampleCaps caps(segment, order, storage);
        caps.reset();
        for (int looks = 0; looks < 5; ++looks) {
          const std::size_t l = drawBelow(generator, order.last() + 1);
          const Eigen::Vector3f& point = surface[drawBelow(generator, surface.size())];
          caps.lower(point, l, drawBelow(generator, 2 * order.last()));
          // It is a cap from that very point, but for rounding.
          EXPECT_LE(caps[l],
                    (segment.at(l) - point).squaredNorm() * 1.0001f +
                        1e-4f * segment.along.squaredNorm());
        }
        for (std::size_t l = 0; l <= order.last(); ++l) {
          const float d =
              field.distance(segmentSample(p, q, static_cast<int>(l), samples));
          EXPECT_FALSE(caps[l] < caps.squareOf(d)) << "a cap would show that d < d";
        }
      }
    }
}

TEST(SampleCaps, LeaveFarSamplesAlone)
{
  const Eigen::Vector3f p(0.0f, 0.0f, 0.0f), q(9.9f, 0.0f, 0.0f);
  const SampleOrder order(100);
  const SegmentSamples segment(p, q, 100);
  Eigen::ArrayXf storage;
  SampleCaps caps(segment, order, storage);
  caps.reset();
  EXPECT_EQ(caps.largest(), INFINITY);
  EXPECT_EQ(caps.find(INFINITY), 0u);
  caps.lower({5.0f, 0.0f, 0.25f}, 50, 8);
  EXPECT_NEAR(caps[50], 0.0625f, 1e-3f);
  EXPECT_NEAR(caps[45], 0.3125f, 1e-3f);
  EXPECT_EQ(caps[50 - 8 - SampleOrder::packet], INFINITY);
  EXPECT_EQ(caps[50 + 8 + SampleOrder::packet], INFINITY);
}

TEST(SampleCaps, OfNoLengthCapTheirOnlyPoint)
{
  const Eigen::Vector3f p(1.0f, 2.0f, 3.0f);
  const SampleOrder order(5);
  const SegmentSamples segment(p, p, 5);
  Eigen::ArrayXf storage;
  SampleCaps caps(segment, order, storage);
  caps.reset();
  caps.lower(p, 0, order.last());
  for (std::size_t l = 0; l <= order.last(); ++l)
    EXPECT_LE(caps[l], 1e-4f);
  EXPECT_LE(caps.largest(), 1e-4f) << "what fills the packets up has no say";
}

} // namespace
} // namespace pcl_cid::test
