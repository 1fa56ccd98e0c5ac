/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings of a session and those of a tool.
 */

#include "session_settings.h"

#include "parameter.h"

#include <pcl_cid/cid_label_propagation.h>

#include <utility>

namespace pcl_cid::tools {
namespace {

/** Call `visit(of a session, of a tool)` for each setting that labels depend on. */
template <typename Session, typename Tool, typename Visit>
void
forEachPair(Session& session, Tool& tool, const Visit& visit)
{
  auto& preparation = session.preparation;
  visit(session.grouping.samples, tool.samples);
  visit(session.grouping.seeding, tool.raw_scan.seeding);
  visit(preparation.random_seed, tool.random_seed);
  visit(preparation.start_index, tool.start_index);
  visit(preparation.density, tool.raw_scan.density);
  visit(preparation.density_power, tool.raw_scan.density_power);
  visit(preparation.isolated_neighbors, tool.raw_scan.isolated_neighbors);
  visit(preparation.color, tool.raw_scan.color);
  visit(preparation.normals, tool.raw_scan.normals);
  visit(preparation.connected, tool.raw_scan.connected);
  visit(preparation.blind_spot, tool.raw_scan.blind_spot);
  visit(session.keep_zeros, tool.keep_zeros);
}

template <typename Session>
Session
prepare(const Settings& settings,
        const LoadedScan& scan,
        const ExecutionOptions& execution,
        bool keep_cid)
{
  CIDLabelPropagation<pcl::PointXYZ> parameters;
  parameters.setKeepCID(keep_cid);
  configureGrouping(settings, scan, execution, parameters);
  parameters.setInputCloud(scan.points.points);
  const PreparedScan::ConstPtr prepared = parameters.prepare();
  return Session(prepared, parameters.getGroupingSettings());
}

} // namespace

void
declareSessionOption(std::string& session, const std::string& help, CommandLine& line)
{
  line.text("session", "FILE", session, help + "; settings are those of the session");
  line.exclude("session",
               {"keep-zeros",
                optionName(setting::seeds),
                optionName(setting::coverage),
                optionName(setting::samples),
                optionName(setting::subsample),
                optionName(setting::random_seed),
                optionName(setting::start_index)});
  line.exclude("session", rawScanOptionNames());
}

SessionSettings
sessionSettingsOf(const Settings& settings)
{
  SessionSettings session;
  forEachPair(session, settings, [](auto& of_session, const auto& of_tool) {
    of_session = of_tool;
  });
  return session;
}

void
useSettingsOf(const SessionSettings& session, Settings& settings)
{
  forEachPair(session, settings, [](const auto& of_session, auto& of_tool) {
    of_tool = of_session;
  });
  settings.subsample = 0;
}

std::vector<Report::Parameter>
sessionParametersOf(const std::string& session, const Settings& settings)
{
  std::vector<Report::Parameter> list{
      {"session", session},
      parameter(setting::samples, settings.samples),
      parameter(setting::random_seed, settings.random_seed),
      parameter(setting::threads, settings.threads)};
  for (Report::Parameter& each : parametersOf(settings.raw_scan))
    list.push_back(std::move(each));
  return list;
}

LabelSession
prepareSession(const Settings& settings,
               const LoadedScan& scan,
               const ExecutionOptions& execution)
{
  // With exact CIDs kept, each click costs a third less.
  return prepare<LabelSession>(settings, scan, execution, true);
}

PartSession
preparePartSession(const Settings& settings,
                   const LoadedScan& scan,
                   const ExecutionOptions& execution)
{
  return prepare<PartSession>(settings, scan, execution, false);
}

} // namespace pcl_cid::tools
