/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Purity, and how well the instances of a scan are found.
 */

#include "peer_scores.h"

#include <set>

namespace pcl_cid::benchmarks {
namespace {

Evaluation
evaluateBy(EvaluationProtocol protocol,
           const std::vector<std::uint32_t>& labels,
           const PeerScan& scan)
{
  std::set<std::uint32_t> classes(scan.truth.semantic.begin(),
                                  scan.truth.semantic.end());
  classes.erase(0);
  return evaluate({overlapsOf({labels, {}}, scan.truth)},
                  protocol,
                  {classes.begin(), classes.end()});
}

} // namespace

std::size_t
countLabels(const std::vector<std::uint32_t>& labels)
{
  std::set<std::uint32_t> different(labels.begin(), labels.end());
  different.erase(0);
  return different.size();
}

double
purityOf(const std::vector<std::uint32_t>& group, const PeerScan& scan)
{
  // The purity is the same by each protocol; this one lets groups have any number.
  return evaluateBy(EvaluationProtocol::s3dis, group, scan).purity;
}

std::vector<std::uint32_t>
labelsOfSeeds(const std::vector<std::uint32_t>& group,
              const pcl::Indices& seeds,
              const std::vector<std::uint32_t>& instance)
{
  std::vector<std::uint32_t> labels;
  for (const std::uint32_t number : group)
    labels.push_back(
        number == 0 ? 0 : instance[static_cast<std::size_t>(seeds[number - 1])]);
  return labels;
}

Evaluation
scoreLabels(const std::vector<std::uint32_t>& labels, const PeerScan& scan)
{
  return evaluateBy(EvaluationProtocol::paper, labels, scan);
}

} // namespace pcl_cid::benchmarks
