/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scan after scan is read, reduced to its overlaps, and scored.
 */

#include "scoring.h"

#include <pcl_cid/exceptions.h>

#include <utility>

namespace pcl_cid::tools {
namespace {

std::vector<std::uint32_t>
numbersOf(const SemanticClasses& classes)
{
  std::vector<std::uint32_t> numbers;
  for (const SemanticClass& each : classes)
    numbers.push_back(each.number);
  return numbers;
}

/** "3400 points, 12 truth instances, 30 groups". */
std::string
sizesOf(const ScoredScan& scan)
{
  return std::to_string(scan.points) + " points, " +
         std::to_string(scan.evaluation.truths) + " truth instances, " +
         std::to_string(scan.evaluation.groups) + " groups";
}

} // namespace

Scoring::Scoring(const EvaluateSettings& settings, Console& console)
: settings_(settings)
, console_(console)
, table_(classTable(settings.classesOrDefault()))
{
  report_.prediction = settings.prediction;
  report_.truth = settings.truth;
  report_.protocol = settings.protocol;
}

void
Scoring::add(const ScanPair& pair)
{
  console_.begin("Scoring " + pair.name);
  ComparedScan scan = compareScans(
      pair, settings_.class_table, settings_.fields, table_.known, report_.protocol);
  for (const std::string& remark : scan.remarks)
    console_.remark(remark);
  settleClasses(pair, scan);
  report_.scans.push_back(
      {pair, scan.points, scan.class_rule, scan.remarks, evaluateScan(pair, scan)});
  overlaps_.push_back(std::move(scan.overlaps));
  console_.end(sizesOf(report_.scans.back()));
}

const EvaluationReport&
Scoring::finish()
{
  if (report_.scans.empty())
    throw CIDException("none of the " + std::to_string(report_.failed.size()) +
                       " scans could be scored");
  report_.pooled =
      evaluate(overlaps_, report_.protocol, numbersOf(report_.classes.scored));
  return report_;
}

/** The first scan says whether there are classes; the others must agree. */
void
Scoring::settleClasses(const ScanPair& pair, const ComparedScan& scan)
{
  const std::string field = pair.truth + ": has " + (scan.has_classes ? "a" : "no") +
                            " field '" + settings_.fields.semantic + "'";
  if (!scan.has_classes && !settings_.classes.empty())
    throw CIDException(field + ", which --classes is about");
  if (!report_.scans.empty() && has_classes_ != scan.has_classes)
    throw CIDException(field + ", unlike the scans before it");
  has_classes_ = scan.has_classes;
  report_.classes = has_classes_ ? table_ : oneClass();
}

Evaluation
Scoring::evaluateScan(const ScanPair& pair, const ComparedScan& scan) const
{
  try {
    return evaluate(
        {scan.overlaps}, report_.protocol, numbersOf(report_.classes.scored));
  }
  catch (const CIDException& error) {
    throw CIDException(pair.prediction + ": " + error.what() +
                       " (the other protocols take any labels)");
  }
}

} // namespace pcl_cid::tools
