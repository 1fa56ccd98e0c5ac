/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the actions of a session brought, as a table for people, as JSON and as CSV.
 */

#include "session_report.h"

#include "run/csv_row.h"
#include "score_figures.h"

#include <pcl_cid/version.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <utility>
#include <vector>

namespace pcl_cid::tools {
namespace {

using Json = nlohmann::ordered_json;

/** A line of the table. */
struct ActionRow {
  const ReplayedAction& action;
  std::vector<double> figures; ///< afterwards
  std::vector<double> gains;   ///< afterwards less before
};

std::vector<ActionRow>
rowsOf(const ReplayedSession& session)
{
  std::vector<ActionRow> rows;
  std::vector<double> before = figuresOf(AnnotationScore()); // without labels all are 0
  for (const ReplayedAction& action : session.actions) {
    ActionRow row{action, figuresOf(action.score), {}};
    for (std::size_t k = 0; k < before.size(); ++k)
      row.gains.push_back(row.figures[k] - before[k]);
    before = row.figures;
    rows.push_back(std::move(row));
  }
  return rows;
}

/** All actions that are called the same. */
struct WordRow {
  std::string word;
  std::size_t actions = 0;
  double gain = 0.0; ///< of mean IoU, in all
};

/** In the order in which the words come first. */
std::vector<WordRow>
rowsByWord(const std::vector<ActionRow>& rows)
{
  std::vector<WordRow> words;
  for (const ActionRow& row : rows) {
    auto word = std::find_if(words.begin(), words.end(), [&](const WordRow& each) {
      return each.word == row.action.word;
    });
    if (word == words.end())
      word = words.insert(words.end(), {row.action.word});
    ++word->actions;
    word->gain += row.gains.front();
  }
  return words;
}

/** A class is any text; a table has one line for each row. */
std::string
oneLine(std::string text)
{
  std::replace_if(
      text.begin(),
      text.end(),
      [](char letter) { return static_cast<unsigned char>(letter) < ' '; },
      ' ');
  return text;
}

template <typename Number>
std::string
cellOf(const std::optional<Number>& number)
{
  return number ? std::to_string(*number) : std::string();
}

void
printActions(std::ostream& stream, const std::vector<ActionRow>& rows)
{
  stream << std::right << std::setw(6) << "line"
         << "  " << std::left << std::setw(8) << "do" << std::right << std::setw(10)
         << "point" << std::setw(8) << "points" << std::setw(7) << "label"
         << std::setw(7) << "used";
  for (const FigureName& figure : annotationFigureNames())
    stream << std::setw(8) << figure.headline;
  stream << std::setw(9) << "gain"
         << "  class\n";
  for (const auto& [action, figures, gains] : rows) {
    stream << std::setw(6) << action.line << "  " << std::left << std::setw(8)
           << action.word << std::right << std::setw(10) << cellOf(action.point)
           << std::setw(8) << action.points << std::setw(7) << cellOf(action.label)
           << std::setw(7) << action.effort.total() << std::fixed
           << std::setprecision(3);
    for (const double figure : figures)
      stream << std::setw(8) << figure;
    stream << std::setw(9) << std::showpos << gains.front() << std::noshowpos
           << (action.class_name.empty() ? "" : "  ") << oneLine(action.class_name)
           << '\n';
  }
}

void
printWords(std::ostream& stream, const std::vector<ActionRow>& rows)
{
  stream << std::left << std::setw(8) << "do" << std::right << std::setw(10)
         << "actions" << std::setw(9) << "gain" << std::setw(9) << "of each"
         << "\n";
  for (const WordRow& row : rowsByWord(rows))
    stream << std::left << std::setw(8) << row.word << std::right << std::setw(10)
           << row.actions << std::showpos << std::fixed << std::setprecision(3)
           << std::setw(9) << row.gain << std::setw(9)
           << row.gain / static_cast<double>(row.actions) << std::noshowpos << '\n';
}

template <typename Number>
Json
jsonOf(const std::optional<Number>& number)
{
  return number ? Json(*number) : Json();
}

Json
jsonOf(const ActionRow& row)
{
  const std::vector<FigureName> names = annotationFigureNames();
  const auto& [action, figures, gains] = row;
  Json json = {{"instances", action.score.instances},
               {"clicks", action.effort.total()},
               {"used", action.effort.total()}};
  for (std::size_t k = 0; k < names.size(); ++k)
    json[names[k].name] = figures[k];
  json["line"] = action.line;
  json["do"] = action.word;
  json["point"] = jsonOf(action.point);
  json["points"] = action.points;
  json["label"] = jsonOf(action.label);
  json["class"] = action.class_name;
  json["answers"] = action.effort.answers;
  json["corrections"] = action.effort.corrections;
  json["strokes"] = action.effort.strokes;
  for (std::size_t k = 0; k < names.size(); ++k)
    json[std::string("gain_") + names[k].name] = gains[k];
  return json;
}

Json
jsonOf(const WordRow& row)
{
  return {{"do", row.word}, {"actions", row.actions}, {"gain_mean_iou", row.gain}};
}

template <typename Row>
Json
jsonOf(const std::vector<Row>& rows)
{
  Json json = Json::array();
  for (const Row& row : rows)
    json.push_back(jsonOf(row));
  return json;
}

void
writeHeadline(std::ostream& stream)
{
  CsvRow headline(stream);
  for (const char* const name : {"kind", "name", "instances", "clicks", "used"})
    headline << std::string(name);
  for (const FigureName& figure : annotationFigureNames())
    headline << std::string(figure.name);
  for (const char* const name : {"line",
                                 "do",
                                 "point",
                                 "points",
                                 "label",
                                 "class",
                                 "answers",
                                 "corrections",
                                 "strokes"})
    headline << std::string(name);
  for (const FigureName& figure : annotationFigureNames())
    headline << std::string("gain_") + figure.name;
}

void
writeRow(std::ostream& stream, const std::string& scan, const ActionRow& each)
{
  const auto& [action, figures, gains] = each;
  CsvRow row(stream);
  row << std::string("scan") << scan << action.score.instances << action.effort.total()
      << action.effort.total();
  for (const double figure : figures)
    row << figure;
  row << action.line << action.word << cellOf(action.point) << action.points
      << cellOf(action.label) << action.class_name << action.effort.answers
      << action.effort.corrections << action.effort.strokes;
  for (const double gain : gains)
    row << gain;
}

} // namespace

void
printTable(std::ostream& stream, const SessionReport& report)
{
  const std::vector<ActionRow> rows = rowsOf(report.session);
  printActions(stream, rows);
  printWords(stream, rows);
}

std::string
toJson(const SessionReport& report)
{
  const SimulateSettings& settings = report.settings;
  const std::vector<ActionRow> rows = rowsOf(report.session);
  Json scan = jsonOf(report.session);
  scan["scores"] = jsonOf(rows);
  scan["by_action"] = jsonOf(rowsByWord(rows));
  Json json = Json::object();
  json["tool"] = simulate_tool;
  json["version"] = PCL_CID_VERSION;
  json["protocol"] = "session";
  json["truth_field"] = settings.truth_field;
  json["parameters"] = parametersOf(report.session);
  json["scans"] = Json::array({std::move(scan)});
  return textOf(json);
}

std::string
toCsv(const SessionReport& report)
{
  std::ostringstream stream;
  stream.exceptions(std::ios::badbit); // want of memory is not lost
  stream.precision(std::numeric_limits<double>::max_digits10);
  writeHeadline(stream);
  for (const ActionRow& row : rowsOf(report.session))
    writeRow(stream, report.session.name, row);
  return stream.str();
}

} // namespace pcl_cid::tools
