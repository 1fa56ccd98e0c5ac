/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One measurement, one process: its time and its own peak of memory.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid::benchmarks {

/** \brief What came out of a measurement. */
struct Measurement {
  /** Wall time of the whole work, scaled up when only a share of it was done. */
  double seconds = 0.0;
  /** The share of the work that was done, above 0 to 1. */
  double share = 1.0;
  /** Most memory in use during the measurement, above what was in use before it. */
  std::size_t peak_bytes = 0;
  /** The seeds that were found, indices of the cloud; may be empty. */
  pcl::Indices seeds;
  /** A label for each point of the cloud; may be empty. */
  std::vector<std::uint32_t> labels;
};

/** \brief Run \a measure in a child of this process and wait for it.
 *
 *  A child begins with the memory of its parent, the cloud in it, and with nothing that
 *  an earlier measurement left behind: no warm heap, no threads.
 *  \param[in] measure fills in everything but peak_bytes
 *  \throws std::runtime_error when the child fails; it has then written why to the
 *  standard error */
Measurement
measureInChild(const std::function<Measurement()>& measure);

} // namespace pcl_cid::benchmarks
