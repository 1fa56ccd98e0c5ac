/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan from wherever it comes: a file, or a folder of a dataset.
 */

#include "text/opened_file.h"
#include "text/path_names.h"

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/mesh_surface.h>
#include <pcl_cid/io/s3dis.h>
#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/scannet.h>

#include <algorithm>
#include <filesystem>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

/** A dataset whose scans are folders. */
struct Dataset {
  const char* name;
  const char* scan; ///< what one of its scans is, with an article
  bool (*recognizes)(const std::string& folder);
  LabelledCloud (*read)(const std::string& folder, const ScanOptions& options);
  std::vector<std::string> (*files)(const std::string& folder,
                                    const std::string& class_table);
  std::string (*scan_name)(const std::string& folder);
};

/** A new dataset is one more row here. */
const Dataset datasets[] = {
    {"S3DIS",
     "a room of S3DIS (with a folder Annotations)",
     isS3DISRoom,
     [](const std::string& folder, const ScanOptions& options) {
       return readS3DISRoom(folder, options.remark);
     },
     [](const std::string& folder, const std::string&) {
       return s3disRoomFiles(folder);
     },
     lastName},
    {"ScanNet",
     "a scan of ScanNet (with a file <id>_vh_clean_2.ply)",
     isScannetScan,
     [](const std::string& folder, const ScanOptions& options) {
       return readScannetScan(folder, options.class_table, options.remark);
     },
     [](const std::string& folder, const std::string& class_table) {
       return findScannetFiles(folder, class_table).all();
     },
     [](const std::string& folder) { return findScannetFiles(folder).id; }}};

/** Null for what is no scan of a dataset. */
const Dataset*
datasetOf(const std::string& path)
{
  for (const Dataset& dataset : datasets)
    if (dataset.recognizes(path))
      return &dataset;
  return nullptr;
}

bool
isFolder(const std::string& path)
{
  std::error_code error;
  return fs::is_directory(path, error);
}

/** Only ScanNet has one. */
void
requireUseForTable(const std::string& path, const std::string& class_table)
{
  if (!class_table.empty() && !isScannetScan(path))
    throw CIDException(path +
                       ": is no scan of ScanNet; only that has a use for the "
                       "class table " +
                       class_table);
}

/** A mesh where it can be nothing else, or a spacing asks for one. */
LabelledCloud
readFile(const std::string& path, const ScanOptions& options)
{
  const std::string& extension = options.extension;
  const bool is_mesh = isSurfaceFile(extension.empty() ? path : "file" + extension);
  return is_mesh || options.mesh_spacing > 0.0
             ? readSurfaceAsCloud(path, options.mesh_spacing, extension)
             : readCloud(path, extension);
}

[[noreturn]] void
refuseFolder(const std::string& path)
{
  std::vector<std::string> scans;
  for (const Dataset& dataset : datasets)
    scans.push_back(dataset.scan);
  throw CIDException(path + ": is a folder, but neither " + listed(scans, "nor"));
}

} // namespace

bool
isScanFolder(const std::string& path)
{
  return datasetOf(path) != nullptr;
}

bool
isScan(const std::string& path)
{
  if (isFolder(path))
    return isScanFolder(path);
  const CloudFormat* const format = findCloudFormat(path);
  std::error_code error;
  return format && format->read && format->is_of_scans_only &&
         fs::is_regular_file(path, error);
}

std::vector<std::string>
scanExtensions()
{
  std::vector<std::string> extensions = surfaceExtensions();
  for (const CloudFormat& format : cloudFormats())
    if (format.read)
      for (const std::string& extension : format.extensions)
        if (std::count(extensions.begin(), extensions.end(), extension) == 0)
          extensions.push_back(extension);
  extensions.push_back(gzip_extension);
  return extensions;
}

std::vector<std::string>
datasetNames()
{
  std::vector<std::string> names;
  for (const Dataset& dataset : datasets)
    names.push_back(dataset.name);
  return names;
}

LabelledCloud
readScan(const std::string& path, const ScanOptions& options)
{
  require(setting::scale, options.scale);
  require(setting::mesh_spacing, options.mesh_spacing);
  requireUseForTable(path, options.class_table);
  const Dataset* const dataset = datasetOf(path);
  if (!dataset && isFolder(path))
    refuseFolder(path);
  if (dataset && (options.mesh_spacing > 0.0 || !options.extension.empty()))
    throw CIDException(path + ": is " + dataset->scan +
                       "; only a file has a use for a format or a spacing of points");
  LabelledCloud cloud =
      dataset ? dataset->read(path, options) : readFile(path, options);
  cloud.scale = options.scale;
  for (const std::string& remark : cloud.remarks)
    if (options.remark)
      options.remark(path + ": " + remark);
  return cloud;
}

std::vector<std::string>
scanFiles(const std::string& path, const std::string& class_table)
{
  const Dataset* const dataset = datasetOf(path);
  return dataset ? dataset->files(path, class_table) : std::vector<std::string>{path};
}

std::string
scanName(const std::string& path)
{
  if (const Dataset* const dataset = datasetOf(path))
    return dataset->scan_name(path);
  if (path == standard_stream)
    return "standard_input";
  fs::path name = lastName(withoutGzip(path));
  if (fs::path inner = name; inner.extension() == ".bin") // of nuScenes: "a.pcd.bin"
    if ((inner = inner.stem()).extension() == ".pcd")
      name = inner;
  return (isFolder(path) ? name : name.stem()).string();
}

} // namespace pcl_cid
