/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID beside other methods, on the same scan in the same run.
 */

#include "comparison.h"
#include "run/command_line.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/viewpoints.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace pcl_cid::benchmarks {
namespace {

using tools::CommandLine;
using tools::UsageError;

constexpr const char* tool = "cid_peers";
constexpr int paper_points = 20000;

/** What peers are compared with. */
enum class Compare { parts, curve, none };

constexpr ChoiceSetting<Compare, 3> compare_setting{
    "Comparison",
    "compare",
    "WITH",
    Compare::parts,
    {{{"parts", Compare::parts}, {"curve", Compare::curve}, {"none", Compare::none}}},
    "CID with as many parts as each run; all of its numbers of parts, in the report "
    "only; or nothing"};

constexpr NumberSetting<int> seeds_setting{"Methods",
                                           "seeds",
                                           "number of seeds",
                                           "K",
                                           "",
                                           100,
                                           1,
                                           1000000,
                                           "of methods with seeds"};

constexpr NumberSetting<unsigned> starts_setting{
    "Methods",
    "starts",
    "number of starts",
    "N",
    "",
    1,
    1,
    1000,
    "runs of methods with seeds: from random seeds S, S + 1 ..."};

constexpr NumberSetting<int> tree_seeds_setting{
    "Comparison",
    "tree_seeds",
    "number of groups",
    "K",
    "",
    100,
    1,
    1000000,
    "groups of the merge tree that CID is cut from"};

struct Settings : SeedSettings {
  std::string scan;
  std::string methods = "cid,cid20k,euclidean,lccp,region_growing,wcseg";
  std::uint64_t random_seed = 0;
  unsigned starts = starts_setting.initial;
  std::string viewpoints;
  Compare compare = compare_setting.initial;
  std::string out;
  std::string report;
};

void
declareMethodOptions(Settings& settings, CommandLine& line)
{
  line.group("Methods");
  line.text("methods",
            "LIST",
            settings.methods,
            "with commas between, or none; default: all");
  line.setting(seeds_setting, settings.seeds);
  line.setting(setting::random_seed, settings.random_seed);
  line.setting(starts_setting, settings.starts);
  line.text("viewpoints",
            "FILE",
            settings.viewpoints,
            "where sensors stood (JSON or a table); default: the pose in SCAN");
  line.setting(
      setting::threads, settings.threads, "of CID: the others have one thread");
}

void
declareComparison(Settings& settings, CommandLine& line)
{
  line.group("Comparison");
  line.choice(compare_setting, settings.compare);
  line.optional(tree_seeds_setting, settings.tree_seeds, "default: as many as --seeds");
  line.text("out", "FOLDER", settings.out, "for the labels of each method");
  line.text("report", "FILE", settings.report, "all runs as JSON");
  line.helpOptions();
}

bool
readCommandLine(int argc, const char* const* argv, Settings& settings)
{
  CommandLine line(
      tool,
      "cid_peers SCAN [options]",
      "Compare CID with other methods of segmentation on one labelled scan.\n"
      "SCAN (PCD or PLY) has its true instances in the field `label` and, perhaps, "
      "its\n"
      "classes in `semantic`. Every run of every method is a process of its own.\n"
      "Methods:\n"
      "  cid             CIDSampler at full resolution\n"
      "  cid20k          the same on a draw of 20,000 points\n"
      "  euclidean       farthest-first sampling, Euclidean distance, the same start\n"
      "  lccp            pcl::SupervoxelClustering and pcl::LCCPSegmentation\n"
      "  region_growing  pcl::RegionGrowing\n"
      "  wcseg           weakly convex components by lines of sight\n"
      "The last three are tried with many settings; doc/peers.md says which is taken.");
  declareMethodOptions(settings, line);
  declareComparison(settings, line);
  if (!line.parse(argc, argv, {tools::scanArgument("SCAN")}, {&settings.scan}))
    return false;
  settings.random_seeds.clear();
  for (unsigned start = 0; start < settings.starts; ++start)
    settings.random_seeds.push_back(settings.random_seed + start);
  return true;
}

std::vector<std::string>
splitAtCommas(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
    parts.push_back(part);
  return parts;
}

std::vector<PeerRun>
runsOf(const std::string& method, const PeerScan& scan, const Settings& settings)
{
  if (method == "none")
    return {};
  if (method == "cid")
    return cidRuns(scan, settings, 0);
  if (method == "cid20k")
    return cidRuns(scan, settings, paper_points);
  if (method == "euclidean")
    return euclideanRuns(scan, settings);
  if (method == "lccp")
    return lccpRuns(scan, pointSpacing(*scan.cloud));
  if (method == "region_growing")
    return regionGrowingRuns(scan);
  if (method == "wcseg")
    return wcsegRuns(scan);
  throw UsageError("--methods has '" + method + "', which is not a method");
}

/** scan_cid_0.pcd, scan_lccp.pcd. */
std::string
fileFor(const PeerRow& row, const Settings& settings)
{
  std::string name =
      std::filesystem::path(settings.scan).stem().string() + "_" + row.run.method;
  for (const Report::Parameter& setting : row.run.settings)
    if (setting.name == "random_seed")
      name += "_" + std::to_string(std::get<std::uint64_t>(setting.value));
  return (std::filesystem::path(settings.out) / (name + ".pcd")).string();
}

void
writeResults(const PeerScan& scan,
             const Settings& settings,
             const std::vector<PeerRow>& rows,
             const std::map<std::size_t, double>& curve)
{
  if (!settings.out.empty()) {
    std::filesystem::create_directories(settings.out);
    for (const PeerRow& row : rows)
      if (row.hasSeeds() || row.is_best)
        writeLabels(scan, row.labels, fileFor(row, settings));
  }
  if (!settings.report.empty()) {
    OutputFiles outputs({settings.scan});
    outputs.announce(settings.report);
    outputs.write(settings.report,
                  [&](std::ostream& s) { s << toJson(scan, settings, rows, curve); });
    outputs.commit();
  }
}

/** Say where a method failed or cannot be compared, and how often it was better. */
void
printRemarks(const PeerScan& scan, const std::vector<PeerRow>& rows)
{
  struct Tally {
    std::size_t runs = 0;
    std::size_t failed = 0;
    std::size_t compared = 0;
    std::size_t purer = 0;
  };
  std::map<std::string, Tally> tallies;
  for (const PeerRow& row : rows)
    if (!row.hasSeeds()) {
      Tally& tally = tallies[row.run.method];
      ++tally.runs;
      tally.failed += row.failure.empty() ? 0 : 1;
      tally.compared += row.cid_purity ? 1 : 0;
      tally.purer += row.cid_purity && row.margin() > 0.0 ? 1 : 0;
    }
  const ComparableParts comparable = comparableParts(scan);
  for (const auto& [method, tally] : tallies)
    std::cout << method << ": " << tally.runs << " settings, " << tally.failed
              << " failed, " << tally.compared << " compared, with " << comparable.least
              << " to " << comparable.most << " parts, of which " << tally.purer
              << " purer than CID\n";
}

/** One after the other, as each is measured by itself. */
std::vector<PeerRow>
measureAll(const PeerScan& scan, std::vector<PeerRun> runs)
{
  std::vector<PeerRow> rows;
  for (PeerRun& run : runs) {
    rows.push_back(measureAndScore(scan, std::move(run)));
    const PeerRow& row = rows.back();
    std::cerr << row.run.method << ' ' << settingsAsText(row.run) << ": ";
    if (row.failure.empty())
      std::cerr << row.measured.seconds << " s of CPU, " << row.parts
                << " parts, purity " << row.purity << std::endl;
    else
      std::cerr << row.failure << std::endl;
  }
  return rows;
}

void
comparePeers(const Settings& settings)
{
  std::vector<Eigen::Vector3d> viewpoints;
  if (!settings.viewpoints.empty())
    viewpoints = readViewpoints(settings.viewpoints);
  const PeerScan scan = readPeerScan(settings.scan, viewpoints);
  std::vector<PeerRun> runs;
  for (const std::string& method : splitAtCommas(settings.methods))
    for (PeerRun& run : runsOf(method, scan, settings))
      runs.push_back(std::move(run));
  std::vector<PeerRow> rows = measureAll(scan, std::move(runs));
  std::map<std::size_t, double> curve;
  if (settings.compare == Compare::parts)
    compareWithCID(scan, settings, rows);
  else if (settings.compare == Compare::curve)
    curve = cidCurve(scan, settings);
  std::cout << settings.scan << ": " << scan.cloud->size() << " points, "
            << countLabels(scan.truth.label) << " instances\n\n"
            << toTable(rows) << '\n';
  printRemarks(scan, rows);
  writeResults(scan, settings, rows, curve);
}

} // namespace
} // namespace pcl_cid::benchmarks

int
main(int argc, char** argv)
{
  using namespace pcl_cid::benchmarks;
  // Unlike the tools, it may be stopped by a signal at any time.
  try {
    Settings settings;
    if (readCommandLine(argc, argv, settings))
      comparePeers(settings);
  }
  catch (const UsageError& error) {
    std::cerr << "cid_peers: " << error.what() << "; see cid_peers --help\n";
    return 2;
  }
  catch (const std::exception& error) {
    std::cerr << "cid_peers: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
