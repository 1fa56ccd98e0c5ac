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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
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

/** Rings count from 0: no other value of a scan is a small whole number everywhere. */
bool
isRing(float ring)
{
  constexpr float most_rings = 256.0f;
  return ring >= 0.0f && ring < most_rings && std::floor(ring) == ring;
}

/** Whether the last of each point's numbers is a ring, as far as the file was read. */
bool
haveRings(std::istream& stream, std::uint64_t size)
{
  const std::size_t step = nuScenes().bytes();
  std::vector<std::uint8_t> points(step * 4096);
  for (std::uint64_t read = 0; read < size; read += points.size()) {
    points.resize(std::min<std::uint64_t>(points.size(), size - read));
    stream.read(reinterpret_cast<char*>(points.data()),
                static_cast<std::streamsize>(points.size()));
    for (std::size_t end = step; stream && end <= points.size(); end += step)
      if (!isRing(loadValue<float>(points.data() + end - sizeof(float))))
        return false;
  }
  return true;
}

const LidarLayout&
lidarLayoutOf(std::istream& stream, std::uint64_t size, const std::string& name)
{
  if (size % nuScenes().bytes() == 0 && haveRings(stream, size))
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

/** Reads one file, all at once or block by block. */
class LidarReading : public CloudRows {
public:
  LidarReading(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
  : stream_(stream), cloud_(cloud)
  {
    const LidarLayout& layout = lidarLayoutOf(stream, size, cloud.name);
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

  void
  begin() override
  {
    stream_.clear();
    stream_.seekg(0);
  }

  void
  read(std::size_t count, std::uint8_t* points) override
  {
    if (!stream_.read(reinterpret_cast<char*>(points),
                      static_cast<std::streamsize>(count * cloud_.fields.point_step)))
      throw CIDException(cloud_.name + ": cannot be read to its end");
  }

  void
  end() override
  {
  }

private:
  std::istream& stream_;
  LabelledCloud& cloud_;
};

void
readLidar(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  LidarReading reading(stream, size, cloud);
  cloud.fields.data.resize(size);
  reading.begin();
  reading.read(cloud.size(), cloud.fields.data.data());
}

std::unique_ptr<CloudRows>
streamLidar(std::istream& stream,
            std::uint64_t size,
            LabelledCloud& head,
            const ProgressCallback&)
{
  return std::make_unique<LidarReading>(stream, size, head);
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
  format.streams = "a scan of KITTI or nuScenes";
  format.stream = streamLidar;
  return format;
}

} // namespace pcl_cid
