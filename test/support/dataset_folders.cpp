/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A generated room in the published layouts of S3DIS and ScanNet.
 */

#include "dataset_folders.h"

#include "cloud_files.h"
#include "even_sampler.h"

#include <cstdio>
#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/** What an annotator of ScanNet calls a thing, and its class there. */
struct Category {
  std::string room_class;
  std::string raw;
  std::uint32_t nyu40;
};

const std::vector<Category>&
categories()
{
  static const std::vector<Category> list{{"ceiling", "ceiling", 22},
                                          {"floor", "floor", 2},
                                          {"wall", "wall", 1},
                                          {"beam", "beam", 38},
                                          {"column", "pillar", 38},
                                          {"window", "window", 9},
                                          {"door", "doorframe", 8},
                                          {"table", "coffee table", 7},
                                          {"chair", "office chair", 5},
                                          {"sofa", "couch", 6},
                                          {"bookcase", "bookshelf", 10},
                                          {"board", "whiteboard", 30},
                                          {"clutter", "object", 40}};
  return list;
}

const Category&
categoryOf(const std::string& room_class)
{
  for (const Category& category : categories())
    if (category.room_class == room_class)
      return category;
  throw std::runtime_error("no class " + room_class);
}

/** Any color, another one for each instance. */
std::uint8_t
color(std::uint32_t instance, std::uint32_t channel)
{
  return static_cast<std::uint8_t>(instance * (37 + 30 * channel) % 256);
}

std::string
s3disLine(const LabelledScan& scan, std::size_t i)
{
  const Eigen::Vector3f& p = scan.points[i];
  const std::uint32_t instance = scan.instance[i];
  char line[96];
  std::snprintf(line,
                sizeof(line),
                "%.3f %.3f %.3f %d %d %d\n",
                static_cast<double>(p.x()),
                static_cast<double>(p.y()),
                static_cast<double>(p.z()),
                color(instance, 0),
                color(instance, 1),
                color(instance, 2));
  return line;
}

/** `chair_2.txt` for the second chair. */
std::map<std::uint32_t, std::string>
annotationNames(const LabelledScan& scan)
{
  std::map<std::uint32_t, std::string> class_of;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    class_of[scan.instance[i]] = scan.class_names[scan.semantic[i]];
  std::map<std::string, int> count;
  std::map<std::uint32_t, std::string> names;
  for (const auto& [instance, name] : class_of)
    names[instance] = name + "_" + std::to_string(++count[name]) + ".txt";
  return names;
}

template <typename Value>
void
appendBytes(Value value, std::string& bytes)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/** As ScanNet's meshes: colors with alpha, and triangles, which any three vertices
 * will do for. */
std::string
mesh(const LabelledScan& scan)
{
  const std::size_t triangles = scan.points.size() / 3;
  std::string ply = "ply\nformat binary_little_endian 1.0\ncomment MLIB generated\n"
                    "element vertex " +
                    std::to_string(scan.points.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\n"
                    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                    "property uchar alpha\nelement face " +
                    std::to_string(triangles) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      appendBytes(scan.points[i][axis], ply);
    for (std::uint32_t channel = 0; channel < 3; ++channel)
      appendBytes(color(scan.instance[i], channel), ply);
    appendBytes(std::uint8_t{255}, ply);
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    appendBytes(std::uint8_t{3}, ply);
    for (std::size_t corner = 0; corner < 3; ++corner)
      appendBytes(static_cast<std::int32_t>(3 * i + corner), ply);
  }
  return ply;
}

/** Three segments an instance: no segment lies on two of them. */
std::vector<std::size_t>
segmentOfVertices(const LabelledScan& scan)
{
  std::map<std::pair<std::uint32_t, int>, std::size_t> first;
  std::vector<std::size_t> segments;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const int third = static_cast<int>(scan.points[i].z() * 4.0f) % 3;
    segments.push_back(
        first.emplace(std::pair(scan.instance[i], third), i).first->second);
  }
  return segments;
}

Json
segmentGroups(const LabelledScan& scan,
              const std::vector<std::size_t>& segments,
              std::uint32_t bare_instance)
{
  std::map<std::uint32_t, Json> groups;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::uint32_t instance = scan.instance[i];
    if (instance == bare_instance)
      continue;
    Json& group = groups[instance];
    group["id"] = instance - 1;
    group["objectId"] = instance - 1;
    group["label"] = categoryOf(scan.class_names[scan.semantic[i]]).raw;
    if (segments[i] == i) // the first vertex of its segment
      group["segments"].push_back(i);
  }
  Json list = Json::array();
  for (const auto& group : groups)
    list.push_back(group.second);
  return list;
}

/** The first columns of ScanNet's table. */
std::string
classTable()
{
  std::string table = "id\traw_category\tcategory\tcount\tnyu40id\teigen13id\n";
  std::size_t id = 0;
  for (const Category& category : categories())
    table += std::to_string(++id) + "\t" + category.raw + "\t" + category.room_class +
             "\t1\t" + std::to_string(category.nyu40) + "\t\n";
  return table;
}

} // namespace

LabelledScan
smallRoomScan(std::size_t points)
{
  RoomOptions options;
  options.seed = 3;
  options.clutter = 4;
  options.chairs = 11; // so that there is a chair_10
  return sampleRoomEvenly(makeRoom(options), points, 3);
}

std::string
writeS3DISRoom(const std::string& folder, const LabelledScan& scan)
{
  const std::string room = folder + "/Area_1/office_1";
  fs::create_directories(room + "/Annotations");
  std::map<std::uint32_t, std::string> annotations;
  std::string all;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    all += s3disLine(scan, i);
    annotations[scan.instance[i]] += s3disLine(scan, i);
  }
  writeText(room + "/office_1.txt", all);
  for (const auto& [instance, name] : annotationNames(scan))
    writeText(room + "/Annotations/" + name, annotations[instance]);
  return room;
}

std::string
writeScannetScan(const std::string& folder,
                 const LabelledScan& scan,
                 std::uint32_t bare_instance)
{
  const std::string id = "scene0000_00";
  const std::string scan_folder = folder + "/scans/" + id;
  fs::create_directories(scan_folder);
  const std::string beginning = scan_folder + "/" + id;
  const std::vector<std::size_t> segments = segmentOfVertices(scan);
  writeText(beginning + "_vh_clean_2.ply", mesh(scan));
  writeText(beginning + "_vh_clean_2.0.010000.segs.json",
            Json{{"params", {{"kThresh", "0.0001"}, {"segMinVerts", "20"}}},
                 {"sceneId", id},
                 {"segIndices", segments}}
                .dump());
  writeText(beginning + ".aggregation.json",
            Json{{"sceneId", "scannet." + id},
                 {"appId", "Aggregator.v2"},
                 {"segGroups", segmentGroups(scan, segments, bare_instance)},
                 {"segmentsFile", "scannet." + id + "_vh_clean_2.0.010000.segs.json"}}
                .dump());
  writeText(folder + "/scannetv2-labels.combined.tsv", classTable());
  return scan_folder;
}

std::uint32_t
nyu40Of(const std::string& room_class)
{
  return categoryOf(room_class).nyu40;
}

} // namespace pcl_cid::test
