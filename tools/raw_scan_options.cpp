/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The options for raw scans: density, isolated points, seeding, colour.
 */

#include "raw_scan_options.h"

#include "tool_run.h"


#include <cfloat>
#include <memory>

namespace pcl_cid::tools {
namespace {

/** In the order of DensityWeight. */
const std::vector<std::string> density_words{"auto", "off", "on"};

const std::vector<std::string> blind_spot_words{"auto", "off"};

/** In the order of SeedingRule. */
const std::vector<std::string> seeding_words{"farthest", "soft"};

} // namespace

void
declareRawScanOptions(RawScanOptions& options, CommandLine& command_line)
{
  constexpr int most = setting::isolated_neighbors.most;
  command_line.group("Raw scans");
  command_line.choice(
      "density",
      "WHEN",
      density_words,
      options.density,
      "divide CIDs by the local spacing of the points: auto (where it is "
      "uneven), off (the paper) or on");
  command_line.number("density-power",
                      "P",
                      {0.0f, 4.0f, "a number from 0 to 4"},
                      options.density_power,
                      "power of the spacing that CIDs are divided by");
  command_line.number("isolated-neighbors",
                      "N",
                      {0, most, "a whole number, 0 to " + std::to_string(most)},
                      options.isolated_neighbors,
                      "points with fewer others near them become no seeds; 0 lets all "
                      "points be seeds");
  command_line.choice(
      "seeding",
      "RULE",
      seeding_words,
      options.seeding,
      "the next seed: farthest (the paper), or soft: drawn, the farther "
      "the likelier");
  command_line.number("color",
                      "LAMBDA",
                      {0.0f, FLT_MAX, "a number of metres, 0 or more"},
                      options.color,
                      "metres that a unit of difference in CIE L*a*b* adds to a CID; "
                      "INPUT needs the field rgb or rgba");
  command_line.choice("blind-spot",
                      "WHEN",
                      blind_spot_words,
                      options.blind_spot,
                      "the floor that a scanner hides from itself is a part of the "
                      "surface: auto (where INPUT has a hole under its viewpoint) or "
                      "off");
}

std::vector<std::string>
rawScanOptionNames()
{
  return {"density",
          "density-power",
          "isolated-neighbors",
          "seeding",
          "color",
          "blind-spot"};
}

void
configureForRawScan(const RawScanOptions& options,
                    const LabelledCloud& cloud,
                    CIDParameters& parameters)
{
  parameters.setDensityWeight(static_cast<DensityWeight>(options.density));
  parameters.setDensityPower(options.density_power);
  parameters.setIsolatedNeighbors(options.isolated_neighbors);
  parameters.setSeedingRule(static_cast<SeedingRule>(options.seeding));
  parameters.setColorWeight(options.color);
  parameters.setFillBlindSpot(options.blind_spot == 0);
  if (options.color > 0.0f)
    parameters.setColors(
        std::make_shared<const std::vector<ColorRGB>>(colorsOf(cloud)));
}

std::vector<Report::Parameter>
parametersOf(const RawScanOptions& options)
{
  return {{"density", density_words[options.density]},
          {"density_power", double{options.density_power}},
          {"isolated_neighbors", std::int64_t{options.isolated_neighbors}},
          {"seeding", seeding_words[options.seeding]},
          {"color", double{options.color}},
          {"blind_spot", blind_spot_words[options.blind_spot]}};
}

void
describeDensity(const DensityDecision& decision, const Console& console, Report& report)
{
  report.density = decision;
  std::string text = decision.weighted ? "on" : "off";
  if (decision.spread > 0.0f)
    text += ", the spread of the spacing is " + shortNumber(decision.spread);
  console.value("Density weight", text);
  if (decision.isolated_points > 0)
    console.value("Isolated points", std::to_string(decision.isolated_points));
}

void
describeBlindSpot(const std::optional<FilledBlindSpot>& spot,
                  const Eigen::Vector3d& offset,
                  const Console& console,
                  Report& report)
{
  report.blind_spot = spot;
  if (!spot)
    return;
  report.blind_spot->centre += offset;
  console.value("Blind spot",
                "floor within " + shortNumber(spot->radius) +
                    " metres under the sensor, filled with " +
                    std::to_string(spot->points) + " points of the surface");
}

} // namespace pcl_cid::tools
