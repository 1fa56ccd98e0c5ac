/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scores as a table for people, as JSON and as CSV.
 */

#include "evaluation_report.h"

#include "run/csv_row.h"

#include <pcl_cid/version.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace pcl_cid::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string
nameOf(const ClassEvaluation& each, const EvaluationReport& report)
{
  return className(report.classes.scored, each.semantic).value();
}

std::size_t
pointsOf(const EvaluationReport& report)
{
  std::size_t points = 0;
  for (const ScoredScan& scan : report.scans)
    points += scan.points;
  return points;
}

/** The median over the scans that have one; NaN when none has. */
double
medianPurity(const EvaluationReport& report)
{
  std::vector<double> purities;
  for (const ScoredScan& scan : report.scans)
    if (!std::isnan(scan.evaluation.purity))
      purities.push_back(scan.evaluation.purity);
  if (purities.empty())
    return EvaluationFigures::none;
  std::sort(purities.begin(), purities.end());
  const std::size_t middle = purities.size() / 2;
  return purities.size() % 2 == 1 ? purities[middle]
                                  : 0.5 * (purities[middle - 1] + purities[middle]);
}

/** A figure that is NaN becomes null in the file. */
void
addFigures(const EvaluationFigures& figures, EvaluationProtocol protocol, Json& json)
{
  for (const NamedFigure& figure : figuresOf(protocol))
    json[figure.name] = figures.*figure.value;
}

Json
meanOf(const Evaluation& evaluation, EvaluationProtocol protocol)
{
  Json mean = {{"classes", evaluation.classes_in_mean}};
  addFigures(evaluation.mean, protocol, mean);
  return mean;
}

/** What a scan and all scans together have in common. */
void
addTotals(const Evaluation& evaluation, std::size_t points, Json& json)
{
  json["points"] = points;
  json["labelled_points"] = evaluation.truth_points;
  json["truth_instances"] = evaluation.truths;
  json["groups"] = evaluation.groups;
  json["purity"] = evaluation.purity;
  json["compactness"] = evaluation.compactness;
  json["mean_iou"] = evaluation.mean_iou;
}

Json
scansOf(const EvaluationReport& report)
{
  Json scans = Json::array();
  for (const ScoredScan& scan : report.scans) {
    Json json = {{"name", scan.pair.name},
                 {"prediction", scan.pair.prediction},
                 {"truth", scan.pair.truth},
                 {"class_rule", nameOf(scan.class_rule)},
                 {"remarks", scan.remarks}};
    addTotals(scan.evaluation, scan.points, json);
    json["mean"] = meanOf(scan.evaluation, report.protocol);
    scans.push_back(std::move(json));
  }
  return scans;
}

Json
classesOf(const EvaluationReport& report)
{
  Json classes = Json::array();
  for (const ClassEvaluation& each : report.pooled.classes) {
    Json json = {{"number", each.semantic},
                 {"name", nameOf(each, report)},
                 {"truth_instances", each.truths},
                 {"predictions", each.predictions}};
    addFigures(each.figures, report.protocol, json);
    classes.push_back(std::move(json));
  }
  return classes;
}

Json
failedOf(const EvaluationReport& report)
{
  Json failed = Json::array();
  for (const FailedScan& scan : report.failed)
    failed.push_back({{"name", scan.name}, {"error", scan.error}});
  return failed;
}

void
addFigures(const EvaluationFigures& figures, EvaluationProtocol protocol, CsvRow& row)
{
  for (const NamedFigure& figure : figuresOf(protocol))
    row << figures.*figure.value;
}

void
addRow(const std::string& kind,
       const std::string& name,
       std::size_t points,
       const Evaluation& evaluation,
       EvaluationProtocol protocol,
       std::ostream& stream)
{
  CsvRow row(stream);
  row << kind << name << points << evaluation.truth_points << evaluation.truths
      << evaluation.groups << evaluation.purity << evaluation.compactness
      << evaluation.mean_iou;
  addFigures(evaluation.mean, protocol, row);
}

/** A line of the table for people. */
void
printRow(const std::string& name,
         const std::string& truths,
         const std::string& predictions,
         const std::vector<std::string>& figures,
         std::ostream& stream)
{
  stream << std::left << std::setw(16) << name << std::right << std::setw(7) << truths
         << std::setw(7) << predictions;
  for (const std::string& figure : figures)
    stream << std::setw(7) << figure;
  stream << "\n";
}

std::vector<std::string>
texts(const EvaluationFigures& figures, EvaluationProtocol protocol)
{
  std::vector<std::string> list;
  for (const NamedFigure& figure : figuresOf(protocol)) {
    std::ostringstream text;
    text.exceptions(std::ios::badbit); // want of memory is not lost
    text << std::fixed << std::setprecision(3) << figures.*figure.value;
    list.push_back(std::isnan(figures.*figure.value) ? "-" : text.str());
  }
  return list;
}

} // namespace

void
printTable(std::ostream& stream, const EvaluationReport& report)
{
  std::vector<std::string> headlines;
  for (const NamedFigure& figure : figuresOf(report.protocol))
    headlines.emplace_back(figure.headline);
  printRow("class", "truth", "pred.", headlines, stream);
  std::size_t truths = 0;
  std::size_t predictions = 0;
  for (const ClassEvaluation& each : report.pooled.classes) {
    printRow(nameOf(each, report),
             std::to_string(each.truths),
             std::to_string(each.predictions),
             texts(each.figures, report.protocol),
             stream);
    truths += each.truths;
    predictions += each.predictions;
  }
  printRow("mean",
           std::to_string(truths),
           std::to_string(predictions),
           texts(report.pooled.mean, report.protocol),
           stream);
}

std::string
toJson(const EvaluationReport& report)
{
  Json json = Json::object();
  json["tool"] = "pcl_cid_evaluate";
  json["version"] = PCL_CID_VERSION;
  json["prediction"] = report.prediction;
  json["truth"] = report.truth;
  json["protocol"] = protocol_setting.wordOf(report.protocol);
  json["classes_from"] = report.classes.source;
  addTotals(report.pooled, pointsOf(report), json);
  json["median_purity"] = medianPurity(report);
  json["mean"] = meanOf(report.pooled, report.protocol);
  json["classes"] = classesOf(report);
  json["scans"] = scansOf(report);
  json["failed"] = failedOf(report);
  // Names of files may hold any bytes, JSON only UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string
toCsv(const EvaluationReport& report)
{
  std::ostringstream stream;
  stream.exceptions(std::ios::badbit); // want of memory is not lost
  stream.precision(std::numeric_limits<double>::max_digits10);
  {
    CsvRow headline(stream);
    for (const char* const name : {"kind",
                                   "name",
                                   "points",
                                   "labelled_points",
                                   "truth_instances",
                                   "groups",
                                   "purity",
                                   "compactness",
                                   "mean_iou"})
      headline << std::string(name);
    for (const NamedFigure& figure : figuresOf(report.protocol))
      headline << std::string(figure.name);
  }
  for (const ScoredScan& scan : report.scans)
    addRow(
        "scan", scan.pair.name, scan.points, scan.evaluation, report.protocol, stream);
  for (const ClassEvaluation& each : report.pooled.classes) {
    CsvRow row(stream);
    row << "class" << nameOf(each, report) << std::string() << std::string()
        << each.truths << each.predictions << std::string() << std::string()
        << std::string();
    addFigures(each.figures, report.protocol, row);
  }
  addRow("all", "", pointsOf(report), report.pooled, report.protocol, stream);
  return stream.str();
}

} // namespace pcl_cid::tools
