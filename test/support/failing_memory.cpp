/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * For LD_PRELOAD: memory that cannot be had, from the n-th request of main() on
 * (MEMORY_FAILS_FROM=n) or at the n-th alone (MEMORY_FAILS_AT=n). How many there were
 * goes to the file that MEMORY_COUNT names. Before main() the loader and the libraries'
 * static objects ask for memory, and after it nothing is left to go wrong.
 */

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>
#include <pthread.h>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void*
__libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

using Main = int (*)(int, char**, char**);

std::atomic<bool> is_counting{false};
std::atomic<long> requests{0};
long fails_from = 0;
long fails_at = 0;
Main real_main = nullptr;

long
numberIn(const char* variable)
{
  const char* const text = std::getenv(variable);
  return text == nullptr ? 0 : std::atol(text);
}

bool
mustFail()
{
  if (!is_counting)
    return false;
  const long request = ++requests;
  const bool fails = request == fails_at || (fails_from > 0 && request >= fails_from);
  if (fails)
    errno = ENOMEM;
  return fails;
}

int
countedMain(int argc, char** argv, char** environment)
{
  fails_from = numberIn("MEMORY_FAILS_FROM");
  fails_at = numberIn("MEMORY_FAILS_AT");
  is_counting = true;
  const int code = real_main(argc, argv, environment);
  is_counting = false;
  if (const char* const name = std::getenv("MEMORY_COUNT"))
    if (std::FILE* const file = std::fopen(name, "w")) {
      std::fprintf(file, "%ld", requests.load());
      std::fclose(file);
    }
  return code;
}

} // namespace

#pragma GCC visibility push(default)
extern "C" {

void*
malloc(std::size_t size)
{
  return mustFail() ? nullptr : __libc_malloc(size);
}

void*
calloc(std::size_t count, std::size_t size)
{
  return mustFail() ? nullptr : __libc_calloc(count, size);
}

void*
realloc(void* memory, std::size_t size)
{
  return mustFail() ? nullptr : __libc_realloc(memory, size);
}

void*
aligned_alloc(std::size_t alignment, std::size_t size)
{
  return mustFail() ? nullptr : __libc_memalign(alignment, size);
}

int
posix_memalign(void** memory, std::size_t alignment, std::size_t size)
{
  void* const got = mustFail() ? nullptr : __libc_memalign(alignment, size);
  if (got == nullptr)
    return ENOMEM;
  *memory = got;
  return 0;
}

int
pthread_create(pthread_t* thread,
               const pthread_attr_t* attributes,
               void* (*work)(void*),
               void* argument)
{
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const auto create =
      reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  static std::atomic<long> left{std::getenv("THREADS") ? numberIn("THREADS") : 1000000};
  return left-- > 0 ? create(thread, attributes, work, argument) : EAGAIN;
}

int
__libc_start_main(Main main,
                  int argc,
                  char** argv,
                  void (*init)(),
                  void (*fini)(),
                  void (*loader_fini)(),
                  void* stack_end)
{
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  real_main = main;
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(countedMain, argc, argv, init, fini, loader_fini, stack_end);
}
}
#pragma GCC visibility pop
