/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan from wherever it comes: a file, or a folder of a dataset.
 */

#include "path_names.h"

#include <pcl_cid/io/s3dis.h>
#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/scannet.h>

namespace pcl_cid {

namespace fs = std::filesystem;

bool
isScanFolder(const std::string& path)
{
  return isS3DISRoom(path) || isScannetScan(path);
}

LabelledCloud
readScan(const std::string& path, const ScanOptions& options)
{
  if (isScannetScan(path))
    return readScannetScan(path, options.class_table, options.remark);
  if (!options.class_table.empty())
    throw CIDException(path +
                       ": is no scan of ScanNet; only that has a use for the "
                       "class table " +
                       options.class_table);
  if (isS3DISRoom(path))
    return readS3DISRoom(path, options.remark);
  std::error_code error;
  if (fs::is_directory(path, error))
    throw CIDException(path + ": is a folder, but neither a room of S3DIS (with a "
                              "folder Annotations) nor a scan of ScanNet (with a file "
                              "<id>_vh_clean_2.ply)");
  return readCloud(path);
}

std::vector<std::string>
scanFiles(const std::string& path, const std::string& class_table)
{
  if (isScannetScan(path))
    return findScannetFiles(path, class_table).all();
  if (isS3DISRoom(path))
    return s3disRoomFiles(path);
  return {path};
}

std::string
scanName(const std::string& path)
{
  if (isScannetScan(path))
    return findScannetFiles(path).id;
  std::error_code error;
  const fs::path name = lastName(path);
  return (fs::is_directory(path, error) ? name : name.stem()).string();
}

} // namespace pcl_cid
