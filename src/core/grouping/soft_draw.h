/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Random draws of seeds that are the largest of something, too.
 */

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl_cid {

/** \brief A draw with the probability of point i in proportion to cost_i^16, as an
 *  argmax (*ours*).
 *
 *  With independent exponential variables E_i, argmax of cost_i^16 / E_i is such a draw
 *  (Efraimidis and Spirakis, "Weighted random sampling with a reservoir", 2006), and it
 *  is that of cost_i * E_i^(-1/16). So what holds for the farthest point, bounds and
 *  all, holds for the one that is drawn. E_i comes from a hash of the random seed, the
 *  number of the draw and i: it is the same for every order and number of threads. */
class SoftDraw {
public:
  /** At least any factor(). */
  static constexpr float largest_factor = 4.2f;

  SoftDraw(std::uint64_t random_seed, std::uint64_t draw)
  : key_(mixed(mixed(random_seed) + draw))
  {
  }

  /** \brief E_i^(-1/16). */
  float
  factor(std::size_t i) const
  {
    const auto bits = static_cast<double>(mixed(key_ + i) >> 32);
    const double uniform = (bits + 0.5) / 4294967296.0; // above 0, below 1
    const double exponential = -std::log(uniform);
    return static_cast<float>(1.0 /
                              std::sqrt(std::sqrt(std::sqrt(std::sqrt(exponential)))));
  }

private:
  /** SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators",
   *  2014). */
  static std::uint64_t
  mixed(std::uint64_t z)
  {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t key_;
};

} // namespace pcl_cid
