/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the numbers of a field `semantic` mean.
 */

#pragma once

#include <pcl_cid/pcl_cid_io_export.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief A class of things, as a number in a cloud and as a name; 0 is no class. */
struct SemanticClass {
  std::uint32_t number;
  std::string name;
};

/** \brief Classes in the order of their numbers. */
using SemanticClasses = std::vector<SemanticClass>;

/** \brief The 13 classes of S3DIS, 1 (ceiling) to 13 (clutter).
 *
 *  The names are those of its annotation files. Public code numbers them in more than
 *  one way, so the numbers are ours: those of data/room.pcd. */
PCL_CID_IO_EXPORT const SemanticClasses&
s3disClasses();

/** \brief The classes of NYUv2 that ScanNet maps its own to (`nyu40id`), 1 (wall) to 40
 *  (otherprop). Names are spelled as in ScanNet's benchmark. */
PCL_CID_IO_EXPORT const SemanticClasses&
nyu40Classes();

/** \brief The 18 of nyu40Classes() that ScanNet's instance benchmark counts: all of its
 *  20 but wall and floor. */
PCL_CID_IO_EXPORT const SemanticClasses&
scannetBenchmarkClasses();

/** \brief The classes of SemanticKITTI and their numbers, 1 (outlier) to 259
 *  (moving-other-vehicle); 0, its `unlabeled`, is no class. */
PCL_CID_IO_EXPORT const SemanticClasses&
semanticKittiClasses();

/** \brief The number of a class; none when there is no class of this name. */
PCL_CID_IO_EXPORT std::optional<std::uint32_t>
classNumber(const SemanticClasses& classes, const std::string& name);

/** \brief The name of a class; none when there is no class of this number. */
PCL_CID_IO_EXPORT std::optional<std::string>
className(const SemanticClasses& classes, std::uint32_t number);

} // namespace pcl_cid
