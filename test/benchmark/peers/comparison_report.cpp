/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A comparison as JSON and as a table.
 */

#include "comparison.h"

#include <pcl_cid/version.h>

#include <iomanip>
#include <sstream>
#include <type_traits>
#include <variant>

#include <nlohmann/json.hpp>

namespace pcl_cid::benchmarks {
namespace {

using Json = nlohmann::ordered_json;

Json
valueOf(const Report::Parameter& parameter)
{
  return std::visit(
      [](const auto& value) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
          return nullptr;
        else
          return value;
      },
      parameter.value);
}

Json
rowAsJson(const PeerRow& row)
{
  Json json = {{"method", row.run.method}, {"settings", Json::object()}};
  for (const Report::Parameter& setting : row.run.settings)
    json["settings"][setting.name] = valueOf(setting);
  if (!row.failure.empty()) {
    json["failure"] = row.failure;
    return json;
  }
  json["cpu_seconds"] = row.measured.seconds;
  json["peak_bytes"] = row.measured.peak_bytes;
  json["parts"] = row.parts;
  json["labelled"] = row.labelled;
  json["own_purity"] = row.own_purity;
  json["purity"] = row.purity;
  json["cid_purity"] = row.cid_purity ? Json(*row.cid_purity) : Json();
  if (row.scores) {
    json["ap25"] = row.scores->mean.ap25;
    json["ap50"] = row.scores->mean.ap50;
    json["ap75"] = row.scores->mean.ap75;
    json["mean_iou"] = row.scores->mean_iou;
  }
  else {
    json["best"] = row.is_best;
  }
  return json;
}

void
addCell(double value, std::ostream& line)
{
  line << " | " << std::fixed << std::setprecision(3) << value;
}

} // namespace

std::string
settingsAsText(const PeerRun& run)
{
  std::ostringstream text;
  for (const Report::Parameter& setting : run.settings)
    text << (text.tellp() == 0 ? "" : " ") << setting.name << '='
         << valueOf(setting).dump();
  return text.str();
}

std::string
toJson(const PeerScan& scan,
       const SeedSettings& settings,
       const std::vector<PeerRow>& rows,
       const std::map<std::size_t, double>& curve)
{
  const ComparableParts comparable = comparableParts(scan);
  Json json = {{"version", PCL_CID_VERSION},
               {"input", scan.file.name},
               {"points", scan.cloud->size()},
               {"instances", countLabels(scan.truth.label)},
               {"seeds", settings.seeds},
               {"tree_seeds", settings.treeSeeds()},
               {"random_seeds", settings.random_seeds},
               {"comparable_parts", {comparable.least, comparable.most}},
               {"cid_curve", Json::array()},
               {"runs", Json::array()}};
  for (const auto& [parts, purity] : curve)
    json["cid_curve"].push_back({{"parts", parts}, {"purity", purity}});
  for (const PeerRow& row : rows)
    json["runs"].push_back(rowAsJson(row));
  return json.dump(2) + "\n";
}

std::string
toTable(const std::vector<PeerRow>& rows)
{
  std::ostringstream table;
  table << "| method | parts | labelled | own purity | purity | CID's purity at as "
           "many | AP25 | "
           "AP50 | AP75 | "
           "mean IoU | CPU s | peak MB | settings |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const PeerRow& row : rows) {
    if (!row.hasSeeds() && !row.is_best)
      continue;
    table << "| " << row.run.method << " | " << row.parts;
    addCell(row.labelled, table);
    addCell(row.own_purity, table);
    addCell(row.purity, table);
    addCell(row.cid_purity.value_or(0.0), table);
    if (row.scores)
      for (const double value : {row.scores->mean.ap25,
                                 row.scores->mean.ap50,
                                 row.scores->mean.ap75,
                                 row.scores->mean_iou})
        addCell(value, table);
    else
      table << " | | | |";
    table << " | " << std::setprecision(2) << row.measured.seconds << " | "
          << std::setprecision(0) << static_cast<double>(row.measured.peak_bytes) / 1e6
          << " | " << settingsAsText(row.run) << " |\n";
  }
  return table.str();
}

} // namespace pcl_cid::benchmarks
