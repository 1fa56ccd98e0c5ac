/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parallel loops over ranges. No other file of the library starts a thread.
 */

#include "parallel_for.h"

#include <pcl_cid/core/settings.h>

#include <thread>
#include <utility>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

namespace pcl_cid {
namespace {

Helpers* of_process = nullptr;

void
makeOfProcess()
{
  of_process = new Helpers(
      [](std::function<void()> help) { std::thread(std::move(help)).detach(); });
}

/** Address space that the stacks of helpers cannot take, so that where it is limited
 *  some is left for the work: glibc takes 64 MB of it for each of the first threads
 * that allocate. Nobody touches it, so it costs nothing. */
class Reserve {
public:
  Reserve()
  : begin_(mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))
  {
  }

  ~Reserve()
  {
    if (isThere())
      munmap(begin_, bytes);
  }

  bool
  isThere() const
  {
    return begin_ != MAP_FAILED;
  }

  Reserve(const Reserve&) = delete;
  Reserve&
  operator=(const Reserve&) = delete;

private:
  static constexpr std::size_t bytes = std::size_t{1} << 30;
  void* begin_;
};

} // namespace

int
threadCount(unsigned int setting)
{
  if (setting != 0)
    return static_cast<int>(std::min(setting, setting::threads.most));
  // std::thread::hardware_concurrency() counts processors that the process may not use.
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0)
    return CPU_COUNT(&allowed);
  return static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
}

Helpers::Helpers(Starter start)
: start_(std::move(start)), most_(static_cast<std::size_t>(threadCount(0)) - 1)
{
}

/** Never destroyed: helpers sleep in it when the process ends, and callers may still be
 *  at work. Threads do not survive a fork, so a forked child starts a pool of its own.
 */
Helpers&
Helpers::ofProcess()
{
  static const int made = [] {
    makeOfProcess();
    return pthread_atfork(nullptr, nullptr, makeOfProcess);
  }();
  static_cast<void>(made);
  return *of_process;
}

void
Helpers::share(std::size_t helpers, const std::function<void()>& work)
{
  Job job{work, helpers};
  std::unique_lock<std::mutex> lock(mutex_);
  most_ = std::max(most_, helpers);
  jobs_.push_back(&job);
  startMissing();
  lock.unlock();
  for (std::size_t k = 0; k < helpers; ++k)
    asked_.notify_one();
  work();
  lock.lock();
  close(job); // no helper may join from here on: the job goes out of scope
  job.left.wait(lock, [&] { return job.inside == 0; });
}

/** Start helpers until as many are free as are wanted, or until that fails: the next
 *  job tries again. */
void
Helpers::startMissing()
{
  std::size_t wanted = 0;
  for (const Job* job : jobs_)
    wanted += job->wanted;
  const auto isMissing = [&] { return started_ < most_ && started_ - busy_ < wanted; };
  if (!isMissing())
    return;
  const Reserve reserve;
  try {
    while (reserve.isThere() && isMissing()) {
      start_([this] { help(); });
      ++started_;
    }
  }
  catch (const std::exception&) {
    // The threads that have been started do the work.
  }
}

/** Let no more helpers join: enough have, or nothing is left to begin. */
void
Helpers::close(const Job& job)
{
  jobs_.erase(std::remove(jobs_.begin(), jobs_.end(), &job), jobs_.end());
}

/** The loop that a helper runs. */
void
Helpers::help()
{
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    asked_.wait(lock, [this] { return !jobs_.empty(); });
    Job& job = *jobs_.front();
    if (--job.wanted == 0)
      close(job);
    ++job.inside;
    ++busy_;
    lock.unlock();
    job.work();
    lock.lock();
    --busy_;
    close(job);
    if (--job.inside == 0)
      job.left.notify_one();
  }
}

} // namespace pcl_cid
