/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What runs that were killed have left in a folder.
 */

#pragma once

#include <string>

namespace pcl_cid {

/** \brief Bring all runs to an end that have begun in a folder and are dead: nothing of
 *  them stays hidden, and their outputs are all there or none. Those that are alive,
 *  and those of other users, are left alone.
 *  \throws CIDException when that is not possible */
void
endDeadRuns(const std::string& folder);

} // namespace pcl_cid
