/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A server of pages and sockets for this machine, and for who has the token, alone.
 */

#include "local_server.h"

#include "http_connection.h"
#include "outbox.h"
#include "server_parts.h"

#include <chrono>
#include <csignal>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>

#include <fcntl.h>

namespace pcl_cid::studio {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Error = boost::system::error_code;

/** What waits for the next try when the system has no more to give. */
constexpr auto pause_after_failure = std::chrono::milliseconds(100);

ServerError
cannotOpen(std::uint16_t port, const Error& error)
{
  const std::string name = "port " + std::to_string(port) + " of 127.0.0.1 ";
  if (error == asio::error::address_in_use)
    return ServerError(name + "is in use; choose another, or 0 for one that is free");
  return ServerError(name + "cannot be opened: " + error.message());
}

/** A browser that this process starts must not get the server's sockets. */
template <typename Socket>
void
keepToThisProcess(Socket& socket)
{
  fcntl(socket.native_handle(), F_SETFD, FD_CLOEXEC);
}

tcp::acceptor
openPort(asio::io_context& context, std::uint16_t port)
{
  tcp::acceptor acceptor(context);
  Error error;
  acceptor.open(tcp::v4(), error);
  if (error)
    throw cannotOpen(port, error);
  keepToThisProcess(acceptor);
  // Not in the way of a server that has just ended, but of one that listens.
  acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  acceptor.bind({asio::ip::address_v4::loopback(), port}, error);
  if (!error)
    acceptor.listen(tcp::acceptor::max_listen_connections, error);
  if (error)
    throw cannotOpen(port, error);
  return acceptor;
}

} // namespace

class LocalServer::Implementation {
public:
  Implementation(const Resources& resources,
                 SessionHandler& handler,
                 std::uint16_t port,
                 const ServerLimits& limits)
  : acceptor_(openPort(context_, port)), pause_(context_), signals_(context_)
  {
    const std::uint16_t own_port = acceptor_.local_endpoint().port();
    parts_.emplace(ServerParts{
        own_port, limits, RequestGuard(own_port), resources, Clients(handler)});
    accept();
  }

  const ServerParts&
  parts() const
  {
    return *parts_;
  }

  void
  run()
  {
    context_.run();
  }

  void
  stop()
  {
    asio::post(context_, [this] { end(); });
  }

  void
  stopOnSignals()
  {
    signals_.add(SIGINT);
    signals_.add(SIGTERM);
    signals_.async_wait([this](const Error& error, int /*signal*/) {
      if (!error)
        end();
    });
  }

  void
  send(Parcel parcel)
  {
    if (outbox_.put(std::move(parcel)))
      asio::post(context_, [this] { deliver(); });
  }

private:
  void
  accept()
  {
    acceptor_.async_accept([this](const Error& error, tcp::socket socket) {
      if (is_ended_)
        return;
      if (error)
        return acceptLater();
      welcome(std::move(socket));
      accept();
    });
  }

  /** The system has no more files, or the client has gone already. */
  void
  acceptLater()
  {
    pause_.expires_after(pause_after_failure);
    pause_.async_wait([this](const Error& error) {
      if (!error)
        accept();
    });
  }

  void
  welcome(tcp::socket socket)
  {
    keepToThisProcess(socket);
    const std::size_t open = parts_->connections.count();
    const std::size_t most = parts_->limits.most_connections;
    if (open >= 2 * most) // those that are told so count as well, for a moment
      return;
    const auto connection =
        std::make_shared<HttpConnection>(std::move(socket), *parts_);
    if (open < most)
      return connection->start();
    connection->refuse({boost::beast::http::status::service_unavailable,
                        "More than " + std::to_string(most) +
                            " connections are open; close some pages."});
  }

  void
  deliver()
  {
    for (const Parcel& parcel : outbox_.takeAll())
      if (parcel.to)
        parts_->clients.send(*parcel.to, parcel.frame);
      else
        parts_->clients.broadcast(parcel.frame, parcel.but_not);
  }

  /** Takes away all that run() waits for. */
  void
  end()
  {
    if (std::exchange(is_ended_, true))
      return;
    Error ignored;
    acceptor_.close(ignored);
    pause_.cancel();
    signals_.cancel(ignored);
    signals_.clear(ignored);
    parts_->clients.end();
    parts_->connections.endAll();
  }

  // The connections live in what the context has still to do: it goes first.
  std::optional<ServerParts> parts_;
  Outbox outbox_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  asio::signal_set signals_;
  bool is_ended_ = false;
};

LocalServer::LocalServer(const Resources& resources,
                         SessionHandler& handler,
                         std::uint16_t port,
                         const ServerLimits& limits)
: implementation_(std::make_unique<Implementation>(resources, handler, port, limits))
{
}

LocalServer::~LocalServer() = default;

std::uint16_t
LocalServer::port() const
{
  return implementation_->parts().port;
}

std::string
LocalServer::url() const
{
  return implementation_->parts().guard.url();
}

void
LocalServer::run()
{
  implementation_->run();
}

void
LocalServer::stop()
{
  implementation_->stop();
}

void
LocalServer::stopOnSignals()
{
  implementation_->stopOnSignals();
}

void
LocalServer::send(ClientId client, Frame frame)
{
  implementation_->send(
      {std::make_shared<const EncodedFrame>(std::move(frame)), client});
}

void
LocalServer::broadcast(Frame frame, std::optional<ClientId> but_not)
{
  implementation_->send(
      {std::make_shared<const EncodedFrame>(std::move(frame)), std::nullopt, but_not});
}

} // namespace pcl_cid::studio
