/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Methods measured and scored on one scan.
 */

#include "comparison.h"

#include "cid_curve.h"

#include <algorithm>
#include <ctime>
#include <set>
#include <stdexcept>

namespace pcl_cid::benchmarks {
namespace {

/** In time of the processor: that of the clock is others', too, on a shared machine. */
Measurement
timed(const std::function<Measurement()>& work)
{
  const std::clock_t begun = std::clock();
  Measurement result = work();
  result.seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  return result;
}

} // namespace

PeerRow
measureAndScore(const PeerScan& scan, PeerRun run)
{
  PeerRow row;
  row.run = std::move(run);
  try {
    row.measured = measureInChild([&] { return timed(row.run.work); });
  }
  catch (const std::runtime_error& error) {
    row.failure = error.what();
    return row;
  }
  row.labels = std::move(row.measured.labels);
  row.parts = countLabels(row.labels);
  row.labelled =
      1.0 - static_cast<double>(std::count(row.labels.begin(), row.labels.end(), 0u)) /
                static_cast<double>(row.labels.size());
  row.own_purity = purityOf(row.labels, scan);
  labelTheRest(*scan.cloud, row.labels);
  row.purity = purityOf(row.labels, scan);
  if (!row.measured.seeds.empty()) {
    row.labels = labelsOfSeeds(row.labels, row.measured.seeds, scan.truth.label);
    row.scores = scoreLabels(row.labels, scan);
  }
  return row;
}

ComparableParts
comparableParts(const PeerScan& scan)
{
  const std::size_t instances = countLabels(scan.truth.label);
  return {std::max<std::size_t>(instances / 2, 1), 5 * instances};
}

std::map<std::size_t, double>
cidCurve(const PeerScan& scan, const SeedSettings& settings)
{
  const ComparableParts comparable = comparableParts(scan);
  std::set<std::size_t> parts;
  for (std::size_t n = comparable.least; n <= comparable.most; ++n)
    parts.insert(n);
  return purityOfCID(scan, settings, parts);
}

void
compareWithCID(const PeerScan& scan,
               const SeedSettings& settings,
               std::vector<PeerRow>& rows)
{
  const ComparableParts comparable = comparableParts(scan);
  std::set<std::size_t> parts;
  for (const PeerRow& row : rows)
    if (row.hasSeeds() || comparable.contains(row.parts))
      parts.insert(row.parts);
  const std::map<std::size_t, double> purity = purityOfCID(scan, settings, parts);
  std::map<std::string, PeerRow*> best;
  for (PeerRow& row : rows) {
    if (row.hasSeeds() || comparable.contains(row.parts))
      row.cid_purity = purity.at(row.parts);
    if (row.hasSeeds() || !row.cid_purity)
      continue;
    PeerRow*& so_far = best[row.run.method];
    if (so_far == nullptr || row.margin() > so_far->margin())
      so_far = &row;
  }
  for (const auto& [method, row] : best)
    row->is_best = true;
}

} // namespace pcl_cid::benchmarks
