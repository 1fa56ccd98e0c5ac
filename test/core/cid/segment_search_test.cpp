/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What is said of the CID of one segment, against all of its samples.
 */

#include "cid/segment_search.h"
#include "clouds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Eq. 2, one sample after the other. */
float
literalCID(const DistanceField& field, const Segment& segment, int samples)
{
  float largest = 0.0f;
  for (int l = 0; l < samples; ++l)
    largest = std::max(largest,
                       field.distance(segmentSample(segment.p, segment.q, l, samples)));
  return largest;
}

/** A value, bounds and comparisons agree with Eq. 2 wherever the search begins, and
 *  whatever it has found before.
 *  \param[in] search of the field and the order */
void
expectEquation2(const DistanceField& field,
                const SampleOrder& order,
                SegmentSearch& search,
                const Segment& segment)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float cid = literalCID(field, segment, order.samples());
  const std::size_t stride = std::max<std::size_t>(1, order.last() / 7);
  for (const float limit :
       {0.0f, 0.5f * cid, cid, std::nextafter(cid, 9e9f), 2.0f * cid, 1e9f})
    for (std::size_t first = 0; first <= order.last(); first += stride) {
      if (first > 0) // several times, also where it was the trail of other segments
        search.follow(first % 6);
      std::size_t hint = first;
      const DistanceBounds found = search.bounds(segment, limit, hint);
      EXPECT_LE(found.low, cid);
      EXPECT_GE(found.high, cid);
      EXPECT_EQ(found.low >= limit, cid >= limit);
      if (cid < limit) {
        EXPECT_LE(found.high, limit);
      }
      EXPECT_LE(hint, order.last());
      hint = first;
      const float bound = search.upperBound(segment, limit, UpperBound::quick, hint);
      EXPECT_GE(bound, std::min(cid, limit));
      EXPECT_LE(hint, order.last());
      hint = first;
      EXPECT_EQ(search.upperBound(segment, limit, UpperBound::exact, hint),
                std::min(cid, limit));
      EXPECT_LE(hint, order.last());
      hint = first;
      const float value = search.pointCID(segment, limit, hint);
      if (cid < limit) {
        EXPECT_EQ(value, cid);
      }
      else {
        EXPECT_GE(value, limit);
        EXPECT_LE(value, cid);
      }
      hint = first;
      EXPECT_EQ(search.pointCID(segment, infinity, hint), cid);
    }
}

/** The same for segments that one search is asked for one after another.
 *  \param[in] each called with a function that takes a segment */
template <typename Each>
void
expectEquation2(const DistanceField& field, int samples, const Each& each)
{
  const SampleOrder order(samples);
  SegmentSearch search(field, order);
  each([&](const Segment& segment) { expectEquation2(field, order, search, segment); });
}

class SegmentSearchAtScale : public testing::TestWithParam<float> {
protected:
  /** Points, fewer where squares of coordinates are below what float holds in full:
   * there many distances are equal, which takes long. */
  static std::size_t
  fewer(std::size_t points)
  {
    return GetParam() < 1e-15f ? points / 8 : points;
  }
};

TEST_P(SegmentSearchAtScale, EqualsEquation2WhateverTheHint)
{
  Points surface = twoBoxes(fewer(2000), 153);
  for (Eigen::Vector3f& p : surface)
    p *= GetParam();
  const DistanceField field(surface);
  for (const int samples : {2, 3, 40, 100})
    expectEquation2(field, samples, [&](const auto& expect) {
      for (std::size_t i = 0; i + 1 < fewer(50); ++i) {
        expect({surface[i], surface[i + 1], true});
        expect({surface[i], surface[i + 1], false});
      }
    });
}

TEST_P(SegmentSearchAtScale, EqualsEquation2OffTheSurface)
{
  Points surface = twoBoxes(fewer(500), 154);
  Points ends = randomCube(60, 155);
  for (Eigen::Vector3f& p : surface)
    p *= GetParam();
  for (Eigen::Vector3f& p : ends)
    p = GetParam() * (3.0f * p - Eigen::Vector3f::Ones());
  const DistanceField field(surface);
  expectEquation2(field, 100, [&](const auto& expect) {
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      expect({ends[i], ends[i + 1], false});
  });
}

INSTANTIATE_TEST_SUITE_P(Scales,
                         SegmentSearchAtScale,
                         testing::Values(1.0f, 1e-3f, 1e4f, 1e-20f),
                         [](const auto& info) {
                           return "Case" + std::to_string(info.index);
                         });

TEST(SegmentSearch, SegmentsOfNoLengthAndSurfacesOfOnePoint)
{
  const Points surface = {{0.1f, 0.2f, 0.3f}};
  const Points ends = {{0.1f, 0.2f, 0.3f}, {1.0f, 2.0f, 3.0f}, {-1.0f, 2.0f, 0.0f}};
  const DistanceField field(surface);
  for (const int samples : {2, 5, 100})
    expectEquation2(field, samples, [&](const auto& expect) {
      for (const Eigen::Vector3f& p : ends)
        for (const Eigen::Vector3f& q : ends)
          expect({p, q, false});
    });
}

TEST(SegmentSearch, ManySamples)
{
  const Points surface = twoBoxes(300, 156);
  const DistanceField field(surface);
  expectEquation2(field, 1025, [&](const auto& expect) {
    for (std::size_t i = 0; i + 1 < 8; ++i)
      expect({surface[i], surface[i + 1], true});
  });
}

TEST(SegmentSearch, OnRealScans)
{
  for (const char* name : {"room_scan1.pcd", "mosd_learn4.pcd"}) {
    const auto scan = loadSharedScan(name);
    if (!scan)
      GTEST_SKIP() << "../shared/data/" << name << " is absent";
    const Points surface = crop(*scan, 20000, 3);
    const DistanceField field(surface);
    expectEquation2(field, 100, [&](const auto& expect) {
      for (std::size_t i = 0; i + 1000 < surface.size(); i += 1000)
        expect({surface[i], surface[i + 999], true});
    });
  }
}

} // namespace
} // namespace pcl_cid::test
