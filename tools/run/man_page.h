/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The manual page of a tool.
 */

#pragma once

#include "tool_description.h"

#include <iosfwd>

namespace pcl_cid::tools {

/** \brief Write the manual page of a tool, for man: sections of man(7). */
void
writeManPage(std::ostream& stream, const ToolDescription& tool);

} // namespace pcl_cid::tools
