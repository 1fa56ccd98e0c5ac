/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_simulate is told: its settings and its command line.
 */

#include "simulate_settings.h"

#include "run/loaded_scan.h"
#include "run/session_settings.h"

#include <charconv>
#include <sstream>

namespace pcl_cid::tools {
namespace {

constexpr const char* about =
    "Simulate an annotator who clicks on points of a scan and says their true labels,\n"
    "and score what pcl_cid_segment would make of these clicks. SCAN is a PCD or PLY\n"
    "file with the true instance of each point in the field `label` (0 for none), a\n"
    "room folder of S3DIS or a scan folder of ScanNet. Each scan gets a row for each\n"
    "number of clicks; the rows `all` are of all instances of all scans (with\n"
    "--protocol agile3d: means over the scans).\n\n"
    "  pcl_cid_simulate room.pcd --protocol corrective --clicks 10,50,100\n\n"
    "Only clicks count, not what is proposed and not labelled.\n\n"
    "  pcl_cid_simulate room.pcd --session room.session\n\n"
    "does again what a person did in pcl_cid_studio and scores the labels after each\n"
    "action.";

constexpr const char* clicks_rule =
    "whole numbers above 0 that ascend, with commas between them";

[[noreturn]] void
refuseClicks(const std::string& text)
{
  throw UsageError("--clicks is '" + text + "'; it must be " + clicks_rule);
}

std::vector<std::size_t>
parseClicks(const std::string& text)
{
  std::vector<std::size_t> clicks;
  std::size_t least = 1;
  const char* begin = text.data();
  const char* const end = begin + text.size();
  while (true) {
    int number = 0;
    const auto [rest, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || number < 0 ||
        static_cast<std::size_t>(number) < least || (rest != end && *rest != ','))
      refuseClicks(text);
    clicks.push_back(static_cast<std::size_t>(number));
    least = clicks.back() + 1;
    if (rest == end)
      return clicks;
    begin = rest + 1;
  }
}

/** "10,20,30". */
std::string
textOf(const std::vector<std::size_t>& clicks)
{
  std::ostringstream text;
  for (std::size_t i = 0; i < clicks.size(); ++i)
    text << (i == 0 ? "" : ",") << clicks[i];
  return text.str();
}

void
declareClickOptions(SimulateSettings& settings, std::string& clicks, CommandLine& line)
{
  line.group(annotation_protocol_setting.group);
  line.choice(annotation_protocol_setting, settings.protocol);
  line.text("clicks",
            "N,...",
            clicks,
            std::string("numbers of clicks to score, ") + clicks_rule + "; default " +
                textOf(settings.clicks));
  line.optional(proposals_setting, settings.proposals, "default 0");
  declareSessionOption(settings.session,
                       "what each action of a session of pcl_cid_studio on SCAN "
                       "brought",
                       line);
  line.exclude("session",
               {optionName(annotation_protocol_setting),
                "clicks",
                optionName(proposals_setting)});
  line.text("truth-field",
            "FIELD",
            settings.truth_field,
            "true instances; default " + settings.truth_field);
  line.choice(setting::clean_up, settings.clean_up);
}

void
requireEffect(const SimulateSettings& settings, const std::string& clicks)
{
  if (!settings.session.empty() && settings.scans.size() > 1)
    throw UsageError("--session is of one scan; " +
                     std::to_string(settings.scans.size()) + " are given");
  const AnnotationProtocol protocol = settings.protocol;
  if (settings.proposals && protocol != AnnotationProtocol::corrective &&
      protocol != AnnotationProtocol::doubt)
    throw UsageError(
        "--proposals has no effect without --protocol corrective or doubt");
  if (!clicks.empty() && protocol == AnnotationProtocol::agile3d)
    throw UsageError(
        "--clicks has no effect with --protocol agile3d, which has a budget "
        "of its own");
}

} // namespace

SimulateSettings
SimulateSettings::withInput(const std::string& scan) const
{
  SimulateSettings settings = *this;
  settings.input = scan;
  return settings;
}

bool
readCommandLine(int argc, const char* const* argv, SimulateSettings& settings)
{
  CommandLine line(simulate_tool, "pcl_cid_simulate SCAN... [options]", about);
  std::string clicks;
  declareClickOptions(settings, clicks, line);
  line.group(setting::samples.group);
  declareGroupingOptions(settings, line);
  declareReadingOptions(settings, line);
  line.text("csv", "FILE.csv", settings.csv, "write all scores as a table");
  declareLastOptions(settings, line);
  if (!line.parseList(argc, argv, scanArgument("SCAN"), settings.scans))
    return false;
  requireEffect(settings, clicks);
  if (!clicks.empty())
    settings.clicks = parseClicks(clicks);
  return true;
}

std::vector<std::string>
inputsOf(const SimulateSettings& settings)
{
  std::vector<std::string> inputs;
  for (const std::string& scan : settings.scans)
    for (const std::string& path : inputFiles(settings.withInput(scan)))
      inputs.push_back(path);
  inputs.push_back(settings.session);
  return inputs;
}

} // namespace pcl_cid::tools
