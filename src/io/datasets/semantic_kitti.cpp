/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels of a scan as SemanticKITTI has them.
 */

#include "base/sentence.h"
#include "instance_points.h"
#include "text/binary_writing.h"
#include "text/path_names.h"

#include <pcl_cid/io/semantic_kitti.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>

#include <nlohmann/json.hpp>

namespace pcl_cid {
namespace {

constexpr std::uint32_t largest = 0xFFFF; // instance or class
constexpr const char* unlabeled = "unlabeled";

/** The numbers of classes, those that the table does not have too. */
class ClassNumbers {
public:
  ClassNumbers(const SemanticClasses& classes,
               const std::vector<InstancePoints>& instances)
  : number_of_{{"", 0}, {unlabeled, 0}}
  {
    std::uint32_t last = 0;
    for (const SemanticClass& each : classes) {
      number_of_.emplace(each.name, each.number);
      last = std::max(last, each.number);
    }
    std::set<std::string> others;
    for (const InstancePoints& each : instances)
      if (number_of_.count(each.instance.class_name) == 0)
        others.insert(each.instance.class_name);
    for (const std::string& other : others)
      number_of_.emplace(other, ++last);
  }

  std::uint32_t
  of(const InstancePoints& instance) const
  {
    return number_of_.at(instance.instance.class_name);
  }

  /** By number; the class that is none has but one name. */
  SemanticClasses
  all() const
  {
    SemanticClasses list;
    for (const auto& [name, number] : number_of_)
      if (!name.empty())
        list.push_back({number, name});
    std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
      return a.number < b.number;
    });
    return list;
  }

private:
  std::map<std::string, std::uint32_t> number_of_;
};

void
requireFits(const std::vector<InstancePoints>& instances,
            const ClassNumbers& classes,
            const std::string& path)
{
  if (instances.size() > largest)
    throw CIDException(sentence(path,
                                ": the scan has ",
                                instances.size(),
                                " instances; a .label holds at most ",
                                largest));
  for (const SemanticClass& each : classes.all())
    if (each.number > largest)
      throw CIDException(sentence(path,
                                  ": the class '",
                                  each.name,
                                  "' has the number ",
                                  each.number,
                                  "; a .label holds at most ",
                                  largest));
}

/** Text in quotes, as JSON and YAML have it; bytes that are no UTF-8 are replaced. */
std::string
quoted(const std::string& text)
{
  using Json = nlohmann::json;
  // JSON escapes what is beyond 16 bits as two halves, which YAML would not join.
  const bool has_long_letters = std::any_of(
      text.begin(), text.end(), [](unsigned char byte) { return byte >= 0xF0; });
  return Json(text).dump(-1, ' ', !has_long_letters, Json::error_handler_t::replace);
}

void
writeClasses(std::ostream& stream,
             const std::vector<InstancePoints>& instances,
             const ClassNumbers& classes)
{
  stream
      << "# The numbers of the .label: the lower 16 bits are of labels, the upper 16 "
         "of instances.\nlabels:\n";
  for (const SemanticClass& each : classes.all())
    stream << "  " << each.number << ": " << quoted(each.name) << "\n";
  stream << (instances.empty() ? "instances: {}\n" : "instances:\n");
  for (std::size_t i = 0; i < instances.size(); ++i)
    stream << "  " << i + 1 << ": {class: " << classes.of(instances[i])
           << ", label: " << instances[i].instance.label
           << ", name: " << quoted(instances[i].instance.name) << "}\n";
}

/** What stands in the file, for each point. */
std::vector<std::uint32_t>
wordsOf(const std::vector<InstancePoints>& instances,
        const ClassNumbers& classes,
        std::size_t points)
{
  std::vector<std::uint32_t> words(points, 0);
  for (std::size_t i = 0; i < instances.size(); ++i)
    for (const std::size_t point : instances[i].points)
      words[point] = static_cast<std::uint32_t>(i + 1) << 16 | classes.of(instances[i]);
  return words;
}

} // namespace

std::string
semanticKittiClassFile(const std::string& label_file)
{
  return std::filesystem::path(label_file).replace_extension(".classes.yaml").string();
}

void
writeSemanticKitti(const LabelledInstances& scan,
                   const SemanticClasses& classes,
                   const std::string& path,
                   OutputFiles& outputs)
{
  if (extensionOf(path) != ".label")
    throw CIDException(path + ": is no name for labels of SemanticKITTI; it must end "
                              "with .label");
  requireConsistent(scan, scan.label.size(), path);
  const std::vector<InstancePoints> instances = pointsOfInstances(scan);
  const ClassNumbers numbers(classes, instances);
  requireFits(instances, numbers, path);
  const std::string class_file = semanticKittiClassFile(path);
  outputs.announce(path);
  outputs.announce(class_file);
  outputs.write(path, [&](std::ostream& stream) {
    for (const std::uint32_t word : wordsOf(instances, numbers, scan.label.size()))
      writeValue(stream, word);
  });
  outputs.write(class_file, [&](std::ostream& stream) {
    writeClasses(stream, instances, numbers);
  });
}

} // namespace pcl_cid
