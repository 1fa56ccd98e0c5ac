/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clients of the server: one that sends any bytes, one that asks, and a socket.
 */

#pragma once

#include "server/frame.h"
#include "server/local_server.h"

#include <map>
#include <string>
#include <string_view>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/verb.hpp>
#include <boost/beast/websocket/stream.hpp>

namespace pcl_cid::studio::test {

using Fields = std::map<std::string, std::string>;
using Answer = boost::beast::http::response<boost::beast::http::string_body>;
using Verb = boost::beast::http::verb;

/** \brief A connection that sends any bytes. */
class RawConnection {
public:
  explicit RawConnection(const LocalServer& server);

  /** \brief Send; what the other side does not take is lost without a word. */
  void
  write(std::string_view bytes);

  /** \brief All that comes until the server closes the connection. */
  std::string
  readAll();

  /** \brief An answer, with its body. */
  Answer
  read(bool is_to_head = false);

  boost::asio::ip::tcp::socket&
  socket()
  {
    return socket_;
  }

private:
  boost::asio::io_context context_;
  boost::asio::ip::tcp::socket socket_;
  boost::beast::flat_buffer buffer_;
};

/** \brief "127.0.0.1:PORT" */
std::string
hostOf(const LocalServer& server);

/** \brief "/?token=..." */
std::string
entryOf(const LocalServer& server);

/** \brief The cookie that who has the token gets, as "name=value". */
std::string
cookieOf(const LocalServer& server);

/** \brief What a page of the server sends along. */
Fields
ownFields(const LocalServer& server);

/** \brief Ask on a new connection.
 *  \param[in] fields with `Host`, if there is to be one */
Answer
ask(const LocalServer& server,
    const std::string& target,
    const Fields& fields,
    Verb verb = Verb::get);

/** \brief The status alone. */
unsigned int
statusOf(const LocalServer& server,
         const std::string& target,
         const Fields& fields,
         Verb verb = Verb::get);

/** \brief A socket of the page. */
class SocketClient {
public:
  explicit SocketClient(const LocalServer& server);

  void
  send(Frame frame);

  /** \brief Send any message. */
  void
  sendBytes(std::string_view bytes, bool is_binary = true);

  Frame
  receive();

  /** \brief The reason that the server gives for closing the socket; 0 when it goes
   *  without one. */
  boost::beast::websocket::close_reason
  waitForEnd();

  /** \brief Say good-bye. */
  void
  close();

  boost::beast::websocket::stream<boost::asio::ip::tcp::socket>&
  stream()
  {
    return stream_;
  }

private:
  boost::asio::io_context context_;
  boost::beast::websocket::stream<boost::asio::ip::tcp::socket> stream_;
};

/** \brief A frame with nothing but a header. */
Frame
frameOf(nlohmann::json header = nlohmann::json::object());

/** \brief All bytes of a frame. */
std::string
bytesOf(const EncodedFrame& frame);

} // namespace pcl_cid::studio::test
