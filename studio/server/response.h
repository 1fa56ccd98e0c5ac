/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Answers to requests, and what all of them say.
 */

#pragma once

#include "request_guard.h"
#include "resource.h"

#include <string>

#include <boost/beast/core/span.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/span_body.hpp>

namespace pcl_cid::studio {

/** \brief An answer whose body lies elsewhere. */
using Response =
    boost::beast::http::response<boost::beast::http::span_body<const char>>;

/** \brief What keeps the page to itself: it gets nothing from elsewhere, nobody frames
 *  it, and nothing of it is stored. */
void
protect(boost::beast::http::fields& fields, const std::string& port);

/** \brief An answer with a resource. For HEAD, and where nothing changes on the way.
 *  \param[in] resource must live as long as the answer */
Response
responseWith(const Resource& resource,
             boost::beast::http::status status,
             const RequestHeader& request);

/** \brief Whether the client undoes compression. */
bool
takesGzip(const RequestHeader& request);

} // namespace pcl_cid::studio
