/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A connection that speaks HTTP.
 */

#pragma once

#include "response.h"
#include "server_parts.h"

#include <optional>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/serializer.hpp>

namespace pcl_cid::studio {

/** \brief Reads requests and answers them, one after the other, until the client goes,
 *  becomes a socket, or does what is not allowed. */
class HttpConnection : public Connection {
public:
  HttpConnection(boost::asio::ip::tcp::socket socket, ServerParts& parts);

  /** \brief Begin to read. */
  void
  start();

  /** \brief Say why not, and end: there are too many connections. */
  void
  refuse(const Refusal& refusal);

  void
  end() override;

private:
  void
  readRequest();

  void
  onRequest(boost::beast::error_code error);

  void
  refuseUnreadable(boost::beast::error_code error);

  void
  answer();

  void
  enter();

  void
  becomeSocket();

  void
  give(Resource resource);

  void
  say(const Refusal& refusal);

  void
  send(Resource resource, Response response);

  void
  writeMore();

  void
  onWritten(boost::beast::error_code error);

  void
  sayGoodbye();

  void
  discardRest();

  const RequestHeader&
  request() const
  {
    return parser_->get();
  }

  ServerParts& parts_;
  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::empty_body>>
      parser_;
  bool is_last_ = false; ///< the connection ends with this answer

  // The answer that is being sent, in an order in which they can go.
  Resource resource_;
  Response response_;
  std::optional<boost::beast::http::response_serializer<
      boost::beast::http::span_body<const char>>>
      serializer_;
};

} // namespace pcl_cid::studio
