/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Completion of a tool's command line in bash.
 */

#pragma once

#include "tool_description.h"

#include <iosfwd>

namespace pcl_cid::tools {

/** \brief Write a script for bash that completes options, their words, and files by
 *  their extensions. It needs nothing but bash. */
void
writeCompletion(std::ostream& stream, const ToolDescription& tool);

} // namespace pcl_cid::tools
