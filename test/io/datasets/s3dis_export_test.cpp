/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labelled scans written as rooms of S3DIS, and read again.
 */

#include "cloud_files.h"
#include "dataset_folders.h"
#include "python_reader.h"

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/s3dis.h>
#include <pcl_cid/io/s3dis_export.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;
using Labels = std::vector<std::uint32_t>;
using Json = nlohmann::json;
using Row = std::array<double, 6>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/** Names that are no names of files. */
Strings
nastyNames()
{
  return {"chair",
          "Chair",
          "CHAIR",
          "%43hair",
          "floor mat",
          "floor+mat",
          "floor-mat",
          "floor_mat",
          "a/b",
          "../../etc",
          ".",
          "..",
          "",
          "%none",
          "none",
          "%",
          " ",
          "  ",
          "stuhl \xC3\xBC",
          "\xFF",
          "a\nb",
          "a\tb",
          "'\"`$*",
          "chair_1",
          "con",
          "-",
          "\xE6\xA4\x85"};
}

class S3DISExport : public testing::Test {
protected:
  template <typename Coordinate>
  static LabelledCloud
  cloudOf(const std::vector<std::array<Coordinate, 3>>& points)
  {
    LabelledCloud cloud;
    cloud.name = "scan.pcd";
    const char* const axes[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<Coordinate> values;
      for (const auto& point : points)
        values.push_back(point[axis]);
      appendField(axes[axis], values, cloud.fields);
    }
    return cloud;
  }

  static void
  paint(LabelledCloud& cloud)
  {
    Labels colors;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      colors.push_back(static_cast<std::uint32_t>(0x10203 * i) & 0xFFFFFF);
    appendField("rgb", colors, cloud.fields);
  }

  void
  write(const LabelledCloud& cloud, const LabelledInstances& scan)
  {
    remarks_.clear();
    OutputFiles outputs({});
    pcl_cid::writeS3DISRoom(
        cloud, scan, room_, outputs, [this](const std::string& remark) {
          remarks_.push_back(remark);
        });
    outputs.commit();
  }

  std::string
  complaint(const LabelledCloud& cloud, const LabelledInstances& scan)
  {
    return complaintAbout("", [&] { write(cloud, scan); });
  }

  Strings
  annotations() const
  {
    std::set<std::string> names;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(room_ + "/Annotations"))
      names.insert(entry.path().filename().string());
    return {names.begin(), names.end()};
  }

  TemporaryFolder folder_;
  std::string room_ = folder_.file("office_3");
  Strings remarks_;
};

TEST_F(S3DISExport, IsTheRoomAndAFileForEachInstance)
{
  LabelledCloud cloud = cloudOf<float>({{0.1f, -2.0f, 1e-5f},
                                        {3.0f, 4.5f, 0.0f},
                                        {1.0f, 1.0f, 1.0f},
                                        {7.0f, 8.0f, 9.0f}});
  paint(cloud);
  write(cloud,
        {{9, 4, 0, 2}, {{9, "chair", ""}, {2, "table", "mine"}, {4, "chair", ""}}});
  const std::string first = "0.1 -2 1e-05 0 0 0\n";
  EXPECT_EQ(readText(room_ + "/office_3.txt"),
            first + "3 4.5 0 1 2 3\n1 1 1 2 4 6\n7 8 9 3 6 9\n");
  EXPECT_EQ(annotations(), (Strings{"chair_1.txt", "chair_2.txt", "table_1.txt"}));
  EXPECT_EQ(readText(room_ + "/Annotations/chair_1.txt"), "3 4.5 0 1 2 3\n");
  EXPECT_EQ(readText(room_ + "/Annotations/chair_2.txt"), first);
  EXPECT_EQ(remarks_, Strings{});
}

/** What a reader finds: the points of each instance, by class. */
using Found = std::multiset<std::pair<std::string, std::vector<Row>>>;

Row
rowOf(const LabelledCloud& cloud, std::size_t i)
{
  const Eigen::Vector3d p = FileCoordinates(cloud)[i];
  const ColorRGB color = colorsOf(cloud)[i];
  return {p.x(), p.y(), p.z(), double(color.r), double(color.g), double(color.b)};
}

Found
instancesOf(const LabelledCloud& cloud,
            const Labels& label,
            const std::function<std::string(std::uint32_t)>& classOf)
{
  std::map<std::uint32_t, std::vector<Row>> rows;
  const FileCoordinates coordinates(cloud);
  const std::vector<ColorRGB> colors = colorsOf(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = coordinates[i];
    const ColorRGB c = colors[i];
    if (label[i] != 0 && p.allFinite())
      rows[label[i]].push_back(
          {p.x(), p.y(), p.z(), double(c.r), double(c.g), double(c.b)});
  }
  Found found;
  for (const auto& [number, points] : rows)
    found.insert({classOf(number), points});
  return found;
}

template <typename Coordinate>
std::vector<std::array<Coordinate, 3>>
randomPoints(std::size_t count,
             const std::array<double, 3>& center,
             std::mt19937& random)
{
  std::normal_distribution<double> spread(0.0, 5.0);
  std::vector<std::array<Coordinate, 3>> points(count);
  for (auto& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<Coordinate>(center[axis] + spread(random));
  return points;
}

TEST_F(S3DISExport, IsReadBackPointByPoint)
{
  std::mt19937 random(5);
  const Strings classes = {"chair", "wall", "clutter", "sofa"};
  for (const bool far : {false, true}) {
    room_ = folder_.file(far ? "far" : "near");
    const LabelledCloud whole =
        far ? cloudOf(randomPoints<double>(600, {389412.25, 5819873.5, 41.0}, random))
            : cloudOf(randomPoints<float>(600, {1.0, -2.0, 0.0}, random));
    LabelledCloud cloud = whole;
    paint(cloud);
    LabelledInstances scan;
    for (std::uint32_t i = 1; i <= 12; ++i)
      scan.instances.push_back({100 * i, classes[random() % classes.size()], ""});
    for (std::size_t i = 0; i < cloud.size(); ++i)
      scan.label.push_back(static_cast<std::uint32_t>(random() % 13) * 100);
    write(cloud, scan);
    EXPECT_EQ(remarks_, Strings{});

    const Found written = instancesOf(cloud, scan.label, [&](std::uint32_t label) {
      return scan.instances[label / 100 - 1].class_name;
    });
    const LabelledCloud back = readS3DISRoom(room_, {});
    const Labels label = valuesOf<std::uint32_t>(back.fields, "label");
    const Labels semantic = valuesOf<std::uint32_t>(back.fields, "semantic");
    const auto classOf = [&](std::uint32_t number) {
      const auto first = std::find(label.begin(), label.end(), number);
      return *className(s3disClasses(), semantic[first - label.begin()]);
    };
    EXPECT_EQ(instancesOf(back, label, classOf), written);
    EXPECT_EQ(FileCoordinates(back).datatype(), FileCoordinates(cloud).datatype());

    const Json python = readByPython({"s3dis", room_});
    Found by_python;
    for (const Json& each : python["instances"]) {
      std::vector<Row> rows;
      for (Row row : each["points"].get<std::vector<Row>>()) {
        if (!far) // numpy reads double
          std::transform(row.begin(), row.end(), row.begin(), [](double value) {
            return static_cast<double>(static_cast<float>(value));
          });
        rows.push_back(row);
      }
      by_python.insert({each["class"], rows});
    }
    EXPECT_EQ(by_python, written);
    ASSERT_EQ(python["points"].size(), cloud.size());
    for (std::size_t i = 0; far && i < cloud.size(); i += 50)
      EXPECT_EQ(python["points"][i].get<Row>(), rowOf(cloud, i));
  }
}

TEST_F(S3DISExport, TellsNastyClassesApart)
{
  const Strings names = nastyNames();
  std::set<std::string> file_classes;
  LabelledInstances scan;
  std::vector<std::array<float, 3>> points;
  for (const std::string& name : names) {
    const std::string file_class = s3disFileClass(name);
    EXPECT_TRUE(file_classes.insert(file_class).second) << name;
    EXPECT_EQ(file_class.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-+%"),
              std::string::npos)
        << file_class;
    const auto label = static_cast<std::uint32_t>(points.size() + 1);
    scan.label.push_back(label);
    scan.instances.push_back({label, name, ""});
    points.push_back({static_cast<float>(label), 0.0f, 0.0f});
  }
  for (const SemanticClass& known : s3disClasses())
    EXPECT_EQ(s3disFileClass(known.name), known.name);
  write(cloudOf(points), scan);
  EXPECT_EQ(annotations().size(), names.size());
  const Json python = readByPython({"s3dis", room_});
  std::map<double, std::string> class_of_x;
  for (const Json& each : python["instances"])
    class_of_x[each["points"][0][0]] = each["class"];
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == "\xFF") // Python replaces what is no UTF-8
      continue;
    EXPECT_EQ(class_of_x[static_cast<double>(i + 1)],
              names[i].empty() ? "%none" : names[i]);
  }
  EXPECT_EQ(readS3DISRoom(room_, {}).size(), names.size());
  EXPECT_EQ(
      complaint(cloudOf<float>({{1, 2, 3}}), {{1}, {{1, std::string(201, 'a'), ""}}}),
      room_ + "/Annotations: the class '" + std::string(201, 'a') +
          "' takes 201 bytes in the name of a file; it must take at most 200");
}

TEST_F(S3DISExport, LeavesOutWhatTheFormatDoesNotKnow)
{
  const LabelledCloud cloud =
      cloudOf<double>({{1, 2, 3}, {nan, 2, 3}, {HUGE_VAL, 0, 0}, {4, 5, 6}});
  write(cloud, {{1, 1, 2, 0}, {{1, "stairs", ""}, {2, "wall", ""}, {3, "door", ""}}});
  EXPECT_EQ(readText(room_ + "/office_3.txt"), "1 2 3 0 0 0\n4 5 6 0 0 0\n");
  EXPECT_EQ(annotations(), Strings{"stairs_1.txt"});
  EXPECT_EQ(
      remarks_,
      (Strings{room_ + ": 2 points that are not finite are left out",
               room_ + ": scan.pcd has no colors; all points are written as 0 0 0",
               room_ + ": 2 instances without a finite point are left out",
               room_ + ": 'stairs': no class of S3DIS, so most readers take it as "
                       "clutter"}));
}

TEST_F(S3DISExport, MayHaveNoPointAndNoInstance)
{
  write(cloudOf<float>({}), {});
  EXPECT_EQ(readText(room_ + "/office_3.txt"), "");
  EXPECT_EQ(annotations(), Strings{});
  EXPECT_EQ(readByPython({"s3dis", room_})["instances"], Json::array());
  write(cloudOf<float>({{1, 2, 3}}), {{0}, {}});
  EXPECT_EQ(readText(room_ + "/office_3.txt"), "1 2 3 0 0 0\n");
  EXPECT_EQ(annotations(), Strings{});
}

TEST_F(S3DISExport, ReplacesAnEarlierOneAndNothingElse)
{
  const LabelledCloud cloud = cloudOf<float>({{1, 2, 3}, {4, 5, 6}});
  write(cloud, {{1, 2}, {{1, "chair", ""}, {2, "chair", ""}}});
  writeText(room_ + "/Annotations/notes", "mine");
  write(cloud, {{0, 2}, {{2, "chair", ""}}});
  EXPECT_EQ(annotations(), (Strings{"chair_1.txt", "notes"}));
  EXPECT_EQ(readText(room_ + "/Annotations/chair_1.txt"), "4 5 6 0 0 0\n");
}

TEST_F(S3DISExport, IsWrittenAsAWholeOrNotAtAll)
{
  const LabelledCloud cloud = cloudOf<float>({{1, 2, 3}, {4, 5, 6}});
  const LabelledInstances scan = {{1, 2}, {{1, "chair", ""}, {2, "chair", ""}}};
  EXPECT_EQ(
      complaint(cloud, {{1}, {{1, "chair", ""}}}),
      "scan.pcd: has 2 points, but there are labels for 1; there must be one for each");
  {
    OutputFiles outputs({});
    pcl_cid::writeS3DISRoom(cloud, scan, room_, outputs);
  }
  EXPECT_FALSE(fs::exists(room_));

  // The room that was read is not written over.
  write(cloud, scan);
  OutputFiles outputs(s3disRoomFiles(room_));
  EXPECT_THROW(pcl_cid::writeS3DISRoom(cloud, scan, room_, outputs), CIDException);
}

} // namespace
} // namespace pcl_cid::test
