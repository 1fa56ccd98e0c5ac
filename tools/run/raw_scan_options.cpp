/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The options for raw scans: density, isolated points, seeding, cues, connected
 * groups, blind spot.
 */

#include "raw_scan_options.h"

#include "parameter.h"
#include "run.h"
#include "words.h"

#include <memory>

namespace pcl_cid::tools {

void
declareRawScanOptions(RawScanOptions& options, CommandLine& line)
{
  line.group(setting::density.group);
  line.paperOption();
  line.choice(setting::density, options.density);
  line.setting(setting::density_power, options.density_power);
  line.setting(setting::isolated_neighbors, options.isolated_neighbors);
  line.choice(setting::seeding, options.seeding);
  line.setting(setting::color, options.color, "INPUT needs the field rgb or rgba");
  line.setting(setting::normals, options.normals);
  line.choice(setting::connected, options.connected);
  line.choice(setting::blind_spot, options.blind_spot);
}

std::vector<std::string>
rawScanOptionNames()
{
  std::vector<std::string> names = optionsOf(setting::density.group);
  names.emplace_back("paper");
  return names;
}

void
configureForRawScan(const RawScanOptions& options,
                    const LabelledCloud& cloud,
                    CIDParameters& parameters)
{
  parameters.setDensityWeight(options.density);
  parameters.setDensityPower(options.density_power);
  parameters.setIsolatedNeighbors(options.isolated_neighbors);
  parameters.setSeedingRule(options.seeding);
  parameters.setColorWeight(options.color);
  parameters.setNormalWeight(options.normals);
  parameters.setConnectedGroups(options.connected);
  parameters.setFillBlindSpot(options.blind_spot);
  if (options.color > 0.0f)
    parameters.setColors(
        std::make_shared<const std::vector<ColorRGB>>(colorsOf(cloud)));
}

std::vector<Report::Parameter>
parametersOf(const RawScanOptions& options)
{
  return {parameter(setting::density, options.density),
          parameter(setting::density_power, options.density_power),
          parameter(setting::isolated_neighbors, options.isolated_neighbors),
          parameter(setting::seeding, options.seeding),
          parameter(setting::color, options.color),
          parameter(setting::normals, options.normals),
          parameter(setting::connected, options.connected),
          parameter(setting::blind_spot, options.blind_spot)};
}

void
describeDensity(const DensityDecision& decision, Run& run)
{
  run.report.density = decision;
  std::string text = decision.weighted ? "on" : "off";
  if (decision.spread > 0.0f)
    text += ", the spread of the spacing is " + shortNumber(decision.spread);
  run.console.value("Density weight", text);
  if (decision.isolated_points > 0)
    run.console.value("Isolated points", std::to_string(decision.isolated_points));
}

void
describeBlindSpot(const std::optional<FilledBlindSpot>& spot,
                  const Frame& frame,
                  Run& run)
{
  run.report.blind_spot = spot;
  if (!spot)
    return;
  run.report.blind_spot->center = frame.toFile(spot->center);
  run.console.value("Blind spot",
                    "floor within " + shortNumber(spot->radius) +
                        " metres under the sensor, filled with " +
                        std::to_string(spot->points) + " points of the surface");
}

} // namespace pcl_cid::tools
