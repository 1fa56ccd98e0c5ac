/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The browser of whoever sits before the screen.
 */

#pragma once

#include <string>

namespace pcl_cid::studio {

/** \brief Open an address in the user's browser, and don't wait for it.
 *  \return whether one was asked to: not without a screen, nor without xdg-open */
bool
openBrowser(const std::string& url);

} // namespace pcl_cid::studio
