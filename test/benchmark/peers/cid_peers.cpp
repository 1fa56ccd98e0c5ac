/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID beside other methods, on the same scan in the same run.
 */

#include "comparison.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/output_files.h>

#include <charconv>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/program_options.hpp>

namespace pcl_cid::benchmarks {
namespace {

namespace po = boost::program_options;

constexpr const char* about =
    "Compares CID with other methods of segmentation on one labelled scan.\n\n"
    "Usage: cid_peers SCAN.pcd [options]\n\n"
    "SCAN (PCD or PLY) has its true instances in the field `label` and, perhaps, its\n"
    "classes in `semantic`. Every run of every method is a process of its own. "
    "Methods:\n"
    "  cid             CIDSampler at full resolution\n"
    "  cid20k          the same on a draw of 20,000 points\n"
    "  euclidean       farthest-first sampling, Euclidean distance, the same start\n"
    "  lccp            pcl::SupervoxelClustering and pcl::LCCPSegmentation\n"
    "  region_growing  pcl::RegionGrowing\n"
    "  wcseg           weakly convex components by lines of sight\n"
    "The last three are tried with many settings; doc/peers.md says which is taken.\n";

constexpr int paper_points = 20000;

struct Settings : SeedSettings {
  std::string scan;
  std::string methods = "cid,cid20k,euclidean,lccp,region_growing,wcseg";
  std::string random_seed_list = "0";
  std::vector<std::string> viewpoints;
  std::string out;
  std::string report;
};

po::options_description
describe(Settings& settings)
{
  po::options_description options("Options");
  auto add = options.add_options();
  add("scan", po::value(&settings.scan)->required(), "a PCD or PLY file");
  add("methods",
      po::value(&settings.methods),
      "which methods, with commas between; default all");
  add("seeds", po::value(&settings.seeds), "K, for methods with seeds; default 100");
  add("random-seeds",
      po::value(&settings.random_seed_list),
      "a run of each method with seeds for each of these, with commas between; default "
      "0");
  add("viewpoints",
      po::value(&settings.viewpoints)->multitoken(),
      "X,Y,Z ...: where sensors stood; default the one that the file names");
  add("threads", po::value(&settings.threads), "of CID; default 1, as all others");
  add("out", po::value(&settings.out), "folder for the labels of each method");
  add("report", po::value(&settings.report), "file for all runs, as JSON");
  add("help,h", "print this and exit");
  return options;
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

/** One number, and nothing else. */
template <typename Number>
Number
parseNumber(const std::string& option, const std::string& text)
{
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end)
    throw std::invalid_argument("--" + option + " has '" + text +
                                "', which is not such a number; see --help");
  return number;
}

std::vector<Eigen::Vector3f>
parseViewpoints(const std::vector<std::string>& texts)
{
  std::vector<Eigen::Vector3f> viewpoints;
  for (const std::string& text : texts) {
    const std::vector<std::string> numbers = splitAtCommas(text);
    if (numbers.size() != 3)
      throw std::invalid_argument("--viewpoints has '" + text +
                                  "'; it must be X,Y,Z without blanks");
    viewpoints.emplace_back(parseNumber<float>("viewpoints", numbers[0]),
                            parseNumber<float>("viewpoints", numbers[1]),
                            parseNumber<float>("viewpoints", numbers[2]));
  }
  return viewpoints;
}

void
read(int argc, char** argv, Settings& settings)
{
  const po::options_description options = describe(settings);
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv)
                .options(options)
                .positional(po::positional_options_description().add("scan", 1))
                .run(),
            values);
  if (values.count("help") != 0) {
    std::cout << about << '\n' << options;
    std::exit(0);
  }
  po::notify(values);
  if (settings.seeds < 1)
    throw std::invalid_argument("--seeds must be at least 1");
  settings.random_seeds.clear();
  for (const std::string& text : splitAtCommas(settings.random_seed_list))
    settings.random_seeds.push_back(parseNumber<std::uint64_t>("random-seeds", text));
  if (settings.random_seeds.empty())
    throw std::invalid_argument("--random-seeds is empty; it must name at least one");
}

std::vector<PeerRun>
runsOf(const std::string& method, const PeerScan& scan, const Settings& settings)
{
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
  throw std::invalid_argument("--methods has '" + method +
                              "', which is not a method; see --help");
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
             const std::vector<PeerRow>& rows)
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
                  [&](std::ostream& s) { s << toJson(scan, settings, rows); });
    outputs.commit();
  }
}

/** Say where a method cannot be compared, and how often it was better. */
void
printRemarks(const PeerScan& scan, const std::vector<PeerRow>& rows)
{
  struct Tally {
    std::size_t runs = 0;
    std::size_t compared = 0;
    std::size_t purer = 0;
  };
  std::map<std::string, Tally> tallies;
  for (const PeerRow& row : rows)
    if (!row.hasSeeds()) {
      Tally& tally = tallies[row.run.method];
      ++tally.runs;
      tally.compared += row.cid_purity ? 1 : 0;
      tally.purer += row.cid_purity && row.margin() > 0.0 ? 1 : 0;
    }
  const ComparableParts comparable = comparableParts(scan);
  for (const auto& [method, tally] : tallies)
    std::cout << method << ": " << tally.runs << " settings, " << tally.compared
              << " with " << comparable.least << " to " << comparable.most
              << " parts, of which " << tally.purer << " purer than CID\n";
}

void
comparePeers(const Settings& settings)
{
  const PeerScan scan =
      readPeerScan(settings.scan, parseViewpoints(settings.viewpoints));
  std::vector<PeerRun> runs;
  for (const std::string& method : splitAtCommas(settings.methods))
    for (PeerRun& run : runsOf(method, scan, settings))
      runs.push_back(std::move(run));
  std::vector<PeerRow> rows;
  for (PeerRun& run : runs) {
    rows.push_back(measureAndScore(scan, std::move(run)));
    const PeerRow& row = rows.back();
    std::cerr << row.run.method << ' ' << settingsAsText(row.run) << ": "
              << row.measured.seconds << " s, " << row.parts << " parts, purity "
              << row.purity << std::endl;
  }
  compareWithCID(scan, settings, rows);
  std::cout << settings.scan << ": " << scan.cloud->size() << " points, "
            << countLabels(scan.truth.label) << " instances\n\n"
            << toTable(rows) << '\n';
  printRemarks(scan, rows);
  writeResults(scan, settings, rows);
}

} // namespace
} // namespace pcl_cid::benchmarks

int
main(int argc, char** argv)
{
  using namespace pcl_cid::benchmarks;
  try {
    Settings settings;
    read(argc, argv, settings);
    comparePeers(settings);
  }
  catch (const std::logic_error& error) {
    std::cerr << "cid_peers: " << error.what() << '\n';
    return 2;
  }
  catch (const std::exception& error) {
    std::cerr << "cid_peers: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
