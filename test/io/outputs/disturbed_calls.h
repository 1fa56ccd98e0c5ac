/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Calls that change files, disturbed: this executable has its own rename(), link(),
 * unlink(), rmdir(), fsync() and flock(), which take the place of the system's.
 */

#pragma once

namespace pcl_cid::test {

/** \brief What befalls a call. */
enum class Disturbance { none, kill, stop, fail, fail_from_there };

/** \brief Disturb a call of this process.
 *  \param[in] call 0 for the next one, 1 for the one after it, ... */
void
disturb(Disturbance disturbance, int call);

/** \brief Whether the call has come. */
bool
wasDisturbed();

} // namespace pcl_cid::test
