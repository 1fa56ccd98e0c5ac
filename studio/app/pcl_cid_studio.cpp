/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_studio: a scan labelled by hand, in the browser.
 */

#include "app/browser.h"
#include "app/label_import.h"
#include "app/scan_resources.h"
#include "app/session_worker.h"
#include "app/studio_settings.h"
#include "run/loaded_scan.h"
#include "run/run.h"
#include "run/session_settings.h"
#include "server/embedded_page.h"
#include "server/local_server.h"
#include "server/page_folder.h"

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <memory>

namespace {

namespace fs = std::filesystem;
using namespace pcl_cid;
using namespace pcl_cid::studio;
using namespace pcl_cid::tools;

std::vector<std::string>
inputsOf(const StudioSettings& settings)
{
  std::vector<std::string> inputs = inputFiles(settings);
  inputs.push_back(settings.session);
  return inputs;
}

/** Those of the scan, where it has any that can be shown. */
std::vector<ColorRGB>
colorsToShow(const LoadedScan& scan, Run& run)
{
  try {
    return hasColors(scan.cloud) ? colorsOf(scan.cloud) : std::vector<ColorRGB>();
  }
  catch (const CIDException& error) {
    run.remark()(std::string("no colors are shown: ") + error.what());
    return {};
  }
}

ScanFacts
factsOf(const StudioSettings& settings, const LoadedScan& scan, const PointSet& points)
{
  ScanFacts facts;
  facts.name = scanName(settings.input);
  facts.session = fs::path(settings.session).filename().string();
  facts.points = scan.cloud.size();
  facts.origin = scan.points.frame.toFile(points.frame.origin);
  const std::string axes = "xyz";
  facts.up = Eigen::Vector3f::Unit(static_cast<Eigen::Index>(axes.find(settings.up)));
  facts.classes = settings.classes;
  facts.meshes = partMeshes();
  return facts;
}

std::unique_ptr<Resources>
pageOf(const StudioSettings& settings)
{
  if (settings.page.empty())
    return std::make_unique<EmbeddedPage>(embeddedPage());
  if (!fs::is_regular_file(fs::path(settings.page) / "index.html"))
    throw CIDException("--page " + settings.page +
                       ": there is no page; index.html must be in this folder");
  return std::make_unique<PageFolder>(settings.page);
}

/** The class of a label: that which most of its points have in the field `semantic`. */
ClassOf
classesIn(const LoadedScan& scan,
          const std::vector<std::uint32_t>& labels,
          const std::vector<std::string>& classes)
{
  if (!hasField(scan.cloud, "semantic"))
    return [](std::uint32_t) { return std::string(); };
  const std::vector<std::uint32_t> semantic =
      labelsOf(scan.cloud, "semantic", scan.points);
  return [=](std::uint32_t label) {
    std::map<std::uint32_t, std::size_t> count;
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (labels[i] == label)
        ++count[semantic[i]];
    const auto most =
        std::max_element(count.begin(), count.end(), [](auto& a, auto& b) {
          return a.second < b.second;
        });
    const std::size_t number = most == count.end() ? 0 : most->first;
    if (number == 0)
      return std::string();
    return number <= classes.size() ? classes[number - 1] : std::to_string(number);
  };
}

/** Whether what is imported is a table of seeds; else a field of the scan. */
bool
isTable(const std::string& import)
{
  return fs::path(import).extension() == ".csv";
}

/** Begin a session: with questions, or with labels that were given elsewhere. */
void
begin(const StudioSettings& settings,
      const LoadedScan& scan,
      RecordedSession& session,
      const ExecutionOptions& execution)
{
  const auto seeds = static_cast<std::size_t>(std::min<std::size_t>(
      static_cast<std::size_t>(*settings.seeds), scan.points.finite));
  if (settings.import.empty()) {
    session.apply(action::Propose{seeds}, execution);
    return;
  }
  if (isTable(settings.import)) {
    importSeeds(readSeedTable(settings.import, scan.points), session, execution);
    return;
  }
  const std::vector<std::uint32_t> labels =
      labelsOf(scan.cloud, settings.import, scan.points);
  importLabels(
      labels, classesIn(scan, labels, settings.classes), seeds, session, execution);
}

/** What is wrong with the import, before the work. */
void
requireImport(const StudioSettings& settings, const LoadedScan& scan)
{
  if (settings.import.empty())
    return;
  if (isTable(settings.import)) {
    readSeedTable(settings.import, scan.points);
    return;
  }
  for (const std::uint32_t label : labelsOf(scan.cloud, settings.import, scan.points))
    if (label == std::numeric_limits<std::uint32_t>::max())
      throw CIDException(settings.input + ": field '" + settings.import +
                         "' has the label " + std::to_string(label) +
                         "; labels of a session go to one below");
}

/** Go on with a session that is there: its settings count.
 *  \return whether there is one */
bool
goOn(StudioSettings& settings)
{
  const std::optional<SessionRecord> record = findSession(settings.session);
  if (!record)
    return false;
  if (!settings.import.empty() && settings.import != record->settings.imported)
    throw CIDException(settings.session + ": the session has begun already; --import "
                                          "needs a new one (give another --session)");
  useSettingsOf(record->settings, settings);
  return true;
}

/** Where a session is as long as it is not known to be whole. */
std::string
partialName(const StudioSettings& settings)
{
  return settings.session + ".part";
}

void
serve(StudioSettings& settings)
{
  Run run(studio_tool, settings.quiet, {});
  const bool imports = !goOn(settings) && !settings.import.empty();
  const std::unique_ptr<Resources> page = pageOf(settings);
  const LoadedScan scan = loadScan(settings, run);
  if (imports)
    requireImport(settings, scan);
  SessionSettings session_settings = sessionSettingsOf(settings);
  session_settings.imported = settings.import;
  SessionFile file(imports ? partialName(settings) : settings.session,
                   identityOf(scan.cloud),
                   session_settings,
                   imports);
  const PointSet points = finitePoints(*scan.points.points);
  const Places places(points, scan.cloud.size());
  const ScanResources resources(
      *page, factsOf(settings, scan, points), points, places, colorsToShow(scan, run));
  const std::string folder = fs::absolute(settings.session).parent_path().string();
  const std::string name = scanName(settings.input);
  LabelExporter exporter(scan.cloud, scan.points, inputsOf(settings), folder, name);
  const PartExporter part_exporter(
      scan, settings.parts, inputsOf(settings), folder, name);
  SessionWorker worker(
      [&](const ExecutionOptions& execution) {
        auto session = std::make_unique<RecordedSession>(
            prepareSession(settings, scan, execution), file, execution);
        if (session->revision() == 0)
          begin(settings, scan, *session, execution);
        if (imports)
          file.moveTo(settings.session);
        return session;
      },
      places,
      scan,
      exporter,
      settings.parts,
      part_exporter);
  LocalServer server(resources, worker, settings.port);
  server.stopOnSignals();
  worker.start(server);
  // Whatever happens, nobody works when the server is gone.
  const std::unique_ptr<SessionWorker, void (*)(SessionWorker*)> at_work(
      &worker, [](SessionWorker* each) { each->stop(); });
  std::cout << "Open " << server.url() << std::endl;
  if (!settings.no_browser && !openBrowser(server.url()))
    run.console.remark("no browser could be opened; open the address in one");
  server.run();
  worker.stop();
  worker.requireSuccess();
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(studio_tool, [&] {
    StudioSettings settings;
    if (readCommandLine(argc, argv, settings))
      serve(settings);
  });
}
