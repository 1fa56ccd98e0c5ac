/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which kind of file a name says it is.
 */

#pragma once

#include <string>
#include <string_view>

namespace pcl_cid::studio {

/** \brief The content type of a file of the page, by its extension;
 *  `application/octet-stream` where nobody knows. */
std::string
contentType(std::string_view path);

} // namespace pcl_cid::studio
