/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a restless annotator does.
 */

#pragma once

#include <pcl_cid/core/label_session.h>

#include <random>

namespace pcl_cid::test {

/** An action of any kind, mostly one that is possible; also undo and redo. */
LabelAction
randomAction(const LabelSession& session, std::mt19937_64& random);

/** Do so many actions; those that are not possible do not count.
 *  \return them */
std::vector<LabelAction>
doRandomActions(std::size_t count, std::uint64_t seed, LabelSession& session);

} // namespace pcl_cid::test
