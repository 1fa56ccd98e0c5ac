/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clients of the server: one that sends any bytes, one that asks, and a socket.
 */

#include "clients_of_tests.h"

#include <array>
#include <limits>
#include <optional>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>

namespace pcl_cid::studio::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;

void
connect(asio::ip::tcp::socket& socket, const LocalServer& server)
{
  socket.connect({asio::ip::address_v4::loopback(), server.port()});
}

} // namespace

RawConnection::RawConnection(const LocalServer& server) : socket_(context_)
{
  connect(socket_, server);
}

void
RawConnection::write(std::string_view bytes)
{
  beast::error_code ignored;
  asio::write(socket_, asio::buffer(bytes.data(), bytes.size()), ignored);
}

std::string
RawConnection::readAll()
{
  std::string all;
  std::array<char, 65536> some{};
  beast::error_code error;
  while (!error)
    all.append(some.data(), socket_.read_some(asio::buffer(some), error));
  return all;
}

Answer
RawConnection::read(bool is_to_head)
{
  http::response_parser<http::string_body> parser;
  parser.body_limit(std::numeric_limits<std::uint64_t>::max());
  parser.skip(is_to_head);
  http::read(socket_, buffer_, parser);
  return parser.release();
}

std::string
hostOf(const LocalServer& server)
{
  return "127.0.0.1:" + std::to_string(server.port());
}

std::string
entryOf(const LocalServer& server)
{
  const std::string url = server.url();
  return url.substr(url.find("/?"));
}

std::string
cookieOf(const LocalServer& server)
{
  const Answer answer = ask(server, entryOf(server), {{"Host", hostOf(server)}});
  const std::string cookie(answer[http::field::set_cookie]);
  return cookie.substr(0, cookie.find(';'));
}

Fields
ownFields(const LocalServer& server)
{
  return {{"Host", hostOf(server)}, {"Cookie", cookieOf(server)}};
}

Answer
ask(const LocalServer& server,
    const std::string& target,
    const Fields& fields,
    Verb verb)
{
  http::request<http::empty_body> request(verb, target, 11);
  for (const auto& [name, value] : fields)
    request.insert(name, value);
  RawConnection connection(server);
  http::write(connection.socket(), request);
  return connection.read(verb == Verb::head);
}

unsigned int
statusOf(const LocalServer& server,
         const std::string& target,
         const Fields& fields,
         Verb verb)
{
  return ask(server, target, fields, verb).result_int();
}

SocketClient::SocketClient(const LocalServer& server) : stream_(context_)
{
  connect(stream_.next_layer(), server);
  stream_.set_option(websocket::stream_base::decorator(
      [&, cookie = cookieOf(server)](websocket::request_type& request) {
        request.set(http::field::cookie, cookie);
        request.set(http::field::origin, "http://" + hostOf(server));
      }));
  stream_.handshake(hostOf(server), "/api/session");
  stream_.read_message_max(0);
}

void
SocketClient::send(Frame frame)
{
  sendBytes(bytesOf(EncodedFrame(std::move(frame))));
}

void
SocketClient::sendBytes(std::string_view bytes, bool is_binary)
{
  stream_.binary(is_binary);
  stream_.write(asio::buffer(bytes.data(), bytes.size()));
}

Frame
SocketClient::receive()
{
  beast::flat_buffer buffer;
  stream_.read(buffer);
  return decodeFrame({static_cast<const char*>(buffer.cdata().data()), buffer.size()});
}

websocket::close_reason
SocketClient::waitForEnd()
{
  beast::error_code error;
  while (!error) {
    beast::flat_buffer buffer;
    stream_.read(buffer, error);
  }
  return stream_.reason();
}

void
SocketClient::close()
{
  beast::error_code ignored;
  stream_.close(websocket::close_code::normal, ignored);
}

Frame
frameOf(nlohmann::json header)
{
  Frame frame;
  frame.header = std::move(header);
  return frame;
}

std::string
bytesOf(const EncodedFrame& frame)
{
  std::string bytes;
  for (const std::string_view piece : frame.pieces())
    bytes.append(piece);
  return bytes;
}

} // namespace pcl_cid::studio::test
