/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What clicks are worth, as a table for people, as JSON and as CSV.
 */

#include "simulation_report.h"

#include "run/csv_row.h"
#include "score_figures.h"

#include <pcl_cid/version.h>

#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <utility>

namespace pcl_cid::tools {
namespace {

using Json = nlohmann::ordered_json;

/** What AGILE3D gives an annotator. */
constexpr std::size_t clicks_per_instance =
    VoxelAnnotationOptions().clicks_per_instance;

std::vector<FigureName>
figureNames(AnnotationProtocol protocol)
{
  if (protocol == AnnotationProtocol::agile3d)
    return {{"iou5", "IoU@5"},
            {"iou10", "IoU@10"},
            {"iou15", "IoU@15"},
            {"noc80", "NoC@80"},
            {"noc85", "NoC@85"},
            {"noc90", "NoC@90"}};
  return annotationFigureNames();
}

/** A line of the table. */
struct ScoreRow {
  std::size_t instances = 0;
  std::size_t clicks = 0; ///< asked for in each scan, or the budget of all
  std::size_t used = 0;   ///< made in all
  std::vector<double> figures;
};

/** At the number of clicks with this index, pooled over scans. */
ScoreRow
pooledRow(const std::vector<const AnnotatedScan*>& scans,
          std::size_t index,
          std::size_t clicks)
{
  ScoreRow row;
  row.clicks = clicks;
  std::vector<InstanceOverlaps> overlaps;
  for (const AnnotatedScan* const scan : scans) {
    overlaps.push_back(scan->states[index].overlaps);
    row.used += scan->states[index].clicks;
  }
  const AnnotationScore score = scoreAnnotations(overlaps);
  row.instances = score.instances;
  row.figures = figuresOf(score);
  return row;
}

/** By the rules of AGILE3D: means over the scans. */
ScoreRow
meanRow(const std::vector<const AnnotatedScan*>& scans)
{
  constexpr auto budget = static_cast<double>(clicks_per_instance);
  ScoreRow row;
  row.figures.assign(6, 0.0);
  for (const AnnotatedScan* const scan : scans) {
    const std::vector<AnnotationState>& states = scan->states;
    row.instances += states.back().overlaps.truths.size();
    row.used += states.back().clicks;
    std::size_t k = 0;
    for (const double clicks : {5.0, 10.0, 15.0})
      row.figures[k++] += meanIouAt(states, clicks);
    for (const double iou : {0.80, 0.85, 0.90})
      row.figures[k++] += clicksToReach(states, iou, budget);
  }
  for (double& figure : row.figures)
    figure /= static_cast<double>(scans.size());
  row.clicks = row.instances * clicks_per_instance;
  return row;
}

std::vector<ScoreRow>
rowsOf(const std::vector<const AnnotatedScan*>& scans, const SimulateSettings& settings)
{
  if (settings.protocol == AnnotationProtocol::agile3d)
    return {meanRow(scans)};
  std::vector<ScoreRow> rows;
  for (std::size_t i = 0; i < settings.clicks.size(); ++i)
    rows.push_back(pooledRow(scans, i, settings.clicks[i]));
  return rows;
}

/** The rows of each scan, then those of all, which have no scan.
 *  \param[in] take called with a scan, or null, and its rows */
template <typename Take>
void
forEachScan(const SimulationReport& report, const Take& take)
{
  std::vector<const AnnotatedScan*> all;
  for (const AnnotatedScan& scan : report.scans) {
    all.push_back(&scan);
    take(&scan, rowsOf({&scan}, report.settings));
  }
  take(static_cast<const AnnotatedScan*>(nullptr), rowsOf(all, report.settings));
}

Json
jsonOf(const std::vector<ScoreRow>& rows, AnnotationProtocol protocol)
{
  Json json = Json::array();
  const std::vector<FigureName> names = figureNames(protocol);
  for (const ScoreRow& row : rows) {
    Json each = {
        {"instances", row.instances}, {"clicks", row.clicks}, {"used", row.used}};
    for (std::size_t k = 0; k < names.size(); ++k)
      each[names[k].name] = row.figures[k];
    json.push_back(std::move(each));
  }
  return json;
}

} // namespace

void
printTable(std::ostream& stream, const SimulationReport& report)
{
  stream << std::left << std::setw(24) << "scan" << std::right << std::setw(10)
         << "instances" << std::setw(8) << "clicks" << std::setw(8) << "used";
  for (const FigureName& figure : figureNames(report.settings.protocol))
    stream << std::setw(8) << figure.headline;
  stream << '\n';
  forEachScan(report,
              [&](const AnnotatedScan* scan, const std::vector<ScoreRow>& rows) {
                for (const ScoreRow& row : rows) {
                  stream << std::left << std::setw(24) << (scan ? scan->name : "all")
                         << std::right << std::setw(10) << row.instances << std::setw(8)
                         << row.clicks << std::setw(8) << row.used << std::fixed
                         << std::setprecision(3);
                  for (const double figure : row.figures)
                    stream << std::setw(8) << figure;
                  stream << '\n';
                }
              });
}

std::string
toJson(const SimulationReport& report)
{
  const SimulateSettings& settings = report.settings;
  Json json = Json::object();
  json["tool"] = simulate_tool;
  json["version"] = PCL_CID_VERSION;
  json["protocol"] = annotation_protocol_setting.wordOf(settings.protocol);
  json["truth_field"] = settings.truth_field;
  json["proposals"] = settings.proposals.value_or(0);
  json["parameters"] = parametersOf(report.scans.front());
  json["scans"] = Json::array();
  forEachScan(report,
              [&](const AnnotatedScan* scan, const std::vector<ScoreRow>& rows) {
                Json scores = jsonOf(rows, settings.protocol);
                if (!scan) {
                  json["all"] = std::move(scores);
                  return;
                }
                Json each = jsonOf(*scan);
                each["scores"] = std::move(scores);
                json["scans"].push_back(std::move(each));
              });
  return textOf(json);
}

std::string
toCsv(const SimulationReport& report)
{
  std::ostringstream stream;
  stream.exceptions(std::ios::badbit); // want of memory is not lost
  stream.precision(std::numeric_limits<double>::max_digits10);
  {
    CsvRow headline(stream);
    for (const char* const name : {"kind", "name", "instances", "clicks", "used"})
      headline << std::string(name);
    for (const FigureName& figure : figureNames(report.settings.protocol))
      headline << std::string(figure.name);
  }
  forEachScan(report,
              [&](const AnnotatedScan* scan, const std::vector<ScoreRow>& rows) {
                for (const ScoreRow& each : rows) {
                  CsvRow row(stream);
                  row << std::string(scan ? "scan" : "all")
                      << (scan ? scan->name : std::string()) << each.instances
                      << each.clicks << each.used;
                  for (const double figure : each.figures)
                    row << figure;
                }
              });
  return stream.str();
}

} // namespace pcl_cid::tools
