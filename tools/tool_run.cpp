/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the tools share: settings, messages, progress, how a run ends.
 */

#include "tool_run.h"

#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <cfloat>
#include <climits>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <pcl/console/print.h>

#include <unistd.h>

namespace pcl_cid::tools {
namespace {

volatile std::sig_atomic_t caught_signal = 0;

extern "C" void
catchSignal(int signal)
{
  caught_signal = signal;
}

/** The first signal lets the run end in order; a second one kills it. A broken pipe or
 * a full disk is an error of a write, not the end of the process. */
void
catchSignals()
{
  struct sigaction action = {};
  action.sa_handler = catchSignal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    sigaction(signal, &action, nullptr);
  for (const int signal : {SIGPIPE, SIGXFSZ})
    std::signal(signal, SIG_IGN);
}

std::string
printed(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

int
fail(const std::string& tool, const std::string& message)
{
  std::fflush(stdout);
  std::fprintf(stderr, "%s: %s\n", tool.c_str(), message.c_str());
  return EXIT_FAILURE;
}

} // namespace

int
Settings::numberOfSeeds(std::size_t points) const
{
  if (seeds)
    return *seeds;
  constexpr int paper_default = 100;
  return coverage ? static_cast<int>(points) : paper_default;
}

void
declareSeedOptions(Settings& settings, CommandLine& command_line)
{
  const Allowed<int> count{1, INT_MAX, "a whole number, at least 1"};
  command_line.group("Seeds");
  command_line.optionalNumber(
      "seeds",
      "K",
      count,
      settings.seeds,
      "number of seeds; default 100, or as many as --coverage needs");
  command_line.optionalNumber(
      "coverage",
      "R",
      {FLT_MIN, FLT_MAX, "a number of metres above 0"},
      settings.coverage,
      "stop when every point is within this CID of its seed, metres; "
      "with --seeds, whichever comes first");
  command_line.number("samples",
                      "M",
                      {2, 1 << 20, "a whole number, 2 to 1048576"},
                      settings.samples,
                      "samples on a segment");
  command_line.number("subsample",
                      "N",
                      {0, INT_MAX, "a whole number, 0 (all points) or more"},
                      settings.subsample,
                      "work on a random draw of N points, which the others follow (the "
                      "paper: 20000); 0 works on all");
  command_line.number("random-seed",
                      "S",
                      {0, UINT64_MAX, "a whole number, 0 to 18446744073709551615"},
                      settings.random_seed,
                      "of every random draw");
  command_line.optionalNumber("start-index",
                              "I",
                              {0, INT_MAX, "the index of a point, 0 or more"},
                              settings.start_index,
                              "first seed, instead of a random one");
  declareRawScanOptions(settings.raw_scan, command_line);
}

void
declareClassTable(std::string& class_table, CommandLine& command_line)
{
  command_line.text("class-table",
                    "FILE.tsv",
                    class_table,
                    "ScanNet's scannetv2-labels.combined.tsv, when INPUT is a scan of "
                    "ScanNet; default: looked for in INPUT and the folders above it");
}

void
declareRunOptions(Settings& settings, CommandLine& command_line)
{
  command_line.group("Run");
  declareClassTable(settings.class_table, command_line);
  command_line.choice("label-type",
                      "TYPE",
                      {"U4", "I4", "F4"},
                      settings.label_type,
                      "type of the label field that is written: U4, I4 or F4");
  command_line.number("threads",
                      "T",
                      {0u, 1024u, "a whole number, 0 (all) to 1024"},
                      settings.threads,
                      "number of threads, 0 for all; never changes a result");
  command_line.text("report",
                    "FILE.json",
                    settings.report,
                    "write what was done, and how long it took");
  command_line.flag("quiet", settings.quiet, "print nothing but errors");
  command_line.helpOptions();
}

std::string
extensionOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& letter : extension)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

void
requireExtension(const std::string& name,
                 const std::string& path,
                 const std::vector<std::string>& extensions)
{
  if (std::find(extensions.begin(), extensions.end(), extensionOf(path)) ==
      extensions.end())
    throw UsageError(name + " is '" + path + "'; its name must end in " +
                     alternatives(extensions));
}

Console::Console(bool quiet)
: quiet_(quiet), has_terminal_(!quiet && isatty(STDERR_FILENO) == 1)
{
  if (quiet)
    pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
}

void
Console::begin(const std::string& step)
{
  if (caught_signal != 0)
    throw Interrupted();
  step_ = step;
  begun_ = std::chrono::steady_clock::now();
}

void
Console::end(const std::string& result, const std::string& name, Report& report)
{
  eraseBar();
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - begun_;
  report.steps.push_back({name, seconds.count()});
  if (quiet_)
    return;
  pcl::console::print_highlight("%s ", step_.c_str());
  pcl::console::print_info("[done, ");
  pcl::console::print_value("%.0f", 1e3 * seconds.count());
  pcl::console::print_info(" ms : ");
  pcl::console::print_value("%s", result.c_str());
  pcl::console::print_info("]\n");
  std::fflush(stdout);
}

void
Console::remark(const std::string& sentence) const
{
  if (!quiet_)
    pcl::console::print_warn("%s\n", sentence.c_str());
}

void
Console::value(const std::string& name, const std::string& value) const
{
  if (quiet_)
    return;
  pcl::console::print_info("%s: ", name.c_str());
  pcl::console::print_value("%s\n", value.c_str());
}

ProgressCallback
Console::progress()
{
  return [this](double fraction) {
    drawBar(fraction);
    return caught_signal == 0;
  };
}

void
Console::drawBar(double fraction)
{
  if (!has_terminal_)
    return;
  constexpr int width = 40;
  std::string bar(width, ' ');
  std::fill_n(bar.begin(), static_cast<int>(width * fraction), '#');
  std::fprintf(
      stderr, "\r%s [%s] %3.0f %%", step_.c_str(), bar.c_str(), 100 * fraction);
  bar_drawn_ = true;
}

void
Console::eraseBar()
{
  if (bar_drawn_)
    std::fputs("\r\033[K", stderr);
  bar_drawn_ = false;
}

std::vector<std::string>
inputFiles(const Settings& settings)
{
  return scanFiles(settings.input, settings.class_table);
}

LabelledCloud
loadCloud(const Settings& settings,
          Console& console,
          Report& report,
          CloudPoints& points)
{
  const std::string& path = settings.input;
  console.begin("Loading " + path);
  ScanOptions options;
  options.class_table = settings.class_table;
  options.remark = [&](const std::string& sentence) {
    console.remark(sentence);
    report.remarks.push_back(sentence);
  };
  LabelledCloud cloud = readScan(path, options);
  points = pointsOf(cloud);
  if (points.finite == 0)
    throw CIDException(path + ": none of its " + std::to_string(cloud.size()) +
                       " points is finite; at least 1 must be");
  console.end(std::to_string(cloud.size()) + " points, " +
                  std::to_string(points.finite) + " finite",
              "load",
              report);
  report.input = path;
  return cloud;
}

void
configure(const Settings& settings,
          const LabelledCloud& cloud,
          const CloudPoints& points,
          Console& console,
          CIDParameters& parameters)
{
  parameters.setNumberOfSeeds(settings.numberOfSeeds(points.points->size()));
  parameters.setCoverage(static_cast<float>(settings.coverage.value_or(0.0)));
  parameters.setNumberOfSamples(settings.samples);
  parameters.setSubsample(settings.subsample);
  parameters.setRandomSeed(settings.random_seed);
  if (settings.start_index)
    parameters.setStartIndex(*settings.start_index);
  configureForRawScan(settings.raw_scan, cloud, parameters);
  parameters.setNumberOfThreads(settings.threads);
  parameters.setProgressCallback(console.progress());
}

std::vector<Report::Parameter>
parametersOf(const Settings& settings, const CIDParameters& parameters)
{
  std::vector<Report::Parameter> list{
      {"seeds", std::int64_t{parameters.getNumberOfSeeds()}},
      {"coverage", std::monostate()},
      {"samples", std::int64_t{parameters.getNumberOfSamples()}},
      {"subsample", std::int64_t{parameters.getSubsample()}},
      {"random_seed", parameters.getRandomSeed()},
      {"start_index", std::monostate()},
      {"threads", std::int64_t{parameters.getNumberOfThreads()}}};
  if (settings.coverage)
    list[1].value = *settings.coverage;
  if (settings.start_index)
    list[5].value = std::int64_t{*settings.start_index};
  for (Report::Parameter& parameter : parametersOf(settings.raw_scan))
    list.push_back(std::move(parameter));
  return list;
}

std::string
shortNumber(double value)
{
  return printed("%.4g", value);
}

std::string
percent(double share)
{
  return printed("%.2f %%", 100.0 * share);
}

std::string
messageOf(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is not enough memory for so many points; give it fewer";
  return error.what();
}

int
runTool(const std::string& tool, const std::function<void()>& work)
{
  catchSignals();
  try {
    work();
    return EXIT_SUCCESS;
  }
  catch (const UsageError& error) {
    fail(tool, std::string(error.what()) + "; see " + tool + " --help");
    return 2;
  }
  catch (const Interrupted&) {
    fail(tool, "interrupted; nothing was written");
    return 128 + caught_signal;
  }
  catch (const CIDCancelled&) {
    fail(tool, "interrupted; nothing was written");
    return 128 + caught_signal;
  }
  catch (const std::exception& error) {
    return fail(tool, messageOf(error));
  }
}

} // namespace pcl_cid::tools
