/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page that a picture is put into, as a part of the program.
 */

#pragma once

#include <string>
#include <string_view>

namespace pcl_cid::tools {

/** \brief The page with a gap for what it shows; empty in a program that was built
 *  without it. */
std::string_view
pageTemplate();

/** \brief Make sure that there is a page.
 *  \param[in] page see pageTemplate()
 *  \throws CIDException that says what is missing, and what to install */
void
requirePageTemplate(std::string_view page);

/** \brief The page with this in its gap.
 *  \param[in] page not empty */
std::string
filledPage(std::string_view page, const std::string& content);

} // namespace pcl_cid::tools
