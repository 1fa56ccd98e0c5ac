/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points as a prepared scan.
 */

#pragma once

#include <pcl_cid/core/prepared_scan.h>

namespace pcl_cid::test {

/** All finite points, in the order of a cloud that holds nothing else. */
RawScan
rawScan(const Points& points);

/** Settings that take points as they are: no weights, none is isolated, the first one
 *  is the start. */
PreparationSettings
plainSettings();

PreparedScan::ConstPtr
prepared(const Points& points, const PreparationSettings& settings = plainSettings());

ExecutionOptions
onThreads(unsigned int threads);

} // namespace pcl_cid::test
