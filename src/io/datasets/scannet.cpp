/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans of the dataset ScanNet, with their instances and classes.
 */

#include "base/sentence.h"
#include "ply/ply_format.h"
#include "scannet_classes.h"
#include "scannet_names.h"
#include "text/json_reading.h"
#include "text/numbers.h"

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/scannet.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <unordered_map>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Remark = RemarkCallback;

constexpr const char* class_table_name = "scannetv2-labels.combined.tsv";

/** The ids of the scans whose meshes are in a folder. */
std::set<std::string>
idsIn(const std::string& folder)
{
  const std::string ending = scannet_mesh_ending;
  std::set<std::string> ids;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > ending.size() && name[0] != '.' &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
      ids.insert(name.substr(0, name.size() - ending.size()));
  }
  return ids;
}

std::string
fileOrNothing(const fs::path& path)
{
  std::error_code error;
  return fs::exists(path, error) ? path.string() : std::string();
}

/** The folder and all folders above it. */
std::vector<fs::path>
foldersFrom(const std::string& folder)
{
  std::vector<fs::path> folders;
  for (fs::path path = fs::absolute(fs::path(folder) / "").lexically_normal();
       path.has_relative_path();) {
    path = path.parent_path();
    folders.push_back(path);
  }
  return folders;
}

std::string
findClassTable(const std::string& folder)
{
  for (const fs::path& place : foldersFrom(folder))
    if (const std::string path = fileOrNothing(place / class_table_name); !path.empty())
      return path;
  return "";
}

/** What a segment belongs to. */
struct Owner {
  std::uint32_t instance = 0;
  std::uint32_t semantic = 0;
};

/** The annotation of one scan; each member function is one part of reading it. */
class AnnotationReading {
public:
  AnnotationReading(const ScannetFiles& files, const Remark& remark)
  : files_(files), remark_(remark)
  {
  }

  void
  read(LabelledCloud& cloud)
  {
    readSegments(cloud.size());
    readGroups();
    std::vector<std::uint32_t> labels;
    std::vector<std::uint32_t> classes;
    for (const std::uint32_t segment : segments_) {
      const auto found = owners_.find(segment);
      const Owner owner = found == owners_.end() ? Owner() : found->second;
      labels.push_back(owner.instance);
      classes.push_back(owner.semantic);
    }
    setLabels(labels, LabelType::U4, cloud);
    setLabels(classes, LabelType::U4, cloud, "semantic");
  }

private:
  void
  readSegments(std::size_t vertices)
  {
    const JsonReading json(files_.segments);
    const Json& indices = json.array(json.root(), "", "segIndices");
    if (indices.size() != vertices)
      json.fail("segIndices",
                sentence("has ",
                         countOf(indices.size(), "value"),
                         ", but ",
                         files_.mesh,
                         " has ",
                         vertices,
                         " vertices; there must be one for each"));
    for (std::size_t i = 0; i < indices.size(); ++i)
      segments_.push_back(
          json.wholeNumber(indices[i], "segIndices[" + std::to_string(i) + "]"));
  }

  static std::string
  placeOf(std::size_t group)
  {
    return "segGroups[" + std::to_string(group) + "]";
  }

  void
  readGroups()
  {
    const auto classes = readScannetClasses(files_.class_table);
    const JsonReading json(files_.aggregation);
    const Json& groups = json.array(json.root(), "", "segGroups");
    std::set<std::string> unknown;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const std::string label = json.text(groups[i], placeOf(i), "label");
      const auto found = classes.find(label);
      if (found == classes.end())
        unknown.insert(label);
      else
        takeGroup(json, groups, i, found->second);
    }
    requireKnown(unknown);
    remarkOnSegments();
  }

  void
  takeGroup(const JsonReading& json,
            const Json& groups,
            std::size_t i,
            std::uint32_t semantic)
  {
    const Json& group = groups[i];
    const std::string where = placeOf(i);
    const std::string id_place = where + ".objectId";
    const std::uint32_t id =
        json.wholeNumber(json.member(group, where, "objectId"), id_place);
    const Json& segments = json.array(group, where, "segments");
    const auto [known_id, is_new] = group_of_id_.try_emplace(id, i);
    if (!is_new) {
      const Json& earlier = groups[known_id->second];
      if (segments != earlier["segments"] || group["label"] != earlier["label"])
        json.fail(id_place,
                  sentence("is ",
                           id,
                           ", as that of ",
                           placeOf(known_id->second),
                           ", which has another label or other segments; each group "
                           "must have its own"));
      ++repeated_groups_;
    }
    const Owner owner{id + 1, semantic};
    for (const Json& segment : segments) {
      Owner& known = owners_[json.wholeNumber(segment, where + ".segments[]")];
      shared_segments_ +=
          known.instance != 0 && known.instance != owner.instance ? 1 : 0;
      known = owner;
    }
  }

  void
  requireKnown(const std::set<std::string>& unknown) const
  {
    if (unknown.empty())
      return;
    std::string names;
    for (const std::string& name : unknown)
      names += (names.empty() ? "'" : ", '") + name + "'";
    throw CIDException(files_.class_table + ": has no row for " + names +
                       ", which stand in " + files_.aggregation +
                       "; every label must be a raw_category");
  }

  void
  remarkOnSegments() const
  {
    if (!remark_)
      return;
    if (shared_segments_ > 0)
      remark_(sentence(files_.aggregation,
                       ": ",
                       countOf(shared_segments_, "segment"),
                       " of a group stood in an earlier one, too; the later one has "
                       "them"));
    if (repeated_groups_ > 0)
      remark_(sentence(files_.aggregation,
                       ": ",
                       countOf(repeated_groups_, "group"),
                       " stood there before, with the same objectId, label and "
                       "segments, and counted once"));
    const std::set<std::uint32_t> used(segments_.begin(), segments_.end());
    std::size_t missing = 0;
    for (const auto& owner : owners_)
      missing += used.count(owner.first) == 0 ? 1 : 0;
    if (missing > 0)
      remark_(sentence(files_.aggregation,
                       ": ",
                       countOf(missing, "segment"),
                       " of its groups have no vertex in ",
                       files_.segments));
  }

  const ScannetFiles& files_;
  const Remark& remark_;
  std::vector<std::uint32_t> segments_; ///< of each vertex
  std::unordered_map<std::uint32_t, Owner> owners_;
  std::size_t shared_segments_ = 0;
  std::unordered_map<std::uint32_t, std::size_t> group_of_id_; ///< the first one
  std::size_t repeated_groups_ = 0;
};

/** Refuse an annotation of which a file is missing. */
void
requireComplete(const ScannetFiles& files, const std::string& folder)
{
  const auto require = [&](const std::string& found, const char* ending) {
    if (found.empty())
      throw CIDException(folder + ": has no " + files.id + ending +
                         "; an annotated scan needs " + files.id +
                         scannet_segments_ending + " and " + files.id +
                         scannet_aggregation_ending);
  };
  require(files.segments, scannet_segments_ending);
  require(files.aggregation, scannet_aggregation_ending);
  if (!files.class_table.empty())
    return;
  std::string places;
  for (const fs::path& place : foldersFrom(folder))
    places += (places.empty() ? "" : ", ") + place.string();
  throw CIDException(folder + ": there is no " + class_table_name +
                     "; it was looked for in " + places);
}

} // namespace

std::vector<std::string>
ScannetFiles::all() const
{
  std::vector<std::string> paths;
  for (const std::string& path : {mesh, segments, aggregation, class_table})
    if (!path.empty())
      paths.push_back(path);
  return paths;
}

bool
isScannetScan(const std::string& path)
{
  return !idsIn(path).empty();
}

ScannetFiles
findScannetFiles(const std::string& folder, const std::string& class_table)
{
  const std::set<std::string> ids = idsIn(folder);
  if (ids.size() != 1)
    throw CIDException(sentence(folder,
                                ": holds ",
                                countOf(ids.size(), "file"),
                                " named <id>",
                                scannet_mesh_ending,
                                "; a scan must hold 1"));
  ScannetFiles files;
  files.id = *ids.begin();
  const fs::path beginning = fs::path(folder) / files.id;
  files.mesh = beginning.string() + scannet_mesh_ending;
  files.segments = fileOrNothing(beginning.string() + scannet_segments_ending);
  files.aggregation = fileOrNothing(beginning.string() + scannet_aggregation_ending);
  files.class_table = class_table.empty() ? findClassTable(folder) : class_table;
  return files;
}

LabelledCloud
readScannetScan(const std::string& folder,
                const std::string& class_table,
                const RemarkCallback& remark)
{
  const ScannetFiles files = findScannetFiles(folder, class_table);
  LabelledCloud cloud = readCloud(files.mesh);
  // ScanNet annotates the vertices: here they are the points.
  cloud.remarks.erase(
      std::remove(cloud.remarks.begin(), cloud.remarks.end(), ply_is_mesh),
      cloud.remarks.end());
  cloud.name = folder;
  cloud.layout = CloudLayout();
  if (files.segments.empty() && files.aggregation.empty()) {
    if (remark)
      remark(folder + ": has no annotation (" + files.id + scannet_segments_ending +
             " and " + files.id + scannet_aggregation_ending +
             "), so no labels and classes");
    return cloud;
  }
  requireComplete(files, folder);
  AnnotationReading(files, remark).read(cloud);
  return cloud;
}

} // namespace pcl_cid
