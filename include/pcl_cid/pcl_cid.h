/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The umbrella header: the classes, what they take and what they return.
 */

#pragma once

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/cid_sampler.h>
#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/version.h>

/** \brief Concavity-Induced Distance for point clouds.
 *
 *  CIDSampler, CIDLabelPropagation and CIDConvexAbstraction are the way in. They share
 *  a PreparedScan and a Grouping, so that nothing is computed twice; a MergeTree and
 *  ConvexPart objects come out. Files are in <pcl_cid/io/...>, a library of its own. */
namespace pcl_cid {
}
