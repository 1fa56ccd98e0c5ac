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

namespace pcl_cid::studio {

/** \brief The action that a frame with `"do"` asks for.
 *  \throws CIDException when it is none, or names a place that is not there */
LabelAction
actionFrom(const Frame& frame, const Places& places);

} // namespace pcl_cid::studio
