/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings of a session and those of a tool.
 */

#include "session_settings.h"

#include <pcl_cid/cid_label_propagation.h>

namespace pcl_cid::tools {

SessionSettings
sessionSettingsOf(const Settings& settings)
{
  SessionSettings session;
  session.grouping.samples = settings.samples;
  session.grouping.seeding = settings.raw_scan.seeding;
  session.preparation.random_seed = settings.random_seed;
  session.preparation.start_index = settings.start_index;
  session.preparation.density = settings.raw_scan.density;
  session.preparation.density_power = settings.raw_scan.density_power;
  session.preparation.isolated_neighbors = settings.raw_scan.isolated_neighbors;
  session.preparation.color = settings.raw_scan.color;
  session.preparation.normals = settings.raw_scan.normals;
  session.preparation.connected = settings.raw_scan.connected;
  session.preparation.blind_spot = settings.raw_scan.blind_spot;
  session.keep_zeros = settings.keep_zeros;
  return session;
}

void
useSettingsOf(const SessionSettings& session, Settings& settings)
{
  settings.samples = session.grouping.samples;
  settings.raw_scan.seeding = session.grouping.seeding;
  settings.random_seed = session.preparation.random_seed;
  settings.start_index = session.preparation.start_index;
  settings.raw_scan.density = session.preparation.density;
  settings.raw_scan.density_power = session.preparation.density_power;
  settings.raw_scan.isolated_neighbors = session.preparation.isolated_neighbors;
  settings.raw_scan.color = session.preparation.color;
  settings.raw_scan.normals = session.preparation.normals;
  settings.raw_scan.connected = session.preparation.connected;
  settings.raw_scan.blind_spot = session.preparation.blind_spot;
  settings.keep_zeros = session.keep_zeros;
  settings.subsample = 0;
}

LabelSession
prepareSession(const Settings& settings,
               const LoadedScan& scan,
               const ExecutionOptions& execution)
{
  CIDLabelPropagation<pcl::PointXYZ> parameters;
  parameters.setNumberOfSamples(settings.samples);
  parameters.setRandomSeed(settings.random_seed);
  if (settings.start_index)
    parameters.setStartIndex(*settings.start_index);
  configureForRawScan(settings.raw_scan, scan.cloud, parameters);
  parameters.setNumberOfThreads(execution.threads);
  parameters.setProgressCallback(execution.progress);
  parameters.setInputCloud(scan.points.points);
  const PreparedScan::ConstPtr prepared = parameters.prepare();
  return LabelSession(prepared, parameters.getGroupingSettings());
}

} // namespace pcl_cid::tools
