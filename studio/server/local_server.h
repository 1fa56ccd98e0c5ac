/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A server of pages and sockets for this machine, and for who has the token, alone.
 */

#pragma once

#include "frame.h"
#include "resource.h"
#include "server_limits.h"
#include "session_handler.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace pcl_cid::studio {

/** \brief The server cannot start; the message is one sentence. */
class ServerError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief Serves resources by HTTP and frames by a WebSocket, on 127.0.0.1
 *  (doc/studio_protocol.md). It knows nothing of what they say. */
class LocalServer {
public:
  /** \brief Opens the port; answers come when run() is called.
   *  \param[in] resources must outlive the server, as \a handler must
   *  \param[in] port 0: one that is free
   *  \throws ServerError when the port cannot be had */
  LocalServer(const Resources& resources,
              SessionHandler& handler,
              std::uint16_t port = 0,
              const ServerLimits& limits = {});
  ~LocalServer();

  LocalServer(const LocalServer&) = delete;
  LocalServer&
  operator=(const LocalServer&) = delete;

  std::uint16_t
  port() const;

  /** \brief What the user opens. It has the token: who knows it may do everything. */
  std::string
  url() const;

  /** \brief Serve, on this thread, until stop(). To be called once. */
  void
  run();

  /** \brief End run(), as soon as the pages have been told or do not listen. From any
   *  thread, before run() or while it runs, and as often as one likes. */
  void
  stop();

  /** \brief Let SIGINT and SIGTERM stop(). A second one does what it did before this
   *  call. To be called before run(). */
  void
  stopOnSignals();

  /** \brief Send a frame to a page; nothing happens where it is gone.
   *
   *  From any thread. Frames arrive in the order of the calls, broadcasts included,
   *  where one call is over before the next begins.
   *  \throws BadFrame when it is too long for a frame */
  void
  send(ClientId client, Frame frame);

  /** \brief Send a frame to all pages that are there, or to all but one. As send(). */
  void
  broadcast(Frame frame, std::optional<ClientId> but_not = std::nullopt);

private:
  class Implementation;

  std::unique_ptr<Implementation> implementation_;
};

} // namespace pcl_cid::studio
