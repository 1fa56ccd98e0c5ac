/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files for tests: a folder of their own, text, clouds with all kinds of fields.
 */

#include "cloud_files.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

namespace pcl_cid::test {
namespace {

constexpr std::size_t width = 40;
constexpr std::size_t height = 30;

struct DeskPoint {
  Eigen::Vector3f position;
  std::uint32_t label;
};

/** Rows look further down; every 13th point is missing, as in a depth image. */
DeskPoint
deskPoint(std::size_t row, std::size_t column)
{
  const float x = 0.05f * static_cast<float>(column) - 1.0f;
  const float down = 0.04f * static_cast<float>(row) - 0.6f;
  const bool on_box = row > 18 && row < 25 && column > 10 && column < 20;
  if ((row * width + column) % 13 == 7)
    return {Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()), 0};
  if (on_box)
    return {{x, down - 0.1f, 1.2f}, 3};
  if (row > 15)
    return {{x, 0.05f, 2.0f - down}, 2};
  return {{x, down, 2.0f}, 1};
}

} // namespace

TemporaryFolder::TemporaryFolder() : path_(testing::TempDir() + "pcl_cid_XXXXXX")
{
  if (!mkdtemp(path_.data()))
    throw std::runtime_error("cannot make the folder " + path_);
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

std::vector<std::string>
TemporaryFolder::names() const
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

/** A new file: some file systems flush one that is written over. */
std::ofstream
newFile(const std::string& path)
{
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error))
    std::filesystem::remove(path, error);
  return std::ofstream(path, std::ios::binary);
}

} // namespace

void
writeText(const std::string& path, const std::string& text)
{
  std::ofstream stream = newFile(path);
  stream << text;
  stream.close();
  if (!stream)
    throw std::runtime_error("cannot write " + path);
}

std::string
readText(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string
complaintAbout(const std::string& begin, const std::function<void()>& read)
{
  try {
    read();
  }
  catch (const CIDException& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(begin, 0), 0u) << message;
    return message.substr(begin.size());
  }
  return "none";
}

std::vector<std::uint8_t>
bytesOf(const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  std::vector<std::uint8_t> bytes;
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (field.name != name)
      continue;
    const std::size_t size =
        field.count * static_cast<std::size_t>(pcl::getFieldSize(field.datatype));
    for (std::size_t i = 0; i < std::size_t{cloud.width} * cloud.height; ++i) {
      const std::uint8_t* const value =
          cloud.data.data() + i * cloud.point_step + field.offset;
      bytes.insert(bytes.end(), value, value + size);
    }
  }
  return bytes;
}

LoadedByPCL
loadWithPCL(const std::string& path)
{
  LoadedByPCL loaded;
  int version = 0;
  pcl::PCDReader pcd;
  pcl::PLYReader ply;
  pcl::FileReader& reader =
      path.substr(path.size() - 4) == ".ply" ? static_cast<pcl::FileReader&>(ply) : pcd;
  if (reader.read(path, loaded.cloud, loaded.origin, loaded.orientation, version) < 0)
    throw std::runtime_error("PCL cannot read " + path);
  return loaded;
}

LabelledCloud
threePoints()
{
  LabelledCloud cloud;
  cloud.name = "three.pcd";
  appendField<float>(
      "x", {0, 1, std::numeric_limits<float>::quiet_NaN()}, cloud.fields);
  appendField<float>("y", {0, 0, 0}, cloud.fields);
  appendField<float>("z", {1, 1, 1}, cloud.fields);
  return cloud;
}

LabelledCloud
deskScan()
{
  std::vector<float> x, y, z, rgb;
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column < width; ++column) {
      const Eigen::Vector3f p = deskPoint(row, column).position;
      x.push_back(p.x());
      y.push_back(p.y());
      z.push_back(p.z());
      const auto color = static_cast<std::uint32_t>(row << 16 | column << 8 | 77);
      rgb.emplace_back();
      std::memcpy(&rgb.back(), &color, sizeof(color));
    }
  LabelledCloud scan;
  appendField("x", x, scan.fields);
  appendField("y", y, scan.fields);
  appendField("z", z, scan.fields);
  appendField("rgb", rgb, scan.fields);
  scan.fields.width = width;
  scan.fields.height = height;
  scan.fields.row_step = scan.fields.point_step * scan.fields.width;
  scan.sensor_origin = Eigen::Vector4f(1.25f, -0.1f, 1234567.0f, 0.0f);
  scan.sensor_orientation = Eigen::Quaternionf(0.5f, -0.5f, 0.5f, -0.5f);
  return scan;
}

std::vector<std::uint32_t>
deskLabels()
{
  std::vector<std::uint32_t> labels;
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column < width; ++column)
      labels.push_back(deskPoint(row, column).label);
  return labels;
}

void
saveCloud(const std::string& path,
          const LabelledCloud& cloud,
          const CloudLayout& layout)
{
  std::ofstream stream = newFile(path);
  writeCloud(stream, cloud, layout);
  stream.close();
  if (!stream)
    throw std::runtime_error("cannot write " + path);
}

} // namespace pcl_cid::test
