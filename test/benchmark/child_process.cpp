/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One measurement, one process: its time and its own peak of memory.
 */

#include "child_process.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <errno.h> // program_invocation_short_name
#include <malloc.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pcl_cid::benchmarks {
namespace {

/** A line of /proc/self/status, such as "VmHWM:  1234 kB", in bytes. */
std::size_t
memoryStatus(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  std::size_t kilobytes = 0;
  while (status >> word)
    if (word == name + ":" && status >> kilobytes)
      return kilobytes * 1024;
  throw std::runtime_error("/proc/self/status has no " + name +
                           "; the benchmark needs Linux");
}

/** Make the peak of resident memory begin again at what is resident now. */
void
resetPeak()
{
  std::ofstream file("/proc/self/clear_refs");
  file << 5;
  file.close();
  if (!file)
    throw std::runtime_error("cannot write 5 to /proc/self/clear_refs; the benchmark "
                             "needs Linux");
}

/** What a child sends: this, then the seeds, then the labels. */
struct Header {
  double seconds;
  double share;
  std::uint64_t peak_bytes;
  std::uint64_t seeds;
  std::uint64_t labels;
};

void
send(int pipe, const void* data, std::size_t size)
{
  const char* rest = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = write(pipe, rest, size);
    if (written <= 0)
      throw std::runtime_error("cannot send the measurement to the parent process");
    rest += written;
    size -= static_cast<std::size_t>(written);
  }
}

template <typename Value>
void
sendAll(int pipe, const std::vector<Value>& values)
{
  send(pipe, values.data(), values.size() * sizeof(Value));
}

/** The child's part; its exit code. */
int
runChild(int pipe, const std::function<Measurement()>& measure)
{
  try {
    // Whoever stops this program stops the measurement, too.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    resetPeak();
    const std::size_t before = memoryStatus("VmRSS");
    const Measurement result = measure();
    const Header header{result.seconds,
                        result.share,
                        memoryStatus("VmHWM") - before,
                        result.seeds.size(),
                        result.labels.size()};
    send(pipe, &header, sizeof(header));
    sendAll(pipe, result.seeds);
    sendAll(pipe, result.labels);
    return 0;
  }
  catch (const std::exception& error) {
    std::cerr << program_invocation_short_name << ": " << error.what() << std::endl;
    return 1;
  }
}

std::vector<char>
receiveAll(int pipe)
{
  std::vector<char> bytes;
  std::array<char, 4096> buffer{};
  ssize_t count = 0;
  while ((count = read(pipe, buffer.data(), buffer.size())) > 0)
    bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + count);
  return bytes;
}

/** Take values off the front. */
template <typename Value>
std::vector<Value>
take(std::size_t count, const char*& bytes)
{
  std::vector<Value> values(count);
  if (count > 0)
    std::memcpy(values.data(), bytes, count * sizeof(Value));
  bytes += count * sizeof(Value);
  return values;
}

Measurement
decode(const std::vector<char>& received)
{
  const char* bytes = received.data();
  const Header header = take<Header>(1, bytes).front();
  const std::size_t announced = sizeof(header) + header.seeds * sizeof(pcl::index_t) +
                                header.labels * sizeof(std::uint32_t);
  if (received.size() != announced)
    throw std::runtime_error("a measurement was cut short");
  Measurement result;
  result.seconds = header.seconds;
  result.share = header.share;
  result.peak_bytes = header.peak_bytes;
  result.seeds = take<pcl::index_t>(header.seeds, bytes);
  result.labels = take<std::uint32_t>(header.labels, bytes);
  return result;
}

} // namespace

Measurement
measureInChild(const std::function<Measurement()>& measure)
{
  // Memory that was freed would be used again by the child and not count for it.
  malloc_trim(0);
  std::cout.flush();
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
    throw std::runtime_error("cannot make a pipe for a measurement");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("cannot start a process for a measurement");
  if (child == 0) {
    close(ends[0]);
    const int code = runChild(ends[1], measure);
    _exit(code);
  }
  close(ends[1]);
  const std::vector<char> bytes = receiveAll(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.size() < sizeof(Header))
    throw std::runtime_error("a measurement failed");
  return decode(bytes);
}

} // namespace pcl_cid::benchmarks
