/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A connection that speaks HTTP.
 */

#include "http_connection.h"

#include "socket_connection.h"

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

namespace pcl_cid::studio {
namespace {

namespace beast = boost::beast;
namespace http = boost::beast::http;

constexpr std::string_view socket_path = "/api/session";

std::string_view
pathOf(const RequestHeader& request)
{
  const std::string_view target(request.target().data(), request.target().size());
  return target.substr(0, target.find('?'));
}

} // namespace

HttpConnection::HttpConnection(boost::asio::ip::tcp::socket socket, ServerParts& parts)
: Connection(parts.connections), parts_(parts), stream_(std::move(socket))
{
}

void
HttpConnection::start()
{
  readRequest();
}

void
HttpConnection::refuse(const Refusal& refusal)
{
  is_last_ = true;
  parser_.emplace();
  say(refusal);
}

void
HttpConnection::end()
{
  stream_.close();
}

void
HttpConnection::readRequest()
{
  parser_.emplace();
  // No body is read, so none is too long: it is refused for what it is.
  parser_->body_limit(std::numeric_limits<std::uint64_t>::max());
  parser_->header_limit(static_cast<std::uint32_t>(parts_.limits.most_header));
  stream_.expires_after(parts_.limits.request_time);
  http::async_read_header(
      stream_,
      buffer_,
      *parser_,
      [me = self<HttpConnection>()](beast::error_code error, std::size_t /*bytes*/) {
        me->onRequest(error);
      });
}

void
HttpConnection::onRequest(beast::error_code error)
{
  if (error)
    return refuseUnreadable(error);
  // Nothing that we answer has a body, so none is read.
  is_last_ = !parser_->is_done() || !parser_->keep_alive();
  answer();
}

/** Answers what is no request; who is gone or too slow gets no answer. */
void
HttpConnection::refuseUnreadable(beast::error_code error)
{
  const auto& of_http = http::make_error_code(http::error::end_of_stream).category();
  if (error.category() != of_http || error == http::error::end_of_stream)
    return;
  if (error == http::error::header_limit)
    return refuse({http::status::request_header_fields_too_large,
                   "The header of this request has more than " +
                       std::to_string(parts_.limits.most_header) + " bytes."});
  refuse({http::status::bad_request, "This is not a request in HTTP."});
}

void
HttpConnection::answer()
{
  const RequestGuard& guard = parts_.guard;
  if (RequestGuard::isEntry(request()))
    return enter();
  const bool is_socket = pathOf(request()) == socket_path;
  const auto refusal =
      is_socket ? guard.refusalOfSocket(request()) : guard.refusal(request());
  if (refusal)
    return say(*refusal);
  if (!parser_->is_done())
    return say({http::status::bad_request, "A GET has no body."});
  if (is_socket)
    return becomeSocket();
  if (auto found = parts_.resources.find(pathOf(request())))
    return give(std::move(*found));
  say({http::status::not_found, "There is nothing at this address."});
}

/** Gives the cookie to who has the token. */
void
HttpConnection::enter()
{
  if (const auto refusal = parts_.guard.refusalOfEntry(request()))
    return say(*refusal);
  // Where another site has led here, the browser does not send the cookie to where we
  // redirect, but does to where our own page leads.
  const bool is_led = RequestGuard::isLedByOthers(request());
  Resource page = textResource(
      is_led ? "<!DOCTYPE html><meta http-equiv=\"refresh\" content=\"0; url=/\">" : "",
      "text/html; charset=utf-8");
  const auto status = is_led ? http::status::ok : http::status::see_other;
  Response response = responseWith(page, status, request());
  response.set(http::field::set_cookie, parts_.guard.cookie());
  if (!is_led)
    response.set(http::field::location, "/");
  send(std::move(page), std::move(response));
}

void
HttpConnection::becomeSocket()
{
  if (!beast::websocket::is_upgrade(parser_->get()))
    return say({http::status::upgrade_required, "At this address is a WebSocket."});
  if (buffer_.size() != 0) {
    is_last_ = true;
    return say({http::status::bad_request,
                "A client must not use its socket before it is accepted."});
  }
  stream_.expires_never();
  std::make_shared<SocketConnection>(std::move(stream_), parts_)
      ->accept(parser_->release());
}

void
HttpConnection::give(Resource resource)
{
  if (resource.is_gzip && !takesGzip(request()))
    return say({http::status::not_acceptable,
                "This is stored as gzip alone, which this client does not accept."});
  Response response = responseWith(resource, http::status::ok, request());
  send(std::move(resource), std::move(response));
}

void
HttpConnection::say(const Refusal& refusal)
{
  Resource sentence = textResource(refusal.sentence + "\n");
  Response response = responseWith(sentence, refusal.status, request());
  if (refusal.status == http::status::method_not_allowed)
    response.set(http::field::allow, "GET, HEAD");
  if (refusal.status == http::status::upgrade_required)
    response.set(http::field::upgrade, "websocket");
  send(std::move(sentence), std::move(response));
}

void
HttpConnection::send(Resource resource, Response response)
{
  serializer_.reset();
  resource_ = std::move(resource);
  response_ = std::move(response);
  response_.keep_alive(!is_last_);
  protect(response_, std::to_string(parts_.port));
  serializer_.emplace(response_);
  writeMore();
}

/** Some of the answer at a time: a client may take long for all of it, but not for
 *  some. */
void
HttpConnection::writeMore()
{
  stream_.expires_after(parts_.limits.write_time);
  http::async_write_some(
      stream_,
      *serializer_,
      [me = self<HttpConnection>()](beast::error_code error, std::size_t /*bytes*/) {
        me->onWritten(error);
      });
}

void
HttpConnection::onWritten(beast::error_code error)
{
  if (error)
    return;
  if (!serializer_->is_done())
    return writeMore();
  serializer_.reset();
  resource_ = {};
  if (is_last_)
    sayGoodbye();
  else
    readRequest();
}

/** A connection that is closed with bytes unread is reset, and the client may lose the
 *  answer: read what there is for a while. */
void
HttpConnection::sayGoodbye()
{
  beast::error_code ignored;
  stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  stream_.expires_after(parts_.limits.close_time);
  discardRest();
}

void
HttpConnection::discardRest()
{
  buffer_.clear();
  stream_.async_read_some(
      buffer_.prepare(4096),
      [me = self<HttpConnection>()](beast::error_code error, std::size_t /*bytes*/) {
        if (!error)
          me->discardRest();
      });
}

} // namespace pcl_cid::studio
