/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What tools made for ScanNet read: superpoints, and predictions for its benchmark.
 */

#include "text/numbers.h"

#include <pcl_cid/io/scannet_export.h>

#include <algorithm>
#include <map>
#include <ostream>

#include <nlohmann/json.hpp>

namespace pcl_cid {

void
writeSuperpoints(std::ostream& stream,
                 const std::string& scan_id,
                 const pcl::Indices& group)
{
  const auto last = std::max_element(group.begin(), group.end());
  const pcl::index_t none = last == group.end() ? 0 : *last + 1;
  std::vector<std::uint32_t> segments;
  segments.reserve(group.size());
  for (const pcl::index_t of_point : group)
    segments.push_back(static_cast<std::uint32_t>(of_point < 0 ? none : of_point));
  writeSegments(stream, scan_id, segments);
}

void
writeSegments(std::ostream& stream,
              const std::string& scan_id,
              const std::vector<std::uint32_t>& segments)
{
  nlohmann::ordered_json json;
  json["params"] = {{"method", "pcl_cid"}};
  json["sceneId"] = scan_id;
  json["segIndices"] = segments;
  stream << json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
}

std::vector<PredictedInstance>
instancesWithTrueClass(const std::vector<std::uint32_t>& labels,
                       const std::vector<std::uint32_t>& true_labels,
                       const std::vector<std::uint32_t>& true_classes)
{
  const InstanceOverlaps scan = overlapsOf({labels, {}}, {true_labels, true_classes});
  std::map<std::uint32_t, std::uint32_t> class_of;
  for (const Instance& truth : scan.truths)
    class_of[truth.label] = truth.semantic;
  std::vector<PredictedInstance> instances = scan.predictions;
  for (PredictedInstance& instance : instances)
    instance.semantic = class_of[instance.label];
  return instances;
}

std::string
maskFileName(const std::string& scan_id, std::size_t number)
{
  constexpr std::size_t digits = 3;
  const std::string text = std::to_string(number);
  return scan_id + "_" + std::string(digits - std::min(digits, text.size()), '0') +
         text + ".txt";
}

bool
isMaskFileName(const std::string& name, const std::string& scan_id)
{
  const std::size_t begin = scan_id.size() + 1;
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || begin >= dot)
    return false;
  const auto number = parseNumber<std::size_t>(name.substr(begin, dot - begin));
  return number && name == maskFileName(scan_id, *number);
}

void
writePredictions(std::ostream& stream,
                 const std::string& scan_id,
                 const std::vector<PredictedInstance>& instances)
{
  for (std::size_t i = 0; i < instances.size(); ++i)
    stream << mask_folder << '/' << maskFileName(scan_id, i) << ' '
           << instances[i].semantic << ' ' << instances[i].confidence << '\n';
}

void
writeMask(std::ostream& stream,
          const std::vector<std::uint32_t>& labels,
          std::uint32_t label)
{
  std::string mask;
  mask.reserve(2 * labels.size());
  for (const std::uint32_t of_point : labels)
    mask += of_point == label ? "1\n" : "0\n";
  stream << mask;
}

} // namespace pcl_cid
