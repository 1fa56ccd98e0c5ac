/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the server gives to a GET.
 */

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace pcl_cid::studio {

/** \brief What a path names, in the words of HTTP. It is sent from where it lies. */
struct Resource {
  std::string content_type;
  bool is_gzip = false; ///< the body is compressed, which the browser undoes
  std::string_view body{};
  std::shared_ptr<const void> owner{}; ///< keeps the body; null where it stays anyway
};

/** \brief A resource with a text of its own. */
inline Resource
textResource(std::string text, std::string content_type = "text/plain; charset=utf-8")
{
  auto kept = std::make_shared<const std::string>(std::move(text));
  const std::string_view body = *kept;
  return {std::move(content_type), false, body, std::move(kept)};
}

/** \brief All that can be got. */
class Resources {
public:
  virtual ~Resources() = default;

  /** \brief What is at a path. Called on the thread of the server, which waits for it.
   *  \param[in] path begins with '/', has no '?' and what follows it, and is as the
   *  client wrote it: ".." and "%2e" may be in it
   *  \return nothing where there is none */
  virtual std::optional<Resource>
  find(std::string_view path) const = 0;
};

} // namespace pcl_cid::studio
