/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading scans of KITTI (x y z intensity) and nuScenes (x y z intensity ring): floats
 * one after the other, without a header.
 */

#include "base/sentence.h"
#include "column_formats.h"
#include "fields/field_values.h"
#include "text/numbers.h"
#include "text/path_names.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <cmath>
#include <cstdint>
#include <istream>
#include <limits>
#include <string>
#include <vector>

namespace pcl_cid {
namespace {

/** What a dataset stores of each point. */
struct LidarLayout {
  const char* dataset;
  std::vector<std::string> names;

  std::size_t
  bytes() const
  {
    return names.size() * sizeof(float);
  }
};

const LidarLayout&
kitti()
{
  static const LidarLayout layout{"KITTI", {"x", "y", "z", "intensity"}};
  return layout;
}

const LidarLayout&
nuScenes()
{
  static const LidarLayout layout{"nuScenes", {"x", "y", "z", "intensity", "ring"}};
  return layout;
}

std::vector<float>
floatsOf(std::istream& stream, std::uint64_t size, const std::string& name)
{
  std::vector<float> values(size / sizeof(float));
  if (!stream.read(reinterpret_cast<char*>(values.data()),
                   static_cast<std::streamsize>(values.size() * sizeof(float))))
    throw CIDException(name + ": cannot be read to its end");
  return values;
}

/** Rings count from 0: no other value of a scan is a small whole number everywhere. */
bool
haveRings(const std::vector<float>& values)
{
  constexpr float most_rings = 256.0f;
  const std::size_t step = nuScenes().names.size();
  for (std::size_t i = step - 1; i < values.size(); i += step)
    if (!(values[i] >= 0.0f && values[i] < most_rings) ||
        std::floor(values[i]) != values[i])
      return false;
  return true;
}

const LidarLayout&
lidarLayoutOf(std::uint64_t size,
              const std::vector<float>& values,
              const std::string& name)
{
  if (size % nuScenes().bytes() == 0 && haveRings(values))
    return nuScenes();
  if (size % kitti().bytes() == 0)
    return kitti();
  throw CIDException(sentence(name,
                              ": has ",
                              countOf(size, "byte"),
                              ", which is neither a scan of KITTI (",
                              kitti().bytes(),
                              " bytes a point) nor one of nuScenes (",
                              nuScenes().bytes(),
                              ")"));
}

void
readLidar(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  const std::vector<float> values = floatsOf(stream, size, cloud.name);
  const LidarLayout& layout = lidarLayoutOf(size, values, cloud.name);
  const std::uint64_t points = size / layout.bytes();
  constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
  if (points > most)
    throw CIDException(sentence(
        cloud.name, ": holds ", points, " points; at most ", most, " are possible"));
  cloud.layout = {"KITTI", CloudEncoding::binary};
  for (const std::string& name : layout.names)
    addField(name, pcl::PCLPointField::FLOAT32, 1, cloud.fields);
  cloud.fields.width = static_cast<std::uint32_t>(points);
  cloud.fields.height = 1;
  cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(values.data());
  cloud.fields.data.assign(bytes, bytes + size);
  cloud.remarks.push_back(sentence(
      "is read as a scan of ", layout.dataset, ": ", listed(layout.names, "and")));
}

} // namespace

CloudFormat
lidarFormat()
{
  CloudFormat format;
  format.name = "KITTI";
  format.extensions = {".bin"};
  format.is_of_scans_only = false; // networks are stored in such files, too
  format.read = readLidar;
  return format;
}

} // namespace pcl_cid
