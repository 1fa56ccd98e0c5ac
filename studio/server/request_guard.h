/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Who may ask the server for anything: the page that the user opened, and nobody else.
 */

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/status.hpp>

namespace pcl_cid::studio {

using RequestHeader = boost::beast::http::request_header<>;

/** \brief Why a request is not answered. */
struct Refusal {
  boost::beast::http::status status;
  std::string sentence;
};

/** \brief The rules that keep other pages of the browser, other users of the machine
 * and other machines out.
 *
 *  Whoever knows the token, which the URL has, gets a cookie; everything else needs the
 *  cookie. A page from elsewhere has no cookie of ours; what it makes the browser send
 * is told by `Origin` and `Sec-Fetch-Site`. A name of elsewhere that was made to mean
 *  127.0.0.1 (DNS rebinding) is told by `Host`. */
class RequestGuard {
public:
  explicit RequestGuard(std::uint16_t port);

  /** \brief What the user opens; it has the token. */
  std::string
  url() const;

  /** \brief What `Set-Cookie` says to who came with the token. */
  std::string
  cookie() const;

  /** \brief Whether a request comes with a token, right or wrong. */
  static bool
  isEntry(const RequestHeader& request);

  /** \brief Whether another site led to an entry. The browser then keeps our cookie
   * back even from where we redirect to. */
  static bool
  isLedByOthers(const RequestHeader& request);

  /** \brief Why an entry is refused; nothing where it is welcome. */
  std::optional<Refusal>
  refusalOfEntry(const RequestHeader& request) const;

  /** \brief Why any other request is refused. */
  std::optional<Refusal>
  refusal(const RequestHeader& request) const;

  /** \brief Why a request for a socket is refused. To those the browser lets every page
   *  connect, so `Origin` must be there. */
  std::optional<Refusal>
  refusalOfSocket(const RequestHeader& request) const;

private:
  bool
  hasCookie(const RequestHeader& request) const;

  std::optional<Refusal>
  refusalOfSender(const RequestHeader& request) const;

  std::uint16_t port_;
  std::string token_;
  std::string secret_; ///< the value of the cookie
};

} // namespace pcl_cid::studio
