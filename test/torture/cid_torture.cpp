/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Random cases without end: nasty clouds with all settings, checked against the
 * definitions. A number is a case.
 */

#include "torture_checks.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

#include <pcl/console/print.h>

#include <unistd.h>

namespace pcl_cid::test {
namespace {

constexpr const char* usage =
    "cid_torture [--first N] [--cases N] [--seconds S] [--case N]\n"
    "  --first N    number of the first case (1)\n"
    "  --cases N    how many cases (1000)\n"
    "  --seconds S  stop after so long (0: never)\n"
    "  --case N     this case alone, and print it\n"
    "Exit code 1 where something does not hold. A crash names its case.\n";

struct Request {
  std::uint64_t first = 1;
  std::uint64_t cases = 1000;
  double seconds = 0.0;
  bool prints = false;
};

/** \return false where the arguments are not understood */
bool
read(int argc, char** argv, Request& request)
{
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (i + 1 == argc)
      return false;
    char* end = nullptr;
    const double value = std::strtod(argv[++i], &end);
    if (*end != '\0' || !(value >= 0.0))
      return false;
    if (option == "--first")
      request.first = static_cast<std::uint64_t>(value);
    else if (option == "--cases")
      request.cases = static_cast<std::uint64_t>(value);
    else if (option == "--seconds")
      request.seconds = value;
    else if (option == "--case") {
      request.first = static_cast<std::uint64_t>(value);
      request.cases = 1;
      request.prints = true;
    }
    else
      return false;
  }
  return true;
}

/** What a crash prints; static, as a signal handler can take nothing along. */
std::array<char, 64> last_words = {};

void
nameCase(std::uint64_t number)
{
  std::snprintf(last_words.data(),
                last_words.size(),
                "FAULT: crash, --case %llu\n",
                static_cast<unsigned long long>(number));
}

void
say(int signal)
{
  const auto written =
      write(STDERR_FILENO, last_words.data(), std::strlen(last_words.data()));
  std::signal(signal, SIG_DFL);
  std::raise(written < 0 ? SIGABRT : signal);
}

/** \return how many cases have a fault */
std::uint64_t
torture(const Request& request)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  std::uint64_t faults = 0;
  std::uint64_t refused = 0;
  std::uint64_t n = 0;
  for (; n < request.cases; ++n) {
    const std::chrono::duration<double> passed = Clock::now() - begin;
    if (request.seconds > 0.0 && passed.count() > request.seconds)
      break;
    const TortureCase one(request.first + n);
    nameCase(one.number);
    if (request.prints)
      std::cout << one << std::endl; // it may crash
    const TortureVerdict verdict = judge(one);
    refused += verdict.refusal.empty() ? 0 : 1;
    if (!verdict.fault.empty() && !request.prints)
      std::cout << one;
    if (!verdict.fault.empty() || request.prints)
      std::cout << (verdict.fault.empty() ? "all holds " : "FAULT: ") << verdict.fault
                << verdict.refusal << std::endl;
    faults += verdict.fault.empty() ? 0 : 1;
  }
  std::cout << n << " cases, " << refused << " refused, " << faults << " with a fault"
            << std::endl;
  return faults;
}

} // namespace
} // namespace pcl_cid::test

int
main(int argc, char** argv)
{
  using namespace pcl_cid::test;
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE})
    std::signal(signal, say);
  Request request;
  if (!read(argc, argv, request)) {
    std::cerr << usage;
    return 2;
  }
  return torture(request) == 0 ? 0 : 1;
}
