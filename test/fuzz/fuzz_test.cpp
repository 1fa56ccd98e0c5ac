/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Every reader with files that are damaged at random: a short run of what
 * scripts/fuzz.sh does at length.
 */

#include "base/random.h"
#include "fuzzed_readers.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace pcl_cid::test {

void
PrintTo(const FuzzedReader& reader, std::ostream* stream)
{
  *stream << reader.name;
}

namespace {

const std::string dictionary[] = {
    "0",       "-1",   "4294967296", "1e308", "nan",   "inf",   "\n",
    "\r",      "\r\n", "\t",         "\"",    ";",     "list",  "_",
    "COUNT 0", "[",    "{",          "]",     "}",     "#",     "\xEF\xBB\xBF",
    " ",       "0.5",  "ascii",      ",",     "label", "1e-46", "\xFF"};

std::size_t
placeIn(const std::string& text, RandomGenerator& generator)
{
  return drawBelow(generator, text.size() + 1);
}

/** One change, as a fuzzer makes them. */
void
damage(std::string& text, RandomGenerator& generator)
{
  const std::size_t at = placeIn(text, generator);
  const std::size_t count = drawBelow(generator, 20);
  switch (drawBelow(generator, 6)) {
  case 0:
    return text.resize(at);
  case 1:
    text.erase(at, count);
    return;
  case 2:
    text.insert(at, text.substr(placeIn(text, generator), count));
    return;
  case 3:
    text.insert(at, dictionary[drawBelow(generator, std::size(dictionary))]);
    return;
  case 4:
    text.insert(at, count, static_cast<char>(drawBelow(generator, 256)));
    return;
  default:
    if (at < text.size())
      text[at] = static_cast<char>(drawBelow(generator, 256));
  }
}

class FuzzedReaders : public testing::TestWithParam<FuzzedReader> {};

INSTANTIATE_TEST_SUITE_P(All,
                         FuzzedReaders,
                         testing::ValuesIn(fuzzedReaders()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(FuzzedReaders, ReadTheirCorpus)
{
  for (const std::string& file : GetParam().corpus)
    try {
      GetParam().read(file);
    }
    catch (const CIDException& error) {
      // Not all that is read has colors, to which use comes last.
      EXPECT_NE(std::string(error.what()).find("has no colors"), std::string::npos)
          << error.what();
    }
}

TEST_P(FuzzedReaders, RefuseWhatIsDamagedWithASentence)
{
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    RandomGenerator generator(seed);
    const auto& corpus = GetParam().corpus;
    std::string file = corpus[drawBelow(generator, corpus.size())];
    for (std::uint64_t k = 1 + drawBelow(generator, 4); k > 0; --k)
      damage(file, generator);
    try {
      GetParam().read(file);
    }
    catch (const CIDException&) {
    }
    catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what();
    }
  }
}

} // namespace
} // namespace pcl_cid::test
