/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Times and memory from the loaded cloud to the result, as rows of a CSV file.
 */

#include "benchmark_cloud.h"
#include "child_process.h"
#include "measured_work.h"

#include <pcl_cid/io/cloud_points.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/program_options.hpp>

namespace pcl_cid::benchmarks {
namespace {

namespace po = boost::program_options;

constexpr const char* about =
    "Measures pcl_cid, and the literal method, on one cloud.\n\n"
    "Usage: cid_end_to_end (CLOUD.pcd | --room even|sensor --points N) "
    "--measure WORK[:SEEDS[:THREADS]] ... [options]\n\n"
    "WORK is segment, defaults, sample, extend, seeds, merge, cut, literal, check, "
    "handle, hulls, fit, add, remove, click, click_p95, read_pcd, read_ascii_pcd, "
    "read_ply, pcl_pcd, "
    "pcl_ascii_pcd, pcl_ply, busy or busy_cpu. "
    "Every measurement is a process of its own that begins with the loaded cloud; "
    "rounds take turns, so "
    "that a slow moment of the machine meets all of them. A literal one works with the "
    "seeds of a segment one with as many seeds, which must come before it.\n";

struct Settings {
  std::string cloud;
  std::string room;
  std::size_t points = 20000;
  std::vector<std::string> measure;
  int samples = 100;
  double literal_seconds = 10.0;
  int rounds = 3;
  std::string csv;
};

po::options_description
describe(Settings& settings)
{
  po::options_description options("Options");
  auto add = options.add_options();
  add("cloud", po::value(&settings.cloud), "a PCD file");
  add("room", po::value(&settings.room), "a generated room: even or sensor");
  add("points", po::value(&settings.points), "points of the room; default 20000");
  add("measure,m",
      po::value(&settings.measure)->multitoken()->required(),
      "WORK[:SEEDS[:THREADS]]; default 100 seeds, 2 threads");
  add("samples", po::value(&settings.samples), "samples on a segment; default 100");
  add("literal-seconds",
      po::value(&settings.literal_seconds),
      "how long a literal measurement goes on with pairs; default 10");
  add("rounds", po::value(&settings.rounds), "how often all is measured; default 3");
  add("csv", po::value(&settings.csv), "file that rows are appended to");
  add("help,h", "print this and exit");
  return options;
}

void
read(int argc, char** argv, const po::options_description& options)
{
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv)
                .options(options)
                .positional(po::positional_options_description().add("cloud", 1))
                .run(),
            values);
  if (values.count("help") != 0) {
    std::cout << about << '\n' << options;
    std::exit(0);
  }
  po::notify(values);
  if (values.count("cloud") + values.count("room") != 1)
    throw std::invalid_argument("give either a PCD file or --room");
}

/** "segment:100:2". */
Work
parseWork(const std::string& text, const Settings& settings)
{
  Work work;
  work.samples = settings.samples;
  work.literal_seconds = settings.literal_seconds;
  std::istringstream stream(text);
  std::getline(stream, work.name, ':');
  char colon = ':';
  if (!stream.eof())
    stream >> work.seeds;
  if (stream && !stream.eof())
    stream >> colon >> work.threads;
  if (stream.fail() || colon != ':' || stream.peek() != EOF || work.seeds < 1 ||
      work.threads < 1 || !isWork(work.name))
    throw std::invalid_argument("--measure has '" + text +
                                "'; it must be WORK:SEEDS:THREADS, see --help");
  return work;
}

/** The input, its name in the results, and how many points count. */
struct Input {
  Cloud::ConstPtr cloud;
  std::string name;
  std::size_t points;
};

Input
makeInput(const Settings& settings)
{
  Input input;
  if (settings.room.empty()) {
    input.cloud = loadCloud(settings.cloud);
    input.name = std::filesystem::path(settings.cloud).stem().string();
  }
  else {
    input.cloud = makeRoomCloud(roomScanFromName(settings.room), settings.points);
    input.name = "room_" + settings.room;
  }
  input.points = finitePoints(*input.cloud).size();
  return input;
}

double
loadAverage()
{
  double load = 0.0;
  return getloadavg(&load, 1) == 1 ? load : -1.0;
}

/** Rows to a file, and for the reader to the standard output. */
class Results {
public:
  explicit Results(const std::string& path)
  {
    if (path.empty())
      return;
    const bool is_new = !std::filesystem::exists(path);
    csv_.open(path, std::ios::app);
    if (!csv_)
      throw std::runtime_error("cannot write " + path);
    if (is_new)
      csv_ << "input,points,work,seeds,samples,threads,round,seconds,share,"
              "peak_bytes,load"
           << std::endl;
  }

  void
  add(const Input& input, const Work& work, int round, const Measurement& result)
  {
    const double load = loadAverage();
    csv_ << input.name << ',' << input.points << ',' << work.name << ',' << work.seeds
         << ',' << work.samples << ',' << work.threads << ',' << round << ','
         << result.seconds << ',' << result.share << ',' << result.peak_bytes << ','
         << load << std::endl;
    std::cout << input.name << ", " << input.points << " points, round " << round
              << ": " << work.name << " K=" << work.seeds << " threads=" << work.threads
              << ": " << result.seconds << " s";
    if (result.share < 1.0)
      std::cout << " (" << 100.0 * result.share << " % done)";
    std::cout << ", " << static_cast<double>(result.peak_bytes) / 1e6 << " MB, load "
              << load << std::endl;
  }

private:
  std::ofstream csv_;
};

/** What a segment measurement with as many seeds found.
 *  \throws std::invalid_argument when there was none */
const pcl::Indices&
seedsOf(int number_of_seeds, const std::map<int, pcl::Indices>& seeds_found)
{
  const auto found = seeds_found.find(number_of_seeds);
  if (found == seeds_found.end())
    throw std::invalid_argument("a literal measurement needs a segment one with as "
                                "many seeds before it");
  return found->second;
}

void
measureAll(const Settings& settings)
{
  std::vector<Work> works;
  for (const std::string& text : settings.measure)
    works.push_back(parseWork(text, settings));
  Results results(settings.csv);
  const Input input = makeInput(settings);
  std::map<int, pcl::Indices> seeds_found;
  for (int round = 1; round <= settings.rounds; ++round)
    for (Work& work : works) {
      if (needsSeeds(work))
        work.given_seeds = seedsOf(work.seeds, seeds_found);
      const Measurement result =
          measureInChild([&] { return perform(work, input.cloud); });
      if (work.name == "segment")
        seeds_found[work.seeds] = result.seeds;
      results.add(input, work, round, result);
    }
}

} // namespace
} // namespace pcl_cid::benchmarks

int
main(int argc, char** argv)
{
  using namespace pcl_cid::benchmarks;
  try {
    Settings settings;
    read(argc, argv, describe(settings));
    measureAll(settings);
  }
  catch (const std::logic_error& error) {
    std::cerr << "cid_end_to_end: " << error.what() << '\n';
    return 2;
  }
  catch (const std::exception& error) {
    std::cerr << "cid_end_to_end: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
