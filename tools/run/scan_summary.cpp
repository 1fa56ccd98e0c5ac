/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What became of each of several scans.
 */

#include "scan_summary.h"

#include "csv_row.h"

#include <pcl_cid/version.h>

#include <sstream>

#include <boost/algorithm/string/predicate.hpp>
#include <nlohmann/json.hpp>

namespace pcl_cid::tools {
namespace {

using Json = nlohmann::ordered_json;

/** Call `visit(name, count)` for each figure; a count that does not apply is empty. */
template <typename Visit>
void
forEachFigure(const std::optional<ScanFigures>& figures, const Visit& visit)
{
  using Count = std::optional<std::size_t>;
  const ScanFigures of = figures.value_or(ScanFigures());
  visit("points", figures ? Count(of.points) : Count());
  visit("finite_points", figures ? Count(of.finite) : Count());
  visit("seeds", of.seeds);
  visit("groups", of.groups);
  visit("parts", of.parts);
}

/** Of no list, none. */
template <typename List>
std::optional<std::size_t>
sizeOf(const List& list)
{
  return list.empty() ? std::nullopt : std::optional<std::size_t>(list.size());
}

std::string
toJson(const std::string& tool, const std::vector<ScanRow>& rows)
{
  Json scans = Json::array();
  for (const ScanRow& row : rows) {
    Json scan = {{"scan", row.scan}, {"name", row.name}, {"status", row.status()}};
    scan["error"] = row.error.empty() ? Json() : Json(row.error);
    forEachFigure(row.figures, [&](const char* name, const auto& count) {
      scan[name] = count ? Json(*count) : Json();
    });
    scan["seconds"] = row.figures ? Json(row.seconds) : Json();
    scans.push_back(std::move(scan));
  }
  const Json json = {{"tool", tool}, {"version", PCL_CID_VERSION}, {"scans", scans}};
  // Names of files may hold any bytes, JSON only UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string
toCsv(const std::vector<ScanRow>& rows)
{
  std::ostringstream stream;
  stream.exceptions(std::ios::badbit); // want of memory is not lost
  {
    CsvRow headline(stream);
    for (const char* const name : {"scan", "name", "status", "error"})
      headline << std::string(name);
    forEachFigure(
        {}, [&](const char* name, const auto&) { headline << std::string(name); });
    headline << std::string("seconds");
  }
  for (const ScanRow& row : rows) {
    CsvRow line(stream);
    line << row.scan << row.name << std::string(row.status()) << row.error;
    forEachFigure(row.figures, [&](const char*, const auto& count) {
      line << (count ? std::to_string(*count) : std::string());
    });
    line << (row.figures ? row.seconds : std::nan(""));
  }
  return stream.str();
}

} // namespace

ScanFigures
figuresOf(const Report& report)
{
  ScanFigures figures{report.points_in, report.points_finite, {}, {}, {}};
  figures.seeds = sizeOf(report.seeds);
  figures.groups = sizeOf(report.group_sizes);
  if (report.parts != nullptr)
    figures.parts = report.parts->size();
  return figures;
}

std::string
wordsOf(const ScanFigures& figures)
{
  std::string words = std::to_string(figures.points) + " points";
  if (figures.groups)
    words += ", " + std::to_string(*figures.groups) + " groups";
  if (figures.parts)
    words += ", " + std::to_string(*figures.parts) + " parts";
  return words;
}

const char*
ScanRow::status() const
{
  if (!error.empty())
    return "failed";
  return figures ? "done" : "not done";
}

std::string
summaryFor(const std::string& path,
           const std::string& tool,
           const std::vector<ScanRow>& rows)
{
  return boost::algorithm::iends_with(path, ".json") ? toJson(tool, rows) : toCsv(rows);
}

} // namespace pcl_cid::tools
