/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One reader under libFuzzer. The environment names it (PCL_CID_FUZZED) and, for a
 * folder to begin with, where its corpus is written to (PCL_CID_CORPUS).
 */

#include "cloud_files.h"
#include "fuzzed_readers.h"

#include <pcl_cid/exceptions.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <pcl/console/print.h>

namespace {

using namespace pcl_cid;

const test::FuzzedReader&
fuzzedReader()
{
  const char* const name = std::getenv("PCL_CID_FUZZED");
  for (const test::FuzzedReader& reader : test::fuzzedReaders())
    if (name && reader.name == std::string(name))
      return reader;
  std::fprintf(stderr, "PCL_CID_FUZZED must name a reader:");
  for (const test::FuzzedReader& reader : test::fuzzedReaders())
    std::fprintf(stderr, " %s", reader.name);
  std::fprintf(stderr, "\n");
  std::exit(EXIT_FAILURE);
}

} // namespace

extern "C" int
LLVMFuzzerInitialize(int*, char***)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const test::FuzzedReader& reader = fuzzedReader();
  if (const char* const folder = std::getenv("PCL_CID_CORPUS"))
    for (std::size_t i = 0; i < reader.corpus.size(); ++i)
      test::writeText(std::string(folder) + "/" + reader.name + std::to_string(i),
                      reader.corpus[i]);
  return 0;
}

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const test::FuzzedReader& reader = fuzzedReader();
  try {
    reader.read({reinterpret_cast<const char*>(data), size});
  }
  catch (const CIDException&) {
  }
  return 0;
}
