/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A server that runs on a thread of its own, and what is behind it in tests.
 */

#pragma once

#include "server/local_server.h"

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pcl_cid::studio::test {

/** \brief Resources from a table. */
class FewResources : public Resources {
public:
  std::optional<Resource>
  find(std::string_view path) const override;

  std::map<std::string, Resource, std::less<>> table{};
};

/** \brief Writes down what it is told: "opened 1 writer", "message 1", "closed 1",
 *  "promoted 2". */
class RecordingHandler : public SessionHandler {
public:
  using OnMessage = std::function<void(ClientId, Frame)>;

  /** \brief What to do with messages; to be set before the server runs. */
  OnMessage on_message{};

  /** \brief The first lines, once there are as many. */
  std::vector<std::string>
  waitFor(std::size_t lines);

  void
  opened(ClientId client, bool is_writer) override;

  void
  message(ClientId client, Frame frame) override;

  void
  closed(ClientId client) override;

  void
  promoted(ClientId client) override;

private:
  void
  write(const std::string& line);

  std::mutex mutex_;
  std::condition_variable written_;
  std::vector<std::string> lines_;
};

/** \brief A server with a page at `/` and echoes at the socket, until it goes. */
class RunningServer {
public:
  /** \param[in] on_message instead of sending a message back to where it is from */
  explicit RunningServer(const ServerLimits& limits = {},
                         RecordingHandler::OnMessage on_message = {});

  /** \param[in] resources instead of the page */
  RunningServer(const Resources& resources, const ServerLimits& limits);

  ~RunningServer();

  /** \brief Wait until run() has returned. */
  void
  join();

  LocalServer&
  operator*()
  {
    return server_;
  }

  LocalServer*
  operator->()
  {
    return &server_;
  }

  RecordingHandler&
  handler()
  {
    return handler_;
  }

private:
  FewResources page_;
  RecordingHandler handler_;
  LocalServer server_;
  std::thread thread_;
};

} // namespace pcl_cid::studio::test
