/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Two clouds of the same scan, reduced to what the scores need.
 */

#pragma once

#include "scan_pairs.h"

#include <pcl_cid/core/evaluation.h>
#include <pcl_cid/core/instance_overlaps.h>
#include <pcl_cid/io/class_names.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief Where the class of a predicted instance comes from. */
enum class ClassRule {
  same_label, ///< the truth instance whose label it carries
  prediction, ///< most of its points, in the prediction's own field
  truth       ///< most of its points, in the truth
};

/** \brief Its name in reports. */
const char*
nameOf(ClassRule rule);

/** \brief Names of the fields that are read. */
struct FieldNames {
  std::string prediction = "label";
  std::string truth = "label";
  std::string semantic = "semantic";
};

/** \brief A pair of clouds as the scores need it. */
struct ComparedScan {
  InstanceOverlaps overlaps;
  /** Finite points. */
  std::size_t points = 0;
  /** Whether the truth has the field of the classes; else all points are of class 1. */
  bool has_classes = false;
  ClassRule class_rule = ClassRule::same_label;
  /** What was repaired, left out or assumed while reading. */
  std::vector<std::string> remarks;
};

/** \brief Read both clouds of a pair and compare them, point by point.
 *  \param[in] class_table of ScanNet, for both clouds; empty: looked for
 *  \param[in] known the classes that may occur
 *  \throws CIDException when the clouds are not of the same points in the same order,
 *  or have a class that is not known */
ComparedScan
compareScans(const ScanPair& pair,
             const std::string& class_table,
             const FieldNames& fields,
             const SemanticClasses& known,
             EvaluationProtocol protocol);

} // namespace pcl_cid::tools
