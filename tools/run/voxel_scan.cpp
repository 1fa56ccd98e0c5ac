/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The input of a run that is read block by block, for scans larger than the memory.
 */

#include "voxel_scan.h"

#include "common_settings.h"
#include "parameter.h"

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/scan_source.h>

#include <cerrno>
#include <cstring>
#include <ostream>

namespace pcl_cid::tools {
namespace {

/** Refuse an output that cannot hold a block; what is to be said of it is said once. */
class OutputCheck {
public:
  OutputCheck(const std::string& path, Run& run) : path_(path), run_(run) {}

  void
  operator()(const LabelledCloud& block)
  {
    requireWritable(block, path_, [this](const std::string& sentence) {
      if (!is_told_)
        run_.remark()(path_ + ": " + sentence);
    });
    is_told_ = true;
  }

private:
  std::string path_;
  Run& run_;
  bool is_told_ = false;
};

/** Begin the step, of which opening the file may be a long part.
 *  \return the file */
const std::string&
beginReading(const Settings& settings, Run& run)
{
  if (!settings.many.output_dir.empty())
    run.console.beBriefOn(settings.input);
  run.begin("Reading " + settings.input);
  return settings.input;
}

} // namespace

void
declareVoxelOption(std::optional<double>& voxel,
                   const std::vector<std::string>& whole_cloud,
                   CommandLine& line)
{
  line.optional(
      setting::voxel,
      voxel,
      "the others follow it; for an INPUT larger than the memory, which is read "
      "several times");
  line.exclude(
      optionName(setting::voxel),
      whole_cloud,
      "the second needs all points in memory, of which the first holds one for "
      "each voxel");
}

void
checkVoxelOption(const Settings& settings)
{
  if (!settings.voxel)
    return;
  if (settings.input == standard_output)
    throw UsageError("--voxel reads INPUT several times, which the standard input "
                     "cannot be; name a file");
  if (settings.output == standard_output)
    throw UsageError(
        "--voxel holds no more than a block of OUTPUT, but what goes to the "
        "standard output is held until the end; name a file");
}

FollowedGroups::FollowedGroups(const std::vector<pcl::index_t>& group, Report& report)
: group_(group), report_(report)
{
  report.group_sizes.assign(report.group_sizes.size(), 0);
  report.points_grouped = 0;
}

void
FollowedGroups::take(const pcl::Indices& follows)
{
  for (const pcl::index_t point : follows) {
    const pcl::index_t group = point < 0 ? -1 : group_[static_cast<std::size_t>(point)];
    if (group < 0)
      continue;
    ++report_.group_sizes[static_cast<std::size_t>(group)];
    ++report_.points_grouped;
  }
}

VoxelScan::VoxelScan(const Settings& settings,
                     const std::string& output,
                     const decltype(VoxelOptions::check)& check,
                     Run& run)
: reader_(beginReading(settings, run),
          settings.input_format.empty() ? "" : "." + settings.input_format,
          settings.scale,
          CloudBlockReader::usual_block,
          run.console.progress())
, output_(output)
, layout_(output.empty() ? CloudLayout()
                         : blockLayoutFor(output, reader_.head().layout))
{
  OutputCheck requireHolds(output, run);
  VoxelOptions options;
  options.size = *settings.voxel;
  options.points = {settings.keep_zeros, run.remark()};
  options.check = [&](const LabelledCloud& block, const VoxelPoints::Block& points) {
    if (!output_.empty())
      requireHolds(block);
    if (check)
      check(block, points);
  };
  options.execution = {settings.threads, run.console.progress()};
  std::size_t told = 0;
  const auto tell_remarks = [&] {
    for (; told < reader_.head().remarks.size(); ++told)
      run.remark()(settings.input + ": " + reader_.head().remarks[told]);
  };
  tell_remarks();
  voxels_.emplace(reader_, options);
  tell_remarks();
  scan_.name = scanName(settings.input);
  scan_.cloud = voxels_->takeCloud();
  scan_.points = pointsOf(scan_.cloud, {true, run.remark()});
  scan_.points.source = voxels_->source();
  scan_.points.points_in_file = reader_.head().size();
  useOutputUnit(settings, scan_);
  remarkOnUnit(settings, scan_, run);
  run.end(std::to_string(reader_.head().size()) + " points, " +
              std::to_string(voxels_->finite()) + " finite, in " +
              std::to_string(scan_.cloud.size()) + " voxels",
          "load");
  run.report.input = settings.input;
}

LabelledCloud
VoxelScan::headFor(const LabelledCloud& block) const
{
  LabelledCloud head = reader_.head();
  head.sensor_origin = block.sensor_origin;
  return head;
}

void
VoxelScan::follow(const Settings& settings, const VoxelCloud::Take& take, Run& run)
{
  voxels_->follow(reader_, take, {settings.threads, run.console.progress()});
}

void
VoxelScan::writeLabels(const Settings& settings,
                       const std::vector<std::uint32_t>& labels,
                       const Take& take,
                       Run& run)
{
  run.outputs.write(output_, [&](std::ostream& stream) {
    std::optional<CloudBlockWriter> writer;
    std::vector<std::uint32_t> of_block;
    follow(
        settings,
        [&](LabelledCloud& block, const pcl::Indices& follows) {
          of_block.clear();
          for (const pcl::index_t point : follows)
            of_block.push_back(point < 0 ? 0 : labels[static_cast<std::size_t>(point)]);
          take(block, follows, of_block);
          setLabels(of_block, settings.label_type, block);
          if (settings.output_unit == OutputUnit::metre)
            convertToMetres(block);
          if (!writer)
            writer.emplace(stream, headFor(block), layout_);
          writer->write(block);
          if (!stream)
            throw CIDException(
                output_ + ": could not be written in full: " + std::strerror(errno));
        },
        run);
    writer->finish();
  });
}

void
VoxelScan::describe(const Settings& settings, Report& report) const
{
  report.points_in = reader_.head().size();
  report.points_finite = voxels_->finite();
  report.voxels = scan_.cloud.size();
  report.parameters.push_back(parameter(setting::voxel, settings.voxel));
}

} // namespace pcl_cid::tools
