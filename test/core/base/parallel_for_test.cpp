/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Every index once, on any number of threads; errors and cancellation come through.
 */

#include "../../src/core/parallel_for.h"

#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr ProgressSpan whole{0.0, 1.0};

TEST(ParallelFor, VisitsEveryIndexOnce)
{
  for (const int threads : {1, 2, 3, 8})
    for (const std::size_t count : {0u, 1u, 7u, 256u, 10001u})
      for (const std::size_t grain : {1u, 64u, 100000u}) {
        std::vector<int> visits(count, 0);
        Progress progress({});
        parallelFor(count, grain, threads, progress, whole, [&](auto begin, auto end) {
          for (std::size_t i = begin; i < end; ++i)
            ++visits[i];
        });
        EXPECT_EQ(visits, std::vector<int>(count, 1));
      }
}

TEST(ParallelFor, UsesAsManyThreadsAsAsked)
{
  std::set<std::thread::id> seen;
  std::mutex mutex;
  Progress progress({});
  parallelFor(64, 1, 3, progress, whole, [&](auto, auto) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const std::lock_guard<std::mutex> lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_GT(seen.size(), 1u);
  EXPECT_LE(seen.size(), 3u);
}

TEST(ParallelFor, PassesAnExceptionOn)
{
  for (const int threads : {1, 3}) {
    Progress progress({});
    EXPECT_THROW(parallelFor(1000,
                             1,
                             threads,
                             progress,
                             whole,
                             [](auto begin, auto) {
                               if (begin == 500)
                                 throw std::logic_error("body");
                             }),
                 std::logic_error);
  }
}

TEST(ParallelFor, ReportsFromTheCallingThreadOnlyAndCancels)
{
  const auto caller = std::this_thread::get_id();
  for (const int threads : {1, 3}) {
    std::atomic<int> bodies{0};
    Progress progress([&](double) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      return false;
    });
    EXPECT_THROW(parallelFor(100000,
                             1,
                             threads,
                             progress,
                             whole,
                             [&](auto, auto) {
                               ++bodies;
                               std::this_thread::sleep_for(
                                   std::chrono::microseconds(50));
                             }),
                 CIDCancelled);
    EXPECT_LT(bodies, 100000);
  }
}

TEST(ParallelFor, LongBodiesCancelFromInside)
{
  const auto caller = std::this_thread::get_id();
  for (const int threads : {1, 2, 3}) {
    Progress progress([&](double) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      return false;
    });
    const auto body = [&](auto, auto) {
      for (;;) // ends by the cancel alone
        progress.poll();
    };
    EXPECT_THROW(parallelFor(4, 1, threads, progress, whole, body), CIDCancelled);
  }
}

} // namespace
} // namespace pcl_cid::test
