/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Who may ask the server for anything: the page that the user opened, and nobody else.
 */

#include "request_guard.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include <boost/beast/http/field.hpp>
#include <boost/beast/http/verb.hpp>

#include <sys/random.h>

namespace pcl_cid::studio {
namespace {

namespace http = boost::beast::http;

constexpr std::string_view entry_target = "/?token=";

std::string_view
view(boost::beast::string_view text)
{
  return {text.data(), text.size()};
}

/** 128 random bits, in hexadecimal digits. */
std::string
randomSecret()
{
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "no random numbers");
  std::string digits;
  for (const unsigned char byte : bytes) {
    digits += "0123456789abcdef"[byte >> 4];
    digits += "0123456789abcdef"[byte & 15];
  }
  return digits;
}

/** In a time that does not tell how much of the secret was right. */
bool
areEqual(std::string_view given, std::string_view secret)
{
  if (given.size() != secret.size())
    return false;
  unsigned int difference = 0;
  for (std::size_t i = 0; i < secret.size(); ++i)
    difference |= static_cast<unsigned char>(given[i]) ^
                  static_cast<unsigned int>(static_cast<unsigned char>(secret[i]));
  return difference == 0;
}

/** The value of a field that may be there once. */
std::optional<std::string_view>
only(const RequestHeader& request, std::string_view name)
{
  const boost::beast::string_view field(name.data(), name.size());
  if (request.count(field) != 1)
    return std::nullopt;
  return view(request.find(field)->value());
}

bool
has(const RequestHeader& request, std::string_view name)
{
  return request.count(boost::beast::string_view(name.data(), name.size())) != 0;
}

/** Whether one of the cookies in "a=b; c=d" is `name=secret`. */
bool
isAmong(std::string_view cookies, std::string_view name, std::string_view secret)
{
  while (!cookies.empty()) {
    const std::size_t end = cookies.find(';');
    std::string_view cookie = cookies.substr(0, end);
    cookies.remove_prefix(end == std::string_view::npos ? cookies.size() : end + 1);
    cookie.remove_prefix(std::min(cookie.find_first_not_of(' '), cookie.size()));
    const std::size_t equals = cookie.find('=');
    if (cookie.substr(0, equals) == name && equals != std::string_view::npos &&
        areEqual(cookie.substr(equals + 1), secret))
      return true;
  }
  return false;
}

/** Browsers do not tell ports apart in cookies. */
std::string
cookieName(std::uint16_t port)
{
  return "pcl_cid_studio_" + std::to_string(port);
}

bool
isOurOrigin(const RequestHeader& request)
{
  const auto origin = only(request, "Origin");
  const auto host = only(request, "Host");
  return origin && host && *origin == "http://" + std::string(*host);
}

} // namespace

RequestGuard::RequestGuard(std::uint16_t port)
: port_(port), token_(randomSecret()), secret_(randomSecret())
{
}

std::string
RequestGuard::url() const
{
  return "http://127.0.0.1:" + std::to_string(port_) + std::string(entry_target) +
         token_;
}

std::string
RequestGuard::cookie() const
{
  return cookieName(port_) + "=" + secret_ + "; HttpOnly; SameSite=Strict; Path=/";
}

bool
RequestGuard::isEntry(const RequestHeader& request)
{
  return view(request.target()).substr(0, entry_target.size()) == entry_target;
}

bool
RequestGuard::isLedByOthers(const RequestHeader& request)
{
  const auto site = only(request, "Sec-Fetch-Site");
  return has(request, "Sec-Fetch-Site") && site != "same-origin" && site != "none";
}

std::optional<Refusal>
RequestGuard::refusalOfEntry(const RequestHeader& request) const
{
  if (auto refusal = refusalOfSender(request))
    return refusal;
  const std::string_view token = view(request.target()).substr(entry_target.size());
  if (!areEqual(token, token_))
    return Refusal{http::status::unauthorized,
                   "This token is not the one of this run; open the address that "
                   "pcl_cid_studio has printed last."};
  return std::nullopt;
}

std::optional<Refusal>
RequestGuard::refusal(const RequestHeader& request) const
{
  if (auto refusal = refusalOfSender(request))
    return refusal;
  if (isLedByOthers(request))
    return Refusal{http::status::forbidden,
                   "Another site asks for this; only the page of this server may."};
  if (!hasCookie(request))
    return Refusal{http::status::unauthorized,
                   "This browser has not opened the address with the token that "
                   "pcl_cid_studio has printed; open that first."};
  return std::nullopt;
}

std::optional<Refusal>
RequestGuard::refusalOfSocket(const RequestHeader& request) const
{
  if (auto refused = refusal(request))
    return refused;
  if (!isOurOrigin(request))
    return Refusal{
        http::status::forbidden,
        "A socket is for the page of this server alone; Origin must say so."};
  return std::nullopt;
}

bool
RequestGuard::hasCookie(const RequestHeader& request) const
{
  const auto fields = request.equal_range(http::field::cookie);
  for (auto field = fields.first; field != fields.second; ++field)
    if (isAmong(view(field->value()), cookieName(port_), secret_))
      return true;
  return false;
}

/** What holds for everybody, token and cookie or not. */
std::optional<Refusal>
RequestGuard::refusalOfSender(const RequestHeader& request) const
{
  const auto host = only(request, "Host");
  const std::string port = ":" + std::to_string(port_);
  if (host != "127.0.0.1" + port && host != "localhost" + port)
    return Refusal{http::status::forbidden,
                   "This server is 127.0.0.1" + port + " and no other host."};
  if (has(request, "Origin") && !isOurOrigin(request))
    return Refusal{http::status::forbidden,
                   "A page from elsewhere may not ask this server for anything."};
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return Refusal{http::status::method_not_allowed, "Only GET and HEAD are answered."};
  return std::nullopt;
}

} // namespace pcl_cid::studio
