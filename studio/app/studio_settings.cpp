/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_studio is told: its settings and its command line.
 */

#include "studio_settings.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/class_names.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace pcl_cid::studio {
namespace {

namespace fs = std::filesystem;
using tools::CommandLine;

constexpr const char* about =
    "Label a scan by hand, in the browser. SCAN is a file of points (PCD, PLY, text,\n"
    "NumPy, KITTI), a mesh, a room folder of S3DIS or a scan folder of ScanNet. The\n"
    "program asks what a few seeds are, and every point follows its CID-nearest seed; "
    "a\n"
    "click where that is wrong corrects it. Each answer is on the disk before it "
    "counts;\n"
    "the same command goes on with what was done.\n\n"
    "  pcl_cid_studio room.pcd --classes s3dis\n\n"
    "It serves one page on this machine alone, at the address that it prints.";

constexpr int most_port = 65535;

constexpr NumberSetting<int> port_setting{"Page",
                                          "port",
                                          "port",
                                          "N",
                                          "",
                                          0,
                                          0,
                                          most_port,
                                          "port of the page",
                                          "for a free one"};

/** Where no number of questions is asked for: enough to begin with. */
constexpr int first_questions = 50;

std::vector<std::string>
namesOf(const SemanticClasses& classes)
{
  std::vector<std::string> names;
  for (const SemanticClass& each : classes)
    names.push_back(each.name);
  return names;
}

/** One name a line. */
std::vector<std::string>
readClasses(const std::string& path)
{
  std::ifstream stream(path);
  if (!stream)
    throw CIDException("--classes " + path +
                       ": cannot be read; it must be s3dis, scannet or a file with a "
                       "class in each line");
  std::vector<std::string> names;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
      line.pop_back();
    if (line.empty())
      continue;
    if (std::find(names.begin(), names.end(), line) != names.end())
      throw CIDException(path + ": line " + std::to_string(number) + ": class '" +
                         line + "' is there already; name each once");
    names.push_back(line);
  }
  if (names.empty())
    throw CIDException(path + ": there is no class in it; at least 1 is needed");
  return names;
}

std::vector<std::string>
classesFor(const std::string& word)
{
  if (word.empty())
    return {};
  if (word == "s3dis")
    return namesOf(s3disClasses());
  if (word == "scannet")
    return namesOf(nyu40Classes());
  return readClasses(word);
}

/** Beside the scan. */
std::string
defaultSession(const std::string& input)
{
  fs::path path = fs::path(input).lexically_normal();
  if (!path.has_filename()) // "room/"
    path = path.parent_path();
  return fs::is_directory(path) ? path.string() + ".session"
                                : path.replace_extension(".session").string();
}

} // namespace

bool
readCommandLine(int argc, const char* const* argv, StudioSettings& settings)
{
  CommandLine line(studio_tool, "pcl_cid_studio SCAN [options]", about);
  std::string classes;
  int port = 0;
  settings.seeds = first_questions;
  line.group("Session");
  line.text("session",
            "FILE",
            settings.session,
            "where actions are written; default: SCAN with the extension .session");
  line.text("import",
            "FIELD|FILE.csv",
            settings.import,
            "begin a new session with the labels in this field of SCAN, or with those "
            "of a table of seeds, FILE.csv");
  line.text("classes",
            "s3dis|scannet|FILE",
            classes,
            "classes to choose from: s3dis, scannet, or a file with one in each line");
  line.group(port_setting.group);
  line.setting(port_setting, port);
  line.flag(
      "no-browser", settings.no_browser, "print the address, and open no browser");
  line.text("page", "DIR", settings.page, "serve the page from this folder");
  line.word("up", "AXIS", {"x", "y", "z"}, settings.up, "which axis points up");
  line.group(setting::seeds.group);
  line.optional(setting::seeds,
                settings.seeds,
                "of the first questions; default " + std::to_string(first_questions));
  line.setting(setting::samples, settings.samples);
  line.setting(setting::random_seed, settings.random_seed);
  line.optional(setting::start_index, settings.start_index);
  tools::declareRawScanOptions(settings.raw_scan, line);
  declareHullOptions(settings.parts, line);
  declareReadingOptions(settings, line);
  line.setting(setting::threads, settings.threads);
  line.flag("quiet", settings.quiet, "print nothing but the address and errors");
  line.helpOptions();
  if (!line.parse(argc, argv, {tools::scanArgument("SCAN")}, {&settings.input}))
    return false;
  settings.classes = classesFor(classes);
  settings.port = static_cast<std::uint16_t>(port);
  if (settings.session.empty())
    settings.session = defaultSession(settings.input);
  settings.parts.session = settings.session;
  settings.parts.threads = settings.threads;
  return true;
}

} // namespace pcl_cid::studio
