/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels of a scan as SemanticKITTI has them.
 */

#pragma once

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/labelled_instances.h>
#include <pcl_cid/io/output_files.h>

#include <string>

namespace pcl_cid {

/** \brief The file beside a `.label` that says what its numbers mean:
 *  `<name>.classes.yaml`. */
PCL_CID_IO_EXPORT std::string
semanticKittiClassFile(const std::string& label_file);

/** \brief Write labels as a `.label` of SemanticKITTI: 32 bits, little-endian, for each
 *  point of the cloud, those that are not finite too. The lower 16 are the class, the
 *  upper 16 the instance: its place, from 1, among those that have points, by label.
 *
 *  A class that the table does not have gets the next number after the largest there:
 *  one class after the other, in the order of their names. The tools of SemanticKITTI
 *  take what lies less than 100 above their largest number, and count it as unlabeled.
 *  For the same numbers in several scans, give all of them a table with all classes. An
 *  instance with the class `unlabeled`, or none, has 0 as its class.
 *
 *  Beside it, semanticKittiClassFile() names the classes (`labels`, as in the
 *  semantic-kitti.yaml of those tools) and the instances.
 *  \param[in] classes numbers of classes, such as semanticKittiClasses()
 *  \param[in] path ends with `.label`
 *  \param[in,out] outputs announced and written; the caller commits them
 *  \throws CIDException when requireConsistent() or \a outputs refuses, the path has
 *  another extension, there are more than 65535 instances, or the number of a class is
 *  above 65535 */
PCL_CID_IO_EXPORT void
writeSemanticKitti(const LabelledInstances& scan,
                   const SemanticClasses& classes,
                   const std::string& path,
                   OutputFiles& outputs);

} // namespace pcl_cid
