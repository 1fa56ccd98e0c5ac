/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labelled scans as annotations and predictions of ScanNet.
 */

#include "base/sentence.h"
#include "instance_points.h"
#include "near_names.h"
#include "scannet_classes.h"
#include "scannet_names.h"
#include "text/numbers.h"
#include "text/path_names.h"

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/scannet_annotation.h>
#include <pcl_cid/io/scannet_export.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>

#include <nlohmann/json.hpp>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;
using ScannetNumbers = std::map<std::string, std::uint32_t>;

ScannetNumbers
classNumbers(const std::string& class_table)
{
  if (!class_table.empty())
    return readScannetClasses(class_table);
  ScannetNumbers numbers;
  for (const SemanticClass& each : nyu40Classes())
    numbers.emplace(each.name, each.number);
  return numbers;
}

/** "'sofaa' (near it: 'sofa')". */
std::string
withNearNames(const std::string& name, const ScannetNumbers& numbers)
{
  std::vector<std::string> names;
  for (const auto& known : numbers)
    names.push_back(known.first);
  std::vector<std::string> nearest = nearNames(name, names);
  for (std::string& each : nearest)
    each = "'" + each + "'";
  return "'" + name + "'" +
         (nearest.empty() ? "" : " (near it: " + listed(nearest, "and") + ")");
}

/** Their tools fail at a class that they do not have: better to say so here. */
void
requireKnownClasses(const std::vector<InstancePoints>& instances,
                    const ScannetNumbers& numbers,
                    const std::string& class_table)
{
  std::set<std::string> unknown;
  for (const InstancePoints& each : instances)
    if (numbers.count(each.instance.class_name) == 0)
      unknown.insert(each.instance.class_name);
  if (unknown.empty())
    return;
  std::vector<std::string> names;
  for (const std::string& name : unknown)
    names.push_back(withNearNames(name, numbers));
  const std::string every_class = "; the class of every instance must be ";
  throw CIDException(class_table.empty()
                         ? "ScanNet has no class " + listed(names) + every_class +
                               "one of the 40 of NYUv2, such as 'wall'"
                         : class_table + ": has no class " + listed(names) +
                               every_class + "a raw_category");
}

/** The segments of an instance, each once. */
std::vector<std::uint32_t>
segmentsOf(const InstancePoints& instance, const std::vector<std::uint32_t>& segments)
{
  std::set<std::uint32_t> own;
  for (const std::size_t point : instance.points)
    own.insert(segments[point]);
  return {own.begin(), own.end()};
}

/** Keys and their order: README.md of ScanNet/ScanNet, "Data Formats". */
OrderedJson
aggregationOf(const std::vector<InstancePoints>& instances,
              const std::vector<std::uint32_t>& segments,
              const std::string& scan_id)
{
  OrderedJson groups = OrderedJson::array();
  for (const InstancePoints& each : instances) {
    const std::size_t id = groups.size();
    OrderedJson group;
    group["id"] = id;
    group["objectId"] = id;
    group["segments"] = segmentsOf(each, segments);
    group["label"] = each.instance.class_name;
    groups.push_back(std::move(group));
  }
  OrderedJson json;
  json["sceneId"] = "scannet." + scan_id;
  json["appId"] = "pcl_cid";
  json["segGroups"] = std::move(groups);
  json["segmentsFile"] = "scannet." + scan_id + scannet_segments_ending;
  return json;
}

std::string
maskPath(const std::string& folder, const std::string& name = "")
{
  return (fs::path(folder) / mask_folder / name).string();
}

std::string
listPath(const std::string& folder, const std::string& scan_id)
{
  return (fs::path(folder) / (scan_id + ".txt")).string();
}

void
announceOldMasks(const std::string& folder,
                 const std::string& scan_id,
                 OutputFiles& outputs)
{
  for (const fs::directory_entry& entry : fs::directory_iterator(maskPath(folder)))
    if (isMaskFileName(entry.path().filename().string(), scan_id))
      outputs.announceRemoval(entry.path().string());
}

} // namespace

std::vector<std::uint32_t>
segmentsOfLabels(const pcl::Indices& group, const std::vector<std::uint32_t>& label)
{
  if (!group.empty() && group.size() != label.size())
    throw CIDException(sentence("there are ",
                                countOf(group.size(), "group"),
                                " for ",
                                countOf(label.size(), "label"),
                                "; each point must have one of each"));
  std::map<std::pair<pcl::index_t, std::uint32_t>, std::uint32_t> number;
  std::vector<std::uint32_t> segments;
  segments.reserve(label.size());
  for (std::size_t i = 0; i < label.size(); ++i) {
    const pcl::index_t of_point = group.empty() ? 0 : group[i];
    const auto next = static_cast<std::uint32_t>(number.size());
    segments.push_back(number.try_emplace({of_point, label[i]}, next).first->second);
  }
  return segments;
}

void
writeScannetAnnotation(const LabelledInstances& scan,
                       const pcl::Indices& group,
                       const ScannetPlace& place,
                       OutputFiles& outputs)
{
  const fs::path beginning = fs::path(place.folder) / place.id;
  const std::string segments_path = beginning.string() + scannet_segments_ending;
  const std::string aggregation_path = beginning.string() + scannet_aggregation_ending;
  requireConsistent(scan, scan.label.size(), aggregation_path);
  const std::vector<InstancePoints> instances = pointsOfInstances(scan);
  requireKnownClasses(instances, classNumbers(place.class_table), place.class_table);
  const std::vector<std::uint32_t> segments = segmentsOfLabels(group, scan.label);
  outputs.announce(segments_path);
  outputs.announce(aggregation_path);
  outputs.write(segments_path, [&](std::ostream& stream) {
    writeSegments(stream, place.id, segments);
  });
  outputs.write(aggregation_path, [&](std::ostream& stream) {
    stream << aggregationOf(instances, segments, place.id).dump() << "\n";
  });
}

std::vector<PredictedInstance>
scannetInstances(const LabelledInstances& scan, const std::string& class_table)
{
  requireConsistent(scan, scan.label.size(), "the labels");
  const ScannetNumbers numbers = classNumbers(class_table);
  const std::vector<InstancePoints> instances = pointsOfInstances(scan);
  requireKnownClasses(instances, numbers, class_table);
  std::vector<PredictedInstance> predicted;
  for (const InstancePoints& each : instances)
    predicted.push_back({{each.instance.label,
                          numbers.at(each.instance.class_name),
                          each.points.size()},
                         1.0});
  return predicted;
}

std::vector<PredictedInstance>
ofBenchmarkClasses(std::vector<PredictedInstance> instances)
{
  const auto isNot = [](const PredictedInstance& instance) {
    return !className(scannetBenchmarkClasses(), instance.semantic);
  };
  instances.erase(std::remove_if(instances.begin(), instances.end(), isNot),
                  instances.end());
  return instances;
}

void
announceScannetSubmission(const std::string& folder,
                          const std::string& scan_id,
                          OutputFiles& outputs)
{
  outputs.announceFolder(folder);
  outputs.announceFolder((fs::path(folder) / mask_folder).string());
  outputs.announce(listPath(folder, scan_id));
}

void
writeScannetSubmission(const std::string& folder,
                       const std::string& scan_id,
                       const std::vector<std::uint32_t>& label,
                       const std::vector<PredictedInstance>& instances,
                       OutputFiles& outputs)
{
  announceOldMasks(folder, scan_id, outputs);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const std::string path = maskPath(folder, maskFileName(scan_id, i));
    outputs.announce(path);
    outputs.write(path, [&](std::ostream& stream) {
      writeMask(stream, label, instances[i].label);
    });
  }
  outputs.write(listPath(folder, scan_id), [&](std::ostream& stream) {
    writePredictions(stream, scan_id, instances);
  });
}

} // namespace pcl_cid
