/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Answers to requests, and what all of them say.
 */

#include "response.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <boost/beast/http/field.hpp>
#include <boost/beast/http/verb.hpp>

namespace pcl_cid::studio {
namespace {

namespace http = boost::beast::http;

std::string
policy(const std::string& port)
{
  return "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; "
         "img-src 'self' data: blob:; worker-src 'self' blob:; "
         "connect-src 'self' ws://127.0.0.1:" +
         port + " ws://localhost:" + port +
         "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

/** Small letters without spaces. */
std::string
plain(std::string_view text)
{
  std::string result;
  for (const char c : text)
    if (c != ' ' && c != '\t')
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/** Whether a weight, as in "gzip;q=0.5", is 0. */
bool
isNever(std::string_view weight)
{
  return weight.substr(0, 3) == ";q=" &&
         weight.find_first_not_of("0.", 3) == std::string_view::npos;
}

} // namespace

void
protect(http::fields& fields, const std::string& port)
{
  fields.set("Content-Security-Policy", policy(port));
  fields.set("X-Content-Type-Options", "nosniff");
  fields.set("Referrer-Policy", "no-referrer");
  fields.set("Cross-Origin-Opener-Policy", "same-origin");
  fields.set("Cross-Origin-Resource-Policy", "same-origin");
  fields.set(http::field::cache_control, "no-store");
}

Response
responseWith(const Resource& resource,
             http::status status,
             const RequestHeader& request)
{
  Response response(status, 11);
  response.set(http::field::content_type, resource.content_type);
  if (resource.is_gzip)
    response.set(http::field::content_encoding, "gzip");
  response.content_length(resource.body.size());
  if (request.method() != http::verb::head)
    response.body() = {resource.body.data(), resource.body.size()};
  return response;
}

bool
takesGzip(const RequestHeader& request)
{
  const auto field = request.find(http::field::accept_encoding);
  if (field == request.end())
    return false;
  const std::string list =
      "," + plain({field->value().data(), field->value().size()}) + ",";
  for (const std::string_view coding : {",gzip", ",x-gzip", ",*"})
    if (const auto at = list.find(coding); at != std::string::npos) {
      const auto begin = at + coding.size();
      const std::string weight = list.substr(begin, list.find(',', begin) - begin);
      if (weight.empty() || (weight[0] == ';' && !isNever(weight)))
        return true;
    }
  return false;
}

} // namespace pcl_cid::studio
