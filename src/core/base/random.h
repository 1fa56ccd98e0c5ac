/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The one source of randomness: the same draws on every machine and compiler.
 */

#pragma once

#include <cstdint>
#include <random>

namespace pcl_cid {

/** \brief A generator whose sequence the C++ standard fixes (the distributions of the
 *  standard library are not portable, so none of them is used). */
using RandomGenerator = std::mt19937_64;

/** \brief Uniform draw from 0, 1, ..., \a count - 1, by rejection.
 *  \param[in,out] generator advanced by one draw or, rarely, more
 *  \param[in] count number of outcomes, at least 1 */
inline std::uint64_t
drawBelow(RandomGenerator& generator, std::uint64_t count)
{
  const std::uint64_t surplus = (RandomGenerator::max() % count + 1) % count;
  const std::uint64_t last_accepted = RandomGenerator::max() - surplus;
  std::uint64_t value = generator();
  while (value > last_accepted)
    value = generator();
  return value % count;
}

} // namespace pcl_cid
