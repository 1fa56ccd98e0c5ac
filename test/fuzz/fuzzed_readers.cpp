/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * All readers of files, each with files that it reads.
 */

#include "fuzzed_readers.h"

#include "cloud_files.h"
#include "dataset_folders.h"
#include "labelled_scan.h"
#include "part_scenes.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_blocks.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_import.h>
#include <pcl_cid/io/s3dis.h>
#include <pcl_cid/io/scannet.h>
#include <pcl_cid/io/seed_table.h>
#include <pcl_cid/io/viewpoints.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;

/** A finding: what holds of every cloud does not. */
void
require(bool condition, const char* what)
{
  if (!condition)
    throw std::logic_error(what);
}

/** A folder for as long as the program runs; TMPDIR says where. */
const TemporaryFolder&
folder()
{
  static const TemporaryFolder folder;
  return folder;
}

/** The coordinates as bits of double, NaN and all: PLY has no integers of 8 bytes. */
std::vector<std::uint64_t>
coordinatesOf(const LabelledCloud& cloud)
{
  const FileCoordinates coordinates(cloud);
  std::vector<std::uint64_t> bits(3 * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    std::memcpy(&bits[3 * i], coordinates[i].data(), 3 * sizeof(double));
  return bits;
}

/** What is written in a layout is read again, with the same coordinates. */
void
requireSameAgain(const LabelledCloud& cloud, const CloudLayout& layout)
{
  const std::string path = folder().file("again");
  try {
    saveCloud(path, cloud, layout);
  }
  catch (const CIDException&) {
    return; // the format cannot hold it, and says so
  }
  require(coordinatesOf(readCloud(path)) == coordinatesOf(cloud),
          "a cloud that was written is read in another way");
}

void
useCloud(const LabelledCloud& cloud)
{
  require(cloud.fields.data.size() == cloud.size() * cloud.fields.point_step,
          "a cloud has other bytes than its points");
  for (const CloudLayout& layout : {pcd_binary, pcd_compressed, ply_binary})
    requireSameAgain(cloud, layout);
  const CloudPoints points = pointsOf(cloud);
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    try {
      labelsOf(cloud, field.name, points);
    }
    catch (const CIDException&) {
    }
  colorsOf(cloud);
}

/** The bytes of all points of a file, read in small blocks; none for a file that is
 *  refused. */
std::optional<std::vector<std::uint8_t>>
bytesInBlocks(const std::string& path)
{
  try {
    CloudBlockReader reader(path, "", setting::scale.initial, 2);
    std::vector<std::uint8_t> bytes;
    LabelledCloud block;
    while (reader.read(block))
      bytes.insert(bytes.end(), block.fields.data.begin(), block.fields.data.end());
    return bytes;
  }
  catch (const CIDException&) {
    return std::nullopt;
  }
}

/** What can be read in blocks is the same all at once. */
void
readCloudTwice(const std::string& path)
{
  const auto bytes = bytesInBlocks(path);
  const LabelledCloud cloud = readCloud(path);
  require(!bytes || *bytes == cloud.fields.data, "a cloud is another in blocks");
  useCloud(cloud);
}

/** A reader of files of one kind.
 *  \param[in] path where such a file stands */
template <typename Read>
std::function<void(std::string_view)>
fromFile(const std::string& path, const Read& read)
{
  return [=](std::string_view bytes) {
    writeText(path, std::string(bytes));
    read(path);
  };
}

LabelledCloud
withFieldsOfAllKinds()
{
  LabelledCloud cloud = threePoints();
  appendField<float>("rgb", {1, 2, 3}, cloud.fields);
  appendField<double>("normal_x", {0.5, 1, -1}, cloud.fields);
  appendField<std::uint16_t>("label", {1, 0, 65535}, cloud.fields);
  appendField<std::int8_t>("object", {-1, 0, 5}, cloud.fields);
  return cloud;
}

std::vector<std::string>
cloudFiles(const std::vector<CloudLayout>& layouts)
{
  std::vector<std::string> files;
  for (const CloudLayout& layout : layouts) {
    saveCloud(folder().file("corpus"), withFieldsOfAllKinds(), layout);
    files.push_back(readText(folder().file("corpus")));
  }
  return files;
}

FuzzedReader
cloudReader(const char* name,
            const std::vector<CloudLayout>& layouts,
            const std::vector<std::string>& more,
            const std::string& extension = "")
{
  std::vector<std::string> corpus = cloudFiles(layouts);
  corpus.insert(corpus.end(), more.begin(), more.end());
  return {name,
          fromFile(folder().file(std::string(name) + extension), readCloudTwice),
          corpus};
}

template <typename Read, typename Write>
FuzzedReader
meshReader(const char* name, const Read& read, const Write& write)
{
  const PartScene scene = thinParts(Eigen::Vector3d::Zero());
  std::ostringstream stream;
  write(stream, std::vector<ConvexPart>(scene.parts.begin(), scene.parts.begin() + 2));
  return {name, fromFile(folder().file(name), read), {stream.str()}};
}

FuzzedReader
seedReader()
{
  const auto read = [](const std::string& path) {
    static const CloudPoints points = pointsOf(threePoints());
    holdsLabels(path);
    readSeedTable(path, points);
  };
  return {"seeds",
          fromFile(folder().file("seeds.csv"), read),
          {"index,x,y,z,label\n0,,,,1\n1,,,,2\n",
           "sep=;\r\nindex;label;note\r\n0;1.0;\"a \"\"b\"\";\r\n\"\r\n1;chair;\r\n",
           std::string("\xFF\xFEi\0n\0d\0e\0x\0,\0l\0a\0b\0e\0l\0\n\0"
                       "0\0,\0"
                       "1\0\n\0",
                       34)}};
}

FuzzedReader
viewpointsReader()
{
  const auto read = [](const std::string& path) {
    for (const Eigen::Vector3d& position : readViewpoints(path))
      require((position.array().abs() <= 1e15).all(), "a position is out of reach");
  };
  return {"viewpoints",
          fromFile(folder().file("viewpoints"), read),
          {"[[1, 2.5, -3], [4e2, 5, 6]]",
           "{\"sensor_positions\": [{\"x\": 1, \"y\": 2, \"z\": 3}]}",
           "{\"viewpoints\": [{\"position\": [1, 2, 3]}], \"a\": [[{}]]}",
           "1,2,3\n4,5,6\n",
           "sep=;\r\nname;x;\"y\";z\r\na;1,5;2;3\r\n"}};
}

/** A file of a scan of ScanNet; the others are as they should be. */
FuzzedReader
scannetReader(const char* name, const std::string& scan, const std::string& path)
{
  const auto read = [scan](const std::string&) {
    useCloud(readScannetScan(scan, "", {}));
  };
  return {name, fromFile(path, read), {readText(path)}};
}

void
addScannet(std::vector<FuzzedReader>& readers)
{
  const auto scanOf = [](const char* name) {
    fs::create_directory(folder().file(name));
    return writeScannetScan(folder().file(name), smallRoomScan(60), 2);
  };
  const std::string segments = scanOf("segments");
  readers.push_back(
      scannetReader("segments", segments, findScannetFiles(segments).segments));
  const std::string groups = scanOf("groups");
  readers.push_back(
      scannetReader("aggregation", groups, findScannetFiles(groups).aggregation));
  const std::string table = scanOf("table");
  readers.push_back(
      scannetReader("class_table", table, findScannetFiles(table).class_table));
}

FuzzedReader
s3disReader()
{
  fs::create_directory(folder().file("s3dis"));
  const std::string room = writeS3DISRoom(folder().file("s3dis"), smallRoomScan(60));
  const std::string path = s3disRoomFiles(room).front();
  const auto read = [room](const std::string&) { useCloud(readS3DISRoom(room, {})); };
  return {"s3dis", fromFile(path, read), {readText(path)}};
}

std::vector<FuzzedReader>
makeReaders()
{
  std::vector<FuzzedReader> readers{
      cloudReader(
          "pcd",
          {pcd_ascii, pcd_binary, pcd_compressed},
          {"# .PCD v0.7\rVERSION .7\rFIELDS x y z e _ b\rSIZE 4 2 8 1 1 1\r"
           "TYPE F I F U U B\rCOUNT 1 1 1 0 2 1\rWIDTH 1\rHEIGHT 1\r"
           "VIEWPOINT 0 0 0 1 0 0 0\rPOINTS 1\rDATA ascii\r1 2.0 1e-400 7 7 1\r"}),
      cloudReader(
          "ply",
          {ply_ascii, ply_binary},
          {"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
           "property list uchar int views\nproperty double y\nproperty int z\n"
           "property list uchar uchar _\nelement face 1\n"
           "property list uchar int vertex_indices\nend_header\n"
           "1 2 5 6 2 3 0\n1 2 5\n6 2 3 1 9\n3 0 1 0\n",
           "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\n"
           "property float y\nproperty float z\nproperty uchar r\nproperty uchar g\n"
           "property uchar b\nend_header\n123412341234rgb"}),
      cloudReader("text",
                  {},
                  {"1 2 3\n4 5.5 6e-3\nnan 8 9\n",
                   "//X,Y,Z,R,G,B,class\n2\n1,2,3,255,0,1,wall\n4,5,6,1,2,3,\n",
                   "x;y;z;\"my label\"\r\n1,5;2;3;4\r\n;;;5\r\n"},
                  ".xyz"),
      cloudReader("npy",
                  {},
                  {std::string("\x93NUMPY\1\0", 8) + std::string("\x3a\0", 2) +
                       "{'descr': '<f4', 'fortran_order': True, 'shape': (1, 3), }" +
                       "123412341234",
                   std::string("\x93NUMPY\1\0", 8) + std::string("\x5b\0", 2) +
                       "{'descr': [('xyz', '>f8', (3,)), ('rgb', '|u1', 3)], "
                       "'fortran_order': False, 'shape': (1,)}" +
                       "123456781234567812345678rgb"}),
      cloudReader("lidar", {}, {std::string(80, '1'), std::string(20, '\0')}, ".bin"),
      meshReader(
          "obj",
          [](const std::string& path) { readOBJ(path); },
          [](std::ostream& stream, const std::vector<ConvexPart>& parts) {
            writeOBJ(stream, parts, "hulls.mtl");
          }),
      meshReader(
          "ply_mesh", [](const std::string& path) { readPLY(path); }, writePLY),
      meshReader(
          "stl", [](const std::string& path) { readSTL(path); }, writeSTL),
      seedReader(),
      viewpointsReader(),
      s3disReader()};
  addScannet(readers);
  return readers;
}

} // namespace

const std::vector<FuzzedReader>&
fuzzedReaders()
{
  static const std::vector<FuzzedReader> readers = makeReaders();
  return readers;
}

} // namespace pcl_cid::test
