/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A connection that has become a WebSocket.
 */

#pragma once

#include "server_parts.h"

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_suffix.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket/stream.hpp>

namespace pcl_cid::studio {

/** \brief The socket of a page: takes its frames in, and sends it what waits for it. */
class SocketConnection : public Connection, public Client {
public:
  SocketConnection(boost::beast::tcp_stream stream, ServerParts& parts);
  ~SocketConnection() override;

  /** \brief Answer the request for a socket, then begin.
   *  \param[in] request one that the guard lets in */
  void
  accept(boost::beast::http::request<boost::beast::http::empty_body> request);

  void
  send(std::shared_ptr<const EncodedFrame> frame) override;

  void
  end() override;

private:
  void
  open();

  void
  read();

  void
  onRead(boost::beast::error_code error);

  void
  takeMessage();

  void
  writeNext();

  void
  writePiece();

  void
  onWritten(boost::beast::error_code error, std::size_t bytes, bool was_last);

  void
  watch();

  void
  onWatch();

  void
  ping();

  void
  close(boost::beast::websocket::close_code code, const std::string& reason);

  void
  abort();

  void
  onGone();

  ServerParts& parts_;
  boost::beast::websocket::stream<boost::beast::tcp_stream, false> socket_;
  boost::beast::http::request<boost::beast::http::empty_body> request_;
  boost::asio::steady_timer timer_; ///< watches; then waits for the end
  std::optional<ClientId> id_;      ///< while it is open
  bool is_closing_ = false;

  boost::beast::flat_buffer received_;

  std::deque<std::shared_ptr<const EncodedFrame>> waiting_; ///< the first is being sent
  std::size_t waiting_bytes_ = 0;
  /** What is left of the first. */
  boost::beast::buffers_suffix<std::vector<boost::asio::const_buffer>> rest_;

  bool was_heard_ = true; ///< since the last look
  int silent_looks_ = 0;
  bool is_pinging_ = false;
};

} // namespace pcl_cid::studio
