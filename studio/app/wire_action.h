/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a page wants done, as an action.
 */

#pragma once

#include "places.h"
#include "server/frame.h"

#include <pcl_cid/core/label_action.h>
#include <pcl_cid/core/part_action.h>

#include <optional>

namespace pcl_cid::studio {

/** \brief The action that a frame with `"do"` asks for.
 *  \throws CIDException when it is none, or names a place that is not there */
LabelAction
actionFrom(const Frame& frame, const Places& places);

/** \brief The action on parts; nothing where what is to be done is something else.
 *  \throws CIDException when it is not whole */
std::optional<PartAction>
partActionFrom(const nlohmann::json& header);

} // namespace pcl_cid::studio
