/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which prediction belongs to which truth.
 */

#include "scan_pairs.h"

#include "run/words.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/scan_source.h>

#include <filesystem>
#include <map>

namespace pcl_cid::tools {
namespace {

namespace fs = std::filesystem;

/** The name that a scan gives itself. Where it does not, that of its file or folder
 *  serves: what is wrong with the scan shows when it is read. */
std::string
nameOf(const fs::path& path)
{
  try {
    return scanName(path.string());
  }
  catch (const CIDException&) {
    return path.stem().string();
  }
}

std::vector<fs::path>
entriesOf(const std::string& folder)
{
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    entries.push_back(entry->path());
  if (error)
    throw CIDException(folder + ": cannot be listed: " + error.message());
  return entries;
}

/** The scans of a folder by name. */
std::map<std::string, std::string>
scansIn(const std::string& folder)
{
  std::map<std::string, std::string> scans;
  for (const fs::path& entry : entriesOf(folder)) {
    const std::string path = entry.string();
    if (!isScan(path))
      continue;
    const auto [known, is_new] = scans.emplace(nameOf(entry), path);
    if (!is_new)
      throw CIDException(path + ": has the same name as " + known->second +
                         "; names of scans must differ");
  }
  if (scans.empty())
    throw CIDException(folder + ": holds no scan; " +
                       alternatives(readableCloudNames()) +
                       " files, or folders of scans of " +
                       alternatives(datasetNames()) + " are needed");
  return scans;
}

/** The names of the scans that are not among the others, as a list. */
std::string
missingFrom(const std::map<std::string, std::string>& others,
            const std::map<std::string, std::string>& scans)
{
  std::string names;
  for (const auto& [name, path] : scans)
    if (others.count(name) == 0)
      names += (names.empty() ? "" : ", ") + name;
  return names;
}

bool
isFolderOfScans(const std::string& path)
{
  if (!fs::exists(path))
    throw CIDException(path + ": there is no such file or folder");
  return fs::is_directory(path) && !isScanFolder(path);
}

std::vector<ScanPair>
pairFolders(const std::string& prediction, const std::string& truth, bool partial)
{
  const auto predictions = scansIn(prediction);
  const auto truths = scansIn(truth);
  if (const std::string names = missingFrom(truths, predictions); !names.empty())
    throw CIDException(truth + ": lacks scans that " + prediction + " has: " + names);
  if (const std::string names = missingFrom(predictions, truths);
      !names.empty() && !partial)
    throw CIDException(prediction + ": lacks scans that " + truth + " has: " + names +
                       "; with --partial they are left out");
  std::vector<ScanPair> pairs;
  for (const auto& [name, path] : predictions)
    pairs.push_back({name, path, truths.at(name)});
  return pairs;
}

} // namespace

std::vector<ScanPair>
pairScans(const std::string& prediction, const std::string& truth, bool partial)
{
  const bool are_folders = isFolderOfScans(prediction);
  if (isFolderOfScans(truth) != are_folders)
    throw CIDException((are_folders ? prediction : truth) +
                       ": is a folder of scans, and " +
                       (are_folders ? truth : prediction) +
                       " is one scan; both must be the one or the other");
  if (are_folders)
    return pairFolders(prediction, truth, partial);
  return {{nameOf(truth), prediction, truth}};
}

} // namespace pcl_cid::tools
