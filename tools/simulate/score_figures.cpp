/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The figures of scores, and what both reports say about a scan.
 */

#include "score_figures.h"

namespace pcl_cid::tools {

using Json = nlohmann::ordered_json;

std::vector<FigureName>
annotationFigureNames()
{
  return {{"mean_iou", "mIoU"},
          {"recall25", "R25"},
          {"recall50", "R50"},
          {"recall75", "R75"},
          {"ap50", "AP50"}};
}

std::vector<double>
figuresOf(const AnnotationScore& score)
{
  return {score.mean_iou, score.recall25, score.recall50, score.recall75, score.ap50};
}

Json
jsonOf(const ScoredScan& scan)
{
  return {{"name", scan.name},
          {"input", scan.input},
          {"remarks", scan.remarks},
          {"points", scan.points},
          {"points_finite", scan.finite}};
}

Json
parametersOf(const ScoredScan& scan)
{
  Report report;
  report.parameters = scan.parameters;
  return Json::parse(toJson(report)).at("parameters");
}

std::string
textOf(const Json& report)
{
  // Names of files may hold any bytes, JSON only UTF-8.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace pcl_cid::tools
