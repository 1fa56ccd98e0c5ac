/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The first line of a session file.
 */

#pragma once

#include <pcl_cid/io/session_file.h>

#include <nlohmann/json.hpp>

namespace pcl_cid {

/** \brief Of which scan a session is, and with which settings. */
nlohmann::ordered_json
headerOf(const ScanIdentity& scan, const SessionSettings& settings);

/** \return with no actions
 *  \throws CIDException when it is not as headerOf() writes it, or of a later version
 */
SessionRecord
recordFrom(const nlohmann::json& header);

} // namespace pcl_cid
