/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Costs that are kept, against costs that are computed.
 */

#include "clouds.h"
#include "prepared_points.h"

#include "base/random.h"
#include "grouping/known_costs.h"

#include <pcl_cid/core/concavity.h>

#include <limits>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Few pairs again and again, with limits that rise and fall: costs are known exactly,
 * from below, or were forgotten. */
TEST(KnownCosts, AreTheCostsOrAtLeastTheLimit)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    PreparationSettings settings = plainSettings();
    settings.normals = 0.03f;
    const auto scan = prepared(cloud.points, settings);
    const WorkingPoints& working = scan->working();
    constexpr int samples = 20;
    KnownCosts costs(working, samples);
    SegmentSearch search = costs.search();
    RandomGenerator generator(7);
    for (int i = 0; i < 3000; ++i) {
      const std::size_t p =
          drawBelow(generator, std::min<std::size_t>(working.size(), 9));
      const std::size_t q = drawBelow(generator, working.size());
      const float cost = working.costs().between(p, q).of(
          pointCID(scan->field(), working.points()[p], working.points()[q], samples));
      const float limits[] = {
          0.0f, cost / 2, cost, std::nextafter(cost, 2 * cost + 1), INFINITY};
      const float limit = limits[drawBelow(generator, 5)];
      const float found = costs.cost(p, q, limit, search);
      EXPECT_LE(found, cost);
      if (cost < limit)
        EXPECT_EQ(found, cost);
      else
        EXPECT_GE(found, limit);
    }
  }
}

} // namespace
} // namespace pcl_cid::test
