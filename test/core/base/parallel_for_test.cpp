/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Every index once, on any number of threads; errors and cancellation come through, and
 * nobody waits for helpers that do not come.
 */

#include "base/parallel_for.h"

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pcl_cid::test {
namespace {

using namespace std::chrono_literals;

constexpr ProgressSpan whole{0.0, 1.0};

/** How often each index is visited. */
std::vector<int>
visitsOf(std::size_t count, std::size_t grain, int threads)
{
  std::vector<int> visits(count, 0);
  Progress progress({});
  parallelFor(count, grain, threads, progress, whole, [&](auto begin, auto end) {
    for (std::size_t i = begin; i < end; ++i)
      ++visits[i];
  });
  return visits;
}

TEST(ParallelFor, VisitsEveryIndexOnce)
{
  for (const int threads : {1, 2, 3, 8})
    for (const std::size_t count : {0u, 1u, 7u, 256u, 10001u})
      for (const std::size_t grain : {1u, 64u, 100000u})
        EXPECT_EQ(visitsOf(count, grain, threads), std::vector<int>(count, 1));
}

TEST(ParallelFor, UsesAsManyThreadsAsAsked)
{
  std::set<std::thread::id> seen;
  std::mutex mutex;
  Progress progress({});
  parallelFor(64, 1, 3, progress, whole, [&](auto, auto) {
    std::this_thread::sleep_for(2ms);
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
                               std::this_thread::sleep_for(50us);
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

TEST(ParallelFor, BodiesMayCallIt)
{
  const auto caller = std::this_thread::get_id();
  Progress progress([&](double) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    return true;
  });
  std::vector<int> visits(64 * 64, 0);
  parallelFor(64, 1, 3, progress, whole, [&](auto outer, auto) {
    parallelFor(64, 1, 3, progress, whole, [&](auto inner, auto) {
      std::this_thread::sleep_for(10us);
      ++visits[64 * outer + inner];
    });
  });
  EXPECT_EQ(visits, std::vector<int>(64 * 64, 1));
}

TEST(ParallelFor, BodiesThatCallItPassAnExceptionOn)
{
  Progress progress({});
  const auto inner = [](auto begin, auto) {
    if (begin == 5)
      throw std::logic_error("body");
  };
  EXPECT_THROW(
      parallelFor(8,
                  1,
                  3,
                  progress,
                  whole,
                  [&](auto, auto) { parallelFor(8, 1, 3, progress, whole, inner); }),
      std::logic_error);
}

TEST(ParallelFor, ManyThreadsMayCallItAtOnce)
{
  std::vector<std::future<void>> callers;
  for (int k = 0; k < 4; ++k)
    callers.push_back(std::async(std::launch::async, [] {
      for (int round = 0; round < 200; ++round)
        ASSERT_EQ(visitsOf(100, 1, 3), std::vector<int>(100, 1));
    }));
  for (std::future<void>& caller : callers)
    caller.get();
}

TEST(ParallelFor, WorksInAProcessThatWasForkedAfterUse)
{
  ASSERT_EQ(visitsOf(100, 1, 3), std::vector<int>(100, 1));
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    alarm(60); // rather than hang
    for (int round = 0; round < 20; ++round)
      if (visitsOf(100, 1, 3) != std::vector<int>(100, 1))
        _exit(1);
    _exit(0);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(visitsOf(100, 1, 3), std::vector<int>(100, 1));
}

TEST(ThreadCount, IsThatOfTheSettingOrOfTheProcessorsThatMayBeUsed)
{
  EXPECT_EQ(threadCount(1), 1);
  EXPECT_EQ(threadCount(7), 7);
  EXPECT_GT(threadCount(static_cast<unsigned int>(-1)), 0);
  EXPECT_GE(threadCount(0), 1);
  std::thread([] {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(sched_getcpu()), &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
    EXPECT_EQ(threadCount(0), 1);
  }).join();
}

/** Helpers that are started by a test; their threads keep them for as long as the
 *  process lives. */
Helpers&
makeHelpers(Helpers::Starter start)
{
  static auto* const all = new std::vector<Helpers*>; // within reach of leak checkers
  all->push_back(new Helpers(std::move(start)));
  return *all->back();
}

void
startThread(std::function<void()> help)
{
  std::thread(std::move(help)).detach();
}

TEST(ParallelForHelpers, AreDoneWithoutWhenNoneCanBeStarted)
{
  int tried = 0;
  Helpers& helpers = makeHelpers([&](auto) {
    ++tried;
    throw std::system_error(EAGAIN, std::generic_category());
  });
  int done = 0;
  for (int round = 1; round <= 3; ++round) {
    helpers.share(7, [&] { ++done; });
    EXPECT_EQ(done, round);
    EXPECT_EQ(tried, round); // once for each job, not for each helper
  }
}

TEST(ParallelForHelpers, AreAsManyAsCanBeStarted)
{
  int started = 0;
  Helpers& helpers = makeHelpers([&](auto help) {
    if (started == 2)
      throw std::system_error(EAGAIN, std::generic_category());
    startThread(help);
    ++started;
  });
  for (int round = 0; round < 3; ++round) {
    std::atomic<int> begun{0};
    helpers.share(7, [&] {
      ++begun;
      while (begun < 3) // until both are here
        std::this_thread::yield();
    });
    EXPECT_EQ(begun, 3);
  }
}

TEST(ParallelForHelpers, AreStartedOnce)
{
  std::atomic<int> started{0};
  Helpers& helpers = makeHelpers([&](auto help) {
    ++started;
    startThread(help);
  });
  for (int round = 0; round < 100; ++round)
    helpers.share(7, [] {});
  EXPECT_LE(started, 7);
}

TEST(ParallelForHelpers, AreNotWaitedForAndFindNothingWhenTheyComeLate)
{
  std::vector<std::function<void()>> late;
  Helpers& helpers = makeHelpers([&](auto help) { late.push_back(help); });
  const auto caller = std::this_thread::get_id();
  std::atomic<int> done{0};
  for (int round = 0; round < 3; ++round)
    helpers.share(2, [&] {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      ++done;
    });
  ASSERT_EQ(late.size(), 2u);
  for (const auto& help : late)
    startThread(help);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(done, 3);
  std::atomic<int> begun{0};
  helpers.share(2, [&] {
    ++begun;
    while (begun < 3)
      std::this_thread::yield();
  });
}

TEST(ParallelForHelpers, AreWaitedForOnceTheyHaveBegun)
{
  Helpers& helpers = makeHelpers(startThread);
  const auto caller = std::this_thread::get_id();
  for (int round = 0; round < 20; ++round) {
    std::atomic<bool> begun{false};
    std::atomic<bool> through{false};
    helpers.share(1, [&] {
      if (std::this_thread::get_id() == caller) {
        while (!begun)
          std::this_thread::yield();
        return;
      }
      begun = true;
      std::this_thread::sleep_for(2ms);
      through = true;
    });
    EXPECT_TRUE(through);
  }
}

} // namespace
} // namespace pcl_cid::test
