/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A connection that has become a WebSocket.
 */

#include "socket_connection.h"

#include "response.h"

#include <string_view>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/buffer_traits.hpp>
#include <boost/beast/core/buffers_prefix.hpp>

namespace pcl_cid::studio {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;

/** A long message goes in pieces, between which a ping can go, too. */
constexpr std::size_t piece_bytes = std::size_t{1} << 20;

/** What a buffer may keep between two messages. */
constexpr std::size_t kept_bytes = std::size_t{1} << 20;

constexpr int most_silent_looks = 3;

/** How long Beast itself waits. The rest is up to us: its own watch takes a page that
 * is busy with a long message for dead. */
websocket::stream_base::timeout
patience(ServerLimits::Time time)
{
  return {time, websocket::stream_base::none(), false};
}

std::vector<asio::const_buffer>
buffersOf(const EncodedFrame& frame)
{
  std::vector<asio::const_buffer> buffers;
  for (const std::string_view piece : frame.pieces())
    buffers.emplace_back(piece.data(), piece.size());
  return buffers;
}

std::shared_ptr<const EncodedFrame>
answerTo(const BadFrame& error)
{
  Frame answer;
  answer.header = {{"id", nullptr}, {"ok", false}, {"error", error.what()}};
  return std::make_shared<const EncodedFrame>(std::move(answer));
}

} // namespace

SocketConnection::SocketConnection(beast::tcp_stream stream, ServerParts& parts)
: Connection(parts.connections)
, parts_(parts)
, socket_(std::move(stream))
, timer_(socket_.get_executor())
{
}

SocketConnection::~SocketConnection() = default;

void
SocketConnection::accept(beast::http::request<beast::http::empty_body> request)
{
  request_ = std::move(request);
  socket_.binary(true);
  socket_.auto_fragment(false);
  socket_.read_message_max(parts_.limits.most_received);
  socket_.set_option(patience(parts_.limits.request_time));
  socket_.set_option(websocket::stream_base::decorator(
      [port = std::to_string(parts_.port)](websocket::response_type& response) {
        protect(response, port);
      }));
  socket_.async_accept(request_,
                       [me = self<SocketConnection>()](beast::error_code error) {
                         if (!error)
                           me->open();
                       });
}

void
SocketConnection::open()
{
  if (is_closing_)
    return;
  beast::error_code ignored;
  beast::get_lowest_layer(socket_).socket().set_option(asio::ip::tcp::no_delay(true),
                                                       ignored);
  socket_.set_option(patience(parts_.limits.close_time));
  // Kept alive by whoever reads: the pings come from the stream, which this owns.
  socket_.control_callback([this](websocket::frame_type /*type*/,
                                  beast::string_view /*text*/) { was_heard_ = true; });
  watch();
  id_ = parts_.clients.add(*this);
  read();
}

/** Some of a message at a time: a long one is a sign of life before it is there. */
void
SocketConnection::read()
{
  socket_.async_read_some(
      received_,
      0,
      [me = self<SocketConnection>()](beast::error_code error, std::size_t /*bytes*/) {
        me->onRead(error);
      });
}

void
SocketConnection::onRead(beast::error_code error)
{
  if (error)
    return onGone();
  was_heard_ = true;
  if (!is_closing_ && socket_.got_text())
    close(websocket::close_code::unknown_data, "Messages are binary.");
  else if (!is_closing_ && socket_.is_message_done())
    takeMessage();
  if (is_closing_)
    received_.clear();
  read();
}

void
SocketConnection::takeMessage()
{
  const asio::const_buffer bytes = received_.cdata();
  try {
    Frame frame = decodeFrame({static_cast<const char*>(bytes.data()), bytes.size()});
    parts_.clients.received(*id_, std::move(frame));
  }
  catch (const BadFrame& error) {
    send(answerTo(error));
  }
  received_.clear();
  if (received_.capacity() > kept_bytes)
    received_.shrink_to_fit();
}

void
SocketConnection::send(std::shared_ptr<const EncodedFrame> frame)
{
  if (is_closing_)
    return;
  if (!waiting_.empty() && waiting_bytes_ + frame->size() > parts_.limits.most_waiting)
    return abort();
  waiting_bytes_ += frame->size();
  waiting_.push_back(std::move(frame));
  if (waiting_.size() == 1)
    writeNext();
}

void
SocketConnection::writeNext()
{
  rest_ = decltype(rest_)(buffersOf(*waiting_.front()));
  writePiece();
}

void
SocketConnection::writePiece()
{
  const bool is_last = beast::buffer_bytes(rest_) <= piece_bytes;
  socket_.async_write_some(is_last,
                           beast::buffers_prefix(piece_bytes, rest_),
                           [me = self<SocketConnection>(),
                            is_last](beast::error_code error, std::size_t bytes) {
                             me->onWritten(error, bytes, is_last);
                           });
}

void
SocketConnection::onWritten(beast::error_code error, std::size_t bytes, bool was_last)
{
  if (error) // which whoever reads will find, too
    return abort();
  was_heard_ = true;
  rest_.consume(bytes);
  if (is_closing_)
    return;
  if (!was_last)
    return writePiece();
  waiting_bytes_ -= waiting_.front()->size();
  waiting_.pop_front();
  if (!waiting_.empty())
    writeNext();
}

void
SocketConnection::watch()
{
  timer_.expires_after(parts_.limits.ping_time);
  timer_.async_wait([me = self<SocketConnection>()](beast::error_code error) {
    if (!error && !me->is_closing_)
      me->onWatch();
  });
}

/** Looks are counted, not time: while the server was busy, nothing could be heard, but
 * it did not look either. */
void
SocketConnection::onWatch()
{
  silent_looks_ = was_heard_ ? 0 : silent_looks_ + 1;
  was_heard_ = false;
  if (silent_looks_ == most_silent_looks)
    return abort();
  ping();
  watch();
}

void
SocketConnection::ping()
{
  if (is_pinging_)
    return;
  is_pinging_ = true;
  socket_.async_ping({}, [me = self<SocketConnection>()](beast::error_code /*error*/) {
    me->is_pinging_ = false;
  });
}

void
SocketConnection::end()
{
  if (id_)
    close(websocket::close_code::going_away, "The server has ended.");
  else
    abort();
}

void
SocketConnection::close(websocket::close_code code, const std::string& reason)
{
  if (is_closing_)
    return;
  is_closing_ = true;
  timer_.expires_after(parts_.limits.close_time);
  timer_.async_wait([me = self<SocketConnection>()](beast::error_code error) {
    if (!error)
      me->abort();
  });
  socket_.async_close({code, reason},
                      [me = self<SocketConnection>()](beast::error_code /*error*/) {});
}

/** Ends at once: who does not read does not read good-byes. */
void
SocketConnection::abort()
{
  is_closing_ = true;
  beast::get_lowest_layer(socket_).close();
}

void
SocketConnection::onGone()
{
  is_closing_ = true;
  timer_.cancel();
  if (const auto id = std::exchange(id_, std::nullopt))
    parts_.clients.remove(*id);
}

} // namespace pcl_cid::studio
