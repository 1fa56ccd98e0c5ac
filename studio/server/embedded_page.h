/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page in the program itself.
 */

#pragma once

#include "resource.h"

#include <cstddef>

namespace pcl_cid::studio {

/** \brief A file in the program, between two addresses. */
struct EmbeddedFile {
  std::string_view path; ///< "/assets/index.js"
  bool is_gzip;
  const char* begin;
  const char* end;
};

/** \brief The files of a table that pcl_cid_embed_page() of CMake makes. `/` is
 *  index.html. */
class EmbeddedPage : public Resources {
public:
  /** \param[in] files must outlive the page and all that is found in it */
  template <std::size_t Count>
  explicit EmbeddedPage(const EmbeddedFile (&files)[Count])
  : begin_(files), end_(files + Count)
  {
  }

  std::optional<Resource>
  find(std::string_view path) const override;

private:
  const EmbeddedFile* begin_;
  const EmbeddedFile* end_;
};

/** \brief The page that this program was built with; programs without one do not link.
 */
const EmbeddedPage&
embeddedPage();

} // namespace pcl_cid::studio
