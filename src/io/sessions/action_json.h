/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Actions as JSON.
 */

#pragma once

#include <pcl_cid/core/label_action.h>
#include <pcl_cid/core/part_action.h>

#include <optional>

#include <nlohmann/json.hpp>

namespace pcl_cid {

/** \brief An action, as `{"do": ...}`. Sets of points are `"runs"`: how many points are
 *  left out, then how many are in, and so on. */
nlohmann::ordered_json
toJson(const LabelAction& action);

nlohmann::ordered_json
toJson(const PartAction& action);

/** \throws CIDException when it is not an action as toJson() writes them */
LabelAction
actionFrom(const nlohmann::json& json);

/** \brief An action on parts; nothing where what is to be done is something else.
 *  \throws CIDException when it is not as toJson() writes it */
std::optional<PartAction>
partActionFrom(const nlohmann::json& json);

} // namespace pcl_cid
