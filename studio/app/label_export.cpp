/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The labels of a session in the formats of others.
 */

#include "label_export.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/s3dis_export.h>
#include <pcl_cid/io/scannet_annotation.h>
#include <pcl_cid/io/seed_table.h>
#include <pcl_cid/io/semantic_kitti.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <utility>

#include <nlohmann/json.hpp>

namespace pcl_cid::studio {
namespace {

namespace fs = std::filesystem;

/** What a format needs to write itself. */
struct Export {
  const LabelledCloud& cloud;
  const CloudPoints& points;
  const LabelSession& session;
  const LabelledInstances& labels;
  OutputFiles& outputs;
  std::string path; ///< without extension
  std::vector<std::string> remarks{};

  /** Announce and write a file. */
  std::string
  file(const std::string& extension, const std::function<void(std::ostream&)>& write)
  {
    const std::string name = path + extension;
    outputs.announce(name);
    outputs.write(name, write);
    return name;
  }
};

using Files = std::vector<std::string>;

/** What the numbers of the field `label` are. */
void
writeInstances(const LabelledInstances& labels, std::ostream& stream)
{
  std::map<std::uint32_t, std::size_t> points;
  for (const std::uint32_t label : labels.label)
    ++points[label];
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const NamedInstance& instance : labels.instances)
    list.push_back({{"label", instance.label},
                    {"class", instance.class_name},
                    {"name", instance.name},
                    {"points", points[instance.label]}});
  stream << list.dump(2) << "\n";
}

Files
writeLabelledCloud(Export& to, const std::string& extension)
{
  LabelledCloud cloud = to.cloud;
  setLabels(to.labels.label, LabelType::U4, cloud);
  const std::string path = to.path + extension;
  return {to.file(extension,
                  [&](std::ostream& stream) {
                    writeCloud(stream, cloud, layoutFor(path, cloud.layout));
                  }),
          to.file(".instances.json",
                  [&](std::ostream& stream) { writeInstances(to.labels, stream); })};
}

Files
writePcd(Export& to)
{
  return writeLabelledCloud(to, ".pcd");
}

Files
writePly(Export& to)
{
  return writeLabelledCloud(to, ".ply");
}

Files
writeSeeds(Export& to)
{
  pcl::Indices seeds;
  std::vector<std::optional<std::uint32_t>> labels;
  for (const SessionSeed& seed : to.session.seeds()) {
    seeds.push_back(seed.point);
    labels.push_back(seed.label);
  }
  return {to.file(".seeds.csv", [&](std::ostream& stream) {
    writeSeedTable(stream, seeds, to.points, labels);
  })};
}

Files
writeS3dis(Export& to)
{
  writeS3DISRoom(
      to.cloud, to.labels, to.path, to.outputs, [&](const std::string& sentence) {
        to.remarks.push_back(sentence);
      });
  return {to.path};
}

Files
writeScannet(Export& to)
{
  const std::string id = fs::path(to.path).filename().string();
  to.outputs.announceFolder(to.path);
  writeScannetAnnotation(to.labels, to.session.groups(), {to.path, id, ""}, to.outputs);
  const std::string predictions = (fs::path(to.path) / "prediction").string();
  announceScannetSubmission(predictions, id, to.outputs);
  writeScannetSubmission(predictions,
                         id,
                         to.labels.label,
                         ofBenchmarkClasses(scannetInstances(to.labels)),
                         to.outputs);
  return {to.path};
}

Files
writeKitti(Export& to)
{
  const std::string path = to.path + ".label";
  writeSemanticKitti(to.labels, semanticKittiClasses(), path, to.outputs);
  return {path, semanticKittiClassFile(path)};
}

struct Format {
  const char* word;
  Files (*write)(Export& to);
};

constexpr std::array<Format, 6> formats{{{"pcd", writePcd},
                                         {"ply", writePly},
                                         {"seeds", writeSeeds},
                                         {"scannet", writeScannet},
                                         {"s3dis", writeS3dis},
                                         {"kitti", writeKitti}}};

const Format&
formatOf(const std::string& word)
{
  std::string all;
  for (const Format& format : formats) {
    if (word == format.word)
      return format;
    all += (all.empty() ? "" : ", ") + std::string(format.word);
  }
  throw CIDException("there is no format '" + word + "'; there are " + all);
}

} // namespace

LabelExporter::LabelExporter(const LabelledCloud& cloud,
                             const CloudPoints& points,
                             std::vector<std::string> inputs,
                             std::string folder,
                             std::string name)
: cloud_(cloud)
, points_(points)
, inputs_(std::move(inputs))
, folder_(std::move(folder))
, name_(std::move(name))
{
}

ExportedFiles
LabelExporter::write(const LabelSession& session,
                     const std::string& format,
                     const std::string& name,
                     bool clean_up,
                     const ExecutionOptions& execution) const
{
  const Format& chosen = formatOf(format);
  const std::string file = name.empty() ? name_ + "_labelled" : name;
  requireFileName(file);
  const LabelledInstances labels{clean_up ? session.cleanedLabels({}, execution)
                                          : session.labels(),
                                 session.instances()};
  OutputFiles outputs(inputs_);
  Export to{
      cloud_, points_, session, labels, outputs, (fs::path(folder_) / file).string()};
  Files files = chosen.write(to);
  outputs.commit();
  return {std::move(files), std::move(to.remarks)};
}

} // namespace pcl_cid::studio
