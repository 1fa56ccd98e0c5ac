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
#include "point_columns.h"
#include "text/numbers.h"
#include "text/path_names.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <cmath>
#include <cstdint>
#include <istream>
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

float
floatAt(const std::vector<std::uint8_t>& data, std::size_t number)
{
  return loadValue<float>(data.data() + number * sizeof(float));
}

/** Rings count from 0: no other value of a scan is a small whole number everywhere. */
bool
haveRings(const std::vector<std::uint8_t>& data)
{
  constexpr float most_rings = 256.0f;
  const std::size_t step = nuScenes().names.size();
  for (std::size_t i = step - 1; i < data.size() / sizeof(float); i += step)
    if (const float ring = floatAt(data, i);
        !(ring >= 0.0f && ring < most_rings) || std::floor(ring) != ring)
      return false;
  return true;
}

const LidarLayout&
lidarLayoutOf(const std::vector<std::uint8_t>& data, const std::string& name)
{
  if (data.size() % nuScenes().bytes() == 0 && haveRings(data))
    return nuScenes();
  if (data.size() % kitti().bytes() == 0)
    return kitti();
  throw CIDException(sentence(name,
                              ": has ",
                              countOf(data.size(), "byte"),
                              ", which is neither a scan of KITTI (",
                              kitti().bytes(),
                              " bytes a point) nor one of nuScenes (",
                              nuScenes().bytes(),
                              ")"));
}

void
readLidar(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  std::vector<std::uint8_t>& data = cloud.fields.data;
  data.resize(size);
  if (!stream.read(reinterpret_cast<char*>(data.data()),
                   static_cast<std::streamsize>(size)))
    throw CIDException(cloud.name + ": cannot be read to its end");
  const LidarLayout& layout = lidarLayoutOf(data, cloud.name);
  const std::uint64_t points = size / layout.bytes();
  if (points > most_points)
    throw CIDException(sentence(cloud.name,
                                ": holds ",
                                points,
                                " points; at most ",
                                most_points,
                                " are possible"));
  cloud.layout = {"KITTI", CloudEncoding::binary};
  for (const std::string& name : layout.names)
    addField(name, pcl::PCLPointField::FLOAT32, 1, cloud.fields);
  cloud.fields.width = static_cast<std::uint32_t>(points);
  cloud.fields.height = 1;
  cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
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
