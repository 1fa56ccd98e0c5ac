/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What is behind the sockets of the server.
 */

#pragma once

#include "frame.h"

#include <cstdint>

namespace pcl_cid::studio {

/** \brief The number of a connected page; never used twice. */
using ClientId = std::uint64_t;

/** \brief Is told what the pages do.
 *
 *  Everything is called on the thread of the server, one call after the other, and the
 *  server waits for it: long work belongs on another thread. Nothing may throw; what
 * does ends LocalServer::run(). */
class SessionHandler {
public:
  virtual ~SessionHandler() = default;

  /** \brief A page has connected.
   *  \param[in] is_writer no other one may change the session */
  virtual void
  opened(ClientId client, bool is_writer) = 0;

  /** \brief A page says something. */
  virtual void
  message(ClientId client, Frame frame) = 0;

  /** \brief A page is gone; nothing more comes from it and nothing reaches it. */
  virtual void
  closed(ClientId client) = 0;

  /** \brief The writer is gone, and this page, of those that are there the one that
   * came first, is it from now on. */
  virtual void
  promoted(ClientId client) = 0;
};

} // namespace pcl_cid::studio
