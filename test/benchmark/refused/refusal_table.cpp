/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The figures of several sets of hulls as a table, for people and for programs.
 */

#include "refusal_table.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

namespace pcl_cid::benchmarks {
namespace {

using Cells = std::vector<std::string>;

/** \param[in] decimals negative for all digits that the number has */
std::string
numberText(double value, int decimals)
{
  std::ostringstream text;
  if (decimals < 0)
    text << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
  else
    text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

/** \param[in] is_exact with all digits */
Cells
cellsOf(const MeasuredHulls& row, bool is_exact)
{
  const RefusalFigures& figures = row.figures;
  const auto shown = [=](double value, int decimals) {
    return numberText(value, is_exact ? -1 : decimals);
  };
  Cells cells{row.file,
              std::to_string(figures.hulls),
              std::to_string(row.vertices),
              shown(100.0 * figures.refused, 2)};
  for (const std::size_t missed : figures.missed)
    cells.push_back(std::to_string(missed));
  for (const double volume :
       {figures.volume_sum, figures.union_volume, figures.free_volume})
    cells.push_back(shown(volume, 3));
  cells.push_back(shown(figures.deepest, 3));
  cells.push_back(shown(row.seconds, 1));
  return cells;
}

/** In quotes where a separator or a quote is in it. */
std::string
csvCell(const std::string& cell)
{
  if (cell.find_first_of(",\"\r\n") == std::string::npos)
    return cell;
  std::string quoted = "\"";
  for (const char letter : cell)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

void
appendCsvLine(const Cells& cells, std::string& text)
{
  for (std::size_t k = 0; k < cells.size(); ++k)
    text += (k == 0 ? "" : ",") + csvCell(cells[k]);
  text += '\n';
}

} // namespace

std::string
toText(const std::vector<MeasuredHulls>& rows)
{
  std::vector<Cells> lines{{"file",
                            "hulls",
                            "vertices",
                            "refused %",
                            "> 1 mm",
                            "> 1 cm",
                            "> 3 cm",
                            "sum m3",
                            "union m3",
                            "free m3",
                            "deepest m",
                            "s"}};
  for (const MeasuredHulls& row : rows)
    lines.push_back(cellsOf(row, false));
  std::vector<std::size_t> widths(lines.front().size());
  for (const Cells& cells : lines)
    for (std::size_t k = 0; k < cells.size(); ++k)
      widths[k] = std::max(widths[k], cells[k].size());
  std::string text;
  for (const Cells& cells : lines) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::string blanks(widths[k] - cells[k].size(), ' ');
      text += k == 0 ? cells[k] + blanks : "  " + blanks + cells[k];
    }
    text += '\n';
  }
  return text;
}

std::string
toCsv(const std::vector<MeasuredHulls>& rows)
{
  std::string text = "file,hulls,vertices,refused_percent,missed_1mm,missed_1cm,"
                     "missed_3cm,volume_sum,union_volume,free_volume,deepest,seconds\n";
  for (const MeasuredHulls& row : rows)
    appendCsvLine(cellsOf(row, true), text);
  return text;
}

} // namespace pcl_cid::benchmarks
