/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The figures of scores, and what both reports say about a scan.
 */

#pragma once

#include "scored_scan.h"

#include <pcl_cid/core/annotation.h>

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::tools {

/** \brief The name of a figure in files, and its headline in a table for people. */
struct FigureName {
  const char* name;
  const char* headline;
};

/** \brief The figures of an AnnotationScore, in the order of figuresOf(). */
std::vector<FigureName>
annotationFigureNames();

std::vector<double>
figuresOf(const AnnotationScore& score);

/** \brief A scan as reports have it, still without its scores. */
nlohmann::ordered_json
jsonOf(const ScoredScan& scan);

/** \brief The settings that a scan was worked on with, as other reports have them. */
nlohmann::ordered_json
parametersOf(const ScoredScan& scan);

/** \brief A report as the text of its file. */
std::string
textOf(const nlohmann::ordered_json& report);

} // namespace pcl_cid::tools
