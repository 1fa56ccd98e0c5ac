/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How much and how long the server puts up with.
 */

#pragma once

#include <chrono>
#include <cstddef>

namespace pcl_cid::studio {

/** \brief How much and how long the server puts up with; the tests are less patient. */
struct ServerLimits {
  using Time = std::chrono::milliseconds;

  std::size_t most_connections = 64;
  std::size_t most_header = std::size_t{32} << 10;   ///< bytes of a request
  std::size_t most_received = std::size_t{64} << 20; ///< bytes of a message
  /** Bytes of messages that wait for a page that does not read. One alone may be
   *  longer. */
  std::size_t most_waiting = std::size_t{512} << 20;

  Time request_time = std::chrono::seconds(30); ///< until a request is there
  Time write_time = std::chrono::seconds(30); ///< until a client takes some more bytes
  Time close_time = std::chrono::seconds(2);  ///< until a client says good-bye as well
  /** Between two looks at a socket. One that is silent is pinged, and given up when it
   *  was silent at three of them. */
  Time ping_time = std::chrono::seconds(60);
};

} // namespace pcl_cid::studio
