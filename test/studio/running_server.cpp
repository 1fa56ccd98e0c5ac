/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A server that runs on a thread of its own, and what is behind it in tests.
 */

#include "running_server.h"

#include <utility>

namespace pcl_cid::studio::test {

std::optional<Resource>
FewResources::find(std::string_view path) const
{
  const auto row = table.find(path);
  if (row == table.end())
    return std::nullopt;
  return row->second;
}

std::vector<std::string>
RecordingHandler::waitFor(std::size_t lines)
{
  std::unique_lock<std::mutex> lock(mutex_);
  written_.wait(lock, [&] { return lines_.size() >= lines; });
  return {lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(lines)};
}

void
RecordingHandler::opened(ClientId client, bool is_writer)
{
  write("opened " + std::to_string(client) + (is_writer ? " writer" : ""));
}

void
RecordingHandler::message(ClientId client, Frame frame)
{
  write("message " + std::to_string(client));
  if (on_message)
    on_message(client, std::move(frame));
}

void
RecordingHandler::closed(ClientId client)
{
  write("closed " + std::to_string(client));
}

void
RecordingHandler::promoted(ClientId client)
{
  write("promoted " + std::to_string(client));
}

void
RecordingHandler::write(const std::string& line)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  lines_.push_back(line);
  written_.notify_all();
}

RunningServer::RunningServer(const ServerLimits& limits,
                             RecordingHandler::OnMessage on_message)
: server_(page_, handler_, 0, limits)
{
  page_.table["/"] = textResource("<!DOCTYPE html>page", "text/html; charset=utf-8");
  handler_.on_message = std::move(on_message);
  if (!handler_.on_message)
    handler_.on_message = [this](ClientId client, Frame frame) {
      server_.send(client, std::move(frame));
    };
  thread_ = std::thread([this] { server_.run(); });
}

RunningServer::RunningServer(const Resources& resources, const ServerLimits& limits)
: server_(resources, handler_, 0, limits), thread_([this] { server_.run(); })
{
}

RunningServer::~RunningServer()
{
  server_.stop();
  join();
}

void
RunningServer::join()
{
  if (thread_.joinable())
    thread_.join();
}

} // namespace pcl_cid::studio::test
