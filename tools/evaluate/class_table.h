/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the class numbers of scans mean, and which classes are scored.
 */

#pragma once

#include <pcl_cid/io/class_names.h>

#include <string>

namespace pcl_cid::tools {

/** \brief What the class numbers of scans mean. */
struct ClassTable {
  /** Where it is from: `s3dis`, `scannet`, the name of a file, or `none`. */
  std::string source;
  /** Numbers that may occur, and those of them that are scored. */
  SemanticClasses known;
  SemanticClasses scored;
};

/** \brief Look up a table.
 *  \param[in] source `s3dis`, `scannet`, or a text file with a line for each class:
 *  number and name; empty lines and what follows a `#` are passed over
 *  \throws CIDException when the file cannot be read or has anything else in it */
ClassTable
classTable(const std::string& source);

/** \brief The table for scans without classes: all instances are of one. */
ClassTable
oneClass();

} // namespace pcl_cid::tools
