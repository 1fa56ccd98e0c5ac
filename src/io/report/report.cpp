/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a run did, as JSON.
 */

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/smooth_patches.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/report.h>
#include <pcl_cid/version.h>

#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace pcl_cid {
namespace {

using Json = nlohmann::ordered_json;

Json
valueOf(const Report::Parameter& parameter)
{
  return std::visit(
      [](const auto& value) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
          return nullptr;
        else
          return value;
      },
      parameter.value);
}

Json
parametersOf(const Report& report)
{
  Json parameters = Json::object();
  for (const Report::Parameter& parameter : report.parameters)
    parameters[parameter.name] = valueOf(parameter);
  return parameters;
}

Json
densityOf(const DensityDecision& density)
{
  Json json = {{"weighted", density.weighted}, {"spread", nullptr}};
  if (density.spread > 0.0f)
    json["spread"] = density.spread;
  json["isolated_points"] = density.isolated_points;
  return json;
}

Json
blindSpotOf(const FilledBlindSpot& spot)
{
  return {{"centre", {spot.center.x(), spot.center.y(), spot.center.z()}},
          {"radius", spot.radius},
          {"points", spot.points}};
}

Json
seedsOf(const Report& report)
{
  Json seeds = Json::array();
  for (std::size_t k = 0; k < report.seeds.size(); ++k) {
    const Eigen::Vector3d& p = report.seed_positions[k];
    Json seed = {{"index", report.seeds[k]},
                 {"position", {p.x(), p.y(), p.z()}},
                 {"coverage", report.coverage[k]},
                 {"points", report.group_sizes[k]}};
    if (!report.seed_labels.empty())
      seed["label"] = report.seed_labels[k];
    seeds.push_back(std::move(seed));
  }
  return seeds;
}

Json
patchesOf(const Report& report)
{
  Json patches = Json::array();
  for (std::size_t k = 0; k < report.grown_sizes.size(); ++k)
    patches.push_back(
        {{"points", report.group_sizes[k]}, {"grown", report.grown_sizes[k]}});
  return patches;
}

Json
scoreOf(const LabelScore& score)
{
  return {{"field", score.field},
          {"points", score.points},
          {"right", score.right},
          {"share_right", score.share()},
          {"labelled_points", score.labelled_points},
          {"right_labelled", score.right_labelled},
          {"share_right_labelled", score.shareOfLabelled()}};
}

void
addTightness(const HullTightness& tightness, Json& json)
{
  json["max_concavity"] = tightness.max_concavity;
  json["mean_concavity"] = tightness.mean_concavity;
  json["free_share"] = tightness.free_share;
}

Json
tightnessOf(const Tightness& tightness)
{
  Json json = {{"volume", tightness.volume}, {"free_volume", tightness.free_volume}};
  addTightness(tightness.all, json);
  return json;
}

/** The name of its kind; null where the hull is written. */
Json
primitiveOf(const std::optional<HullPrimitive>& primitive)
{
  return primitive ? Json(nameOf(primitive->kind)) : Json(nullptr);
}

Json
partsOf(const Report& report)
{
  Json list = Json::array();
  for (std::size_t k = 0; k < report.parts->size(); ++k) {
    const ConvexPart& part = (*report.parts)[k];
    Json json = {{"points", part.indices.size()},
                 {"trimmed", part.trimmed},
                 {"vertices", part.hull.vertices.size()},
                 {"triangles", part.hull.triangles.size()},
                 {"volume", part.volume},
                 {"area", part.area},
                 {"thickness", part.thickness},
                 {"thickened", part.thickened},
                 {"boxed", part.boxed}};
    if (!report.followed_parts.empty()) {
      const FollowedPart& followed = report.followed_parts[k];
      json["points"] = followed.points;
      json["voxels"] = part.indices.size();
      json["trimmed"] = followed.trimmed;
      json["trimmed_points"] = followed.trimmed_points;
    }
    if (!report.primitives.empty())
      json["primitive"] = primitiveOf(report.primitives[k]);
    if (report.tightness)
      addTightness(report.tightness->hulls[k], json);
    list.push_back(std::move(json));
  }
  return list;
}

Json
secondsOf(const Report& report)
{
  Json seconds = Json::object();
  for (const Report::Step& step : report.steps)
    seconds[step.name] = step.seconds;
  return seconds;
}

std::uint64_t
peakMemoryBytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024; // Linux counts in KiB
}

/** Sizes of groups, and how many points they have. */
void
countGroups(const std::vector<pcl::index_t>& groups, std::size_t number, Report& report)
{
  report.group_sizes.assign(number, 0);
  report.points_grouped = 0;
  for (const pcl::index_t group : groups) {
    if (group < 0)
      continue;
    ++report.group_sizes[static_cast<std::size_t>(group)];
    ++report.points_grouped;
  }
}

/** Names of files may hold any bytes, JSON only UTF-8. */
std::string
print(const Json& json)
{
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

LabelScore
scoreLabels(const std::string& field,
            const std::vector<std::uint32_t>& labels,
            const std::vector<std::uint32_t>& truth,
            const CloudPoints& points)
{
  LabelScore score;
  score.field = field;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!(*points.points)[i].getVector3fMap().allFinite())
      continue;
    const std::size_t right = labels[i] == truth[i] ? 1 : 0;
    ++score.points;
    score.right += right;
    if (truth[i] == 0)
      continue;
    ++score.labelled_points;
    score.right_labelled += right;
  }
  return score;
}

void
describeProposal(const SeedProposal& proposal,
                 const CloudPoints& points,
                 Report& report)
{
  report.points_in = points.points->size();
  report.points_finite = points.finite;
  report.seeds.clear();
  for (const pcl::index_t seed : proposal.seeds)
    report.seeds.push_back(points.indexInFile(seed));
  report.coverage = proposal.coverage;
  report.seed_positions.clear();
  for (const pcl::index_t seed : proposal.seeds)
    report.seed_positions.push_back(
        points.frame.toFile((*points.points)[static_cast<std::size_t>(seed)]
                                .getVector3fMap()
                                .cast<double>()));
  countGroups(proposal.group, proposal.seeds.size(), report);
  report.grown_sizes.clear();
}

void
describePatches(const SmoothPatches& patches, const CloudPoints& points, Report& report)
{
  report.points_in = points.points->size();
  report.points_finite = points.finite;
  report.seeds.clear();
  report.coverage.clear();
  report.seed_positions.clear();
  countGroups(patches.groups(), patches.numberOfPatches(), report);
  report.grown_sizes = patches.grownSizes();
}

std::string
toJson(const Report& report)
{
  Json json = Json::object();
  json["tool"] = report.tool;
  json["version"] = PCL_CID_VERSION;
  json["input"] = report.input;
  if (!report.remarks.empty())
    json["remarks"] = report.remarks;
  json["parameters"] = parametersOf(report);
  json["points"] = {{"in", report.points_in},
                    {"finite", report.points_finite},
                    {"grouped", report.points_grouped}};
  if (report.voxels)
    json["points"]["voxels"] = *report.voxels;
  if (report.density)
    json["density"] = densityOf(*report.density);
  if (report.blind_spot)
    json["blind_spot"] = blindSpotOf(*report.blind_spot);
  json["seeds"] = seedsOf(report);
  if (!report.grown_sizes.empty())
    json["patches"] = patchesOf(report);
  if (report.score)
    json["score"] = scoreOf(*report.score);
  if (report.parts) {
    json["parts"] = partsOf(report);
    json["points"]["dropped"] = report.dropped_points;
  }
  if (report.exact_vertices)
    json["exact_vertices"] = *report.exact_vertices;
  if (report.places)
    json["places"] = {{"free", report.places->free},
                      {"refused", report.places->refused},
                      {"refused_share", report.places->refusedShare()}};
  if (report.tightness)
    json["tightness"] = tightnessOf(*report.tightness);
  json["seconds"] = secondsOf(report);
  json["peak_memory_bytes"] = peakMemoryBytes();
  return print(json);
}

std::string
toJson(const MergeTree& tree)
{
  Json steps = Json::array();
  for (const MergeStep& step : tree.steps())
    steps.push_back({{"first", step.first},
                     {"second", step.second},
                     {"height", step.height},
                     {"size", step.size}});
  Json json = Json::object();
  json["group_sizes"] = tree.groupSizes();
  json["steps"] = std::move(steps);
  return print(json);
}

} // namespace pcl_cid
