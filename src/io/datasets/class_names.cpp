/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the numbers of a field `semantic` mean.
 */

#include <pcl_cid/io/class_names.h>

#include <algorithm>

namespace pcl_cid {
namespace {

/** Numbered from 1. */
SemanticClasses
numbered(const std::vector<std::string>& names)
{
  SemanticClasses classes;
  for (const std::string& name : names)
    classes.push_back({static_cast<std::uint32_t>(classes.size() + 1), name});
  return classes;
}

/** Those of these numbers. */
SemanticClasses
selected(const SemanticClasses& classes, const std::vector<std::uint32_t>& numbers)
{
  SemanticClasses selection;
  for (const SemanticClass& each : classes)
    if (std::find(numbers.begin(), numbers.end(), each.number) != numbers.end())
      selection.push_back(each);
  return selection;
}

} // namespace

const SemanticClasses&
s3disClasses()
{
  static const SemanticClasses classes = numbered({"ceiling",
                                                   "floor",
                                                   "wall",
                                                   "beam",
                                                   "column",
                                                   "window",
                                                   "door",
                                                   "table",
                                                   "chair",
                                                   "sofa",
                                                   "bookcase",
                                                   "board",
                                                   "clutter"});
  return classes;
}

const SemanticClasses&
nyu40Classes()
{
  static const SemanticClasses classes =
      numbered({"wall",       "floor",          "cabinet",        "bed",
                "chair",      "sofa",           "table",          "door",
                "window",     "bookshelf",      "picture",        "counter",
                "blinds",     "desk",           "shelves",        "curtain",
                "dresser",    "pillow",         "mirror",         "floor mat",
                "clothes",    "ceiling",        "books",          "refrigerator",
                "television", "paper",          "towel",          "shower curtain",
                "box",        "whiteboard",     "person",         "nightstand",
                "toilet",     "sink",           "lamp",           "bathtub",
                "bag",        "otherstructure", "otherfurniture", "otherprop"});
  return classes;
}

const SemanticClasses&
scannetBenchmarkClasses()
{
  // ScanNet/ScanNet, BenchmarkScripts/3d_evaluation/evaluate_semantic_instance.py
  static const SemanticClasses classes =
      selected(nyu40Classes(),
               {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 24, 28, 33, 34, 36, 39});
  return classes;
}

const SemanticClasses&
semanticKittiClasses()
{
  // PRBonn/semantic-kitti-api, config/semantic-kitti.yaml, `labels`
  static const SemanticClasses classes = {{1, "outlier"},
                                          {10, "car"},
                                          {11, "bicycle"},
                                          {13, "bus"},
                                          {15, "motorcycle"},
                                          {16, "on-rails"},
                                          {18, "truck"},
                                          {20, "other-vehicle"},
                                          {30, "person"},
                                          {31, "bicyclist"},
                                          {32, "motorcyclist"},
                                          {40, "road"},
                                          {44, "parking"},
                                          {48, "sidewalk"},
                                          {49, "other-ground"},
                                          {50, "building"},
                                          {51, "fence"},
                                          {52, "other-structure"},
                                          {60, "lane-marking"},
                                          {70, "vegetation"},
                                          {71, "trunk"},
                                          {72, "terrain"},
                                          {80, "pole"},
                                          {81, "traffic-sign"},
                                          {99, "other-object"},
                                          {252, "moving-car"},
                                          {253, "moving-bicyclist"},
                                          {254, "moving-person"},
                                          {255, "moving-motorcyclist"},
                                          {256, "moving-on-rails"},
                                          {257, "moving-bus"},
                                          {258, "moving-truck"},
                                          {259, "moving-other-vehicle"}};
  return classes;
}

std::optional<std::uint32_t>
classNumber(const SemanticClasses& classes, const std::string& name)
{
  for (const SemanticClass& each : classes)
    if (each.name == name)
      return each.number;
  return std::nullopt;
}

std::optional<std::string>
className(const SemanticClasses& classes, std::uint32_t number)
{
  for (const SemanticClass& each : classes)
    if (each.number == number)
      return each.name;
  return std::nullopt;
}

} // namespace pcl_cid
