/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels that were given elsewhere, as actions.
 */

#pragma once

#include "recorded_session.h"

#include <pcl_cid/io/seed_table.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl_cid::studio {

/** \brief The class of a label; empty for none. */
using ClassOf = std::function<std::string(std::uint32_t label)>;

/** \brief Give every point the label that it had: the questions of a session in which
 *  nothing was done are answered by it, and points that then have another one are
 *  painted. So corrections reach all that seeds can tell.
 *  \param[in] labels of the points of the cloud; 0 for none
 *  \param[in] seeds how many questions
 *  \throws CIDException, CIDCancelled */
void
importLabels(const std::vector<std::uint32_t>& labels,
             const ClassOf& class_of,
             std::size_t seeds,
             RecordedSession& session,
             const ExecutionOptions& execution);

/** \brief Click on the seeds of a table.
 *  \throws CIDException, CIDCancelled */
void
importSeeds(const SeedTable& table,
            RecordedSession& session,
            const ExecutionOptions& execution);

} // namespace pcl_cid::studio
