/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Rooms of the dataset S3DIS, with their instances and classes.
 */

#include "base/sentence.h"
#include "fields/field_values.h"
#include "s3dis_line.h"
#include "text/file_reading.h"
#include "text/numbers.h"
#include "text/path_names.h"

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/s3dis.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

constexpr const char* what_a_line_is =
    "it must be six numbers x y z red green blue, the last three 0 to 255";

bool
isHidden(const fs::path& path)
{
  return path.filename().string().rfind('.', 0) == 0;
}

/** Sorting by this key is natural order: runs of digits compare as numbers. */
std::string
naturalKey(const fs::path& path)
{
  constexpr std::size_t width = 20; // digits of the largest number
  std::string key;
  std::string digits;
  for (const char letter : path.stem().string() + '\0') {
    if (std::isdigit(static_cast<unsigned char>(letter))) {
      digits += letter;
      continue;
    }
    if (!digits.empty() && digits.size() < width)
      key.append(width - digits.size(), '0');
    key += digits + letter;
    digits.clear();
  }
  return key;
}

/** What a folder holds, hidden files apart, in natural order. */
std::vector<fs::path>
sortedEntries(const fs::path& folder)
{
  std::vector<fs::path> entries;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (!isHidden(entry.path()))
      entries.push_back(entry.path());
  if (error)
    throw CIDException(folder.string() + ": cannot be read: " + error.message());
  std::sort(entries.begin(), entries.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(naturalKey(a), a) < std::pair(naturalKey(b), b);
  });
  return entries;
}

bool
isTextFile(const fs::path& path)
{
  std::error_code error;
  return path.extension() == ".txt" && fs::is_regular_file(path, error);
}

/** The files of a room. */
struct RoomFiles {
  std::vector<fs::path> annotations;
  /** The points without instances; empty when there is no such file. */
  fs::path room;
  /** What else is in the folder of the annotations. */
  std::vector<fs::path> others;

  explicit RoomFiles(const std::string& folder)
  {
    const fs::path path = folder;
    for (const fs::path& entry : sortedEntries(path / "Annotations"))
      (isTextFile(entry) ? annotations : others).push_back(entry);
    std::vector<fs::path> rooms;
    for (const fs::path& entry : sortedEntries(path))
      if (isTextFile(entry))
        rooms.push_back(entry);
    // Area_6/copyRoom_1 has its own as copy_Room_1.txt.
    if (rooms.size() == 1)
      room = rooms.front();
    else if (const fs::path usual = path / (lastName(folder) + ".txt");
             isTextFile(usual))
      room = usual;
  }
};

/** From here on float is coarser than a tenth of a millimeter. */
constexpr double far_away = 1024.0;

/** Gathers the points of the annotations, one after the other. */
template <typename Coordinate>
class RoomReading {
  using Point = S3DISPoint<Coordinate>;

public:
  explicit RoomReading(const RemarkCallback& remark) : remark_(remark) {}

  void
  takeAll(const RoomFiles& files)
  {
    for (const fs::path& annotation : files.annotations)
      take(annotation);
  }

  void
  take(const fs::path& annotation)
  {
    const std::string path = annotation.string();
    ++instance_;
    semantic_ = classOf(annotation);
    const std::size_t before = points_.size();
    forEachLine(textOf(path), [&](std::string_view line, std::size_t number) {
      takeLine(path, line, number);
    });
    if (points_.size() == before)
      throw CIDException(path + ": holds no point; an annotation must hold at least 1");
    labels_.resize(points_.size(), instance_);
    semantics_.resize(points_.size(), semantic_);
  }

  /** Compare with the file of the room. */
  void
  check(const fs::path& room) const
  {
    std::size_t lines = 0;
    forEachLine(textOf(room.string()), [&](std::string_view, std::size_t) { ++lines; });
    const std::size_t annotated = points_.size() + left_out_;
    if (lines != annotated)
      say(room.string(),
          ": holds ",
          countOf(lines, "point"),
          ", but the annotations ",
          annotated,
          "; those of the annotations are taken");
  }

  /** Whether one has a coordinate for which float is too coarse. */
  bool
  isFarAway() const
  {
    return std::any_of(points_.begin(), points_.end(), [](const Point& point) {
      return std::abs(point.x) >= far_away || std::abs(point.y) >= far_away ||
             std::abs(point.z) >= far_away;
    });
  }

  LabelledCloud
  cloud(const std::string& name) const
  {
    LabelledCloud cloud;
    cloud.name = name;
    for (const char* const axis : {"x", "y", "z"})
      addField(axis, pcl::traits::asEnum_v<Coordinate>, 1, cloud.fields);
    addField("rgb", pcl::PCLPointField::FLOAT32, 1, cloud.fields);
    const std::size_t size = cloud.fields.point_step;
    cloud.fields.data.resize(points_.size() * size);
    for (std::size_t i = 0; i < points_.size(); ++i) // without the padding of points
      std::memcpy(cloud.fields.data.data() + i * size, &points_[i], size);
    cloud.fields.width = static_cast<std::uint32_t>(points_.size());
    cloud.fields.height = 1;
    cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
    setLabels(labels_, LabelType::U4, cloud);
    setLabels(semantics_, LabelType::U4, cloud, "semantic");
    return cloud;
  }

  template <typename... Parts>
  void
  say(const Parts&... parts) const
  {
    if (remark_)
      remark_(sentence(parts...));
  }

private:
  std::uint32_t
  classOf(const fs::path& annotation) const
  {
    const std::string stem = annotation.stem().string();
    const std::string name = stem.substr(0, stem.find('_'));
    if (const auto number = classNumber(s3disClasses(), name))
      return *number;
    say(annotation.string(),
        ": '",
        name,
        "' is no class of S3DIS; its points are taken as clutter");
    return *classNumber(s3disClasses(), "clutter");
  }

  void
  takeLine(const std::string& path, std::string_view line, std::size_t number)
  {
    if (const auto point = parseS3DISLine<Coordinate>(line))
      points_.push_back(*point);
    else if (hasControlByte(line))
      repairLine(path, line, number);
    else
      throw CIDException(sentence(
          path, ": line ", number, ": is '", printable(line), "'; ", what_a_line_is));
  }

  void
  repairLine(const std::string& path, std::string_view line, std::size_t number)
  {
    const std::string whole = withLostBits(line);
    const auto point = parseS3DISLine<Coordinate>(whole);
    if (point)
      points_.push_back(*point);
    else
      ++left_out_;
    say(path,
        ": line ",
        number,
        ": '",
        printable(line),
        point ? "' is read as '" + whole + "'" : "' is left out");
  }

  const RemarkCallback& remark_;
  std::vector<Point> points_;
  std::vector<std::uint32_t> labels_;
  std::vector<std::uint32_t> semantics_;
  std::uint32_t instance_ = 0;
  std::uint32_t semantic_ = 0;
  std::size_t left_out_ = 0; ///< lines
};

/** The room once more; what there is to remark on has been said. */
LabelledCloud
readInDouble(const RoomFiles& files, const std::string& folder)
{
  const RemarkCallback nobody;
  RoomReading<double> reading(nobody);
  reading.takeAll(files);
  return reading.cloud(folder);
}

} // namespace

bool
isS3DISRoom(const std::string& path)
{
  std::error_code error;
  return fs::is_directory(fs::path(path) / "Annotations", error);
}

std::vector<std::string>
s3disRoomFiles(const std::string& folder)
{
  const RoomFiles files(folder);
  std::vector<std::string> list;
  for (const fs::path& annotation : files.annotations)
    list.push_back(annotation.string());
  if (!files.room.empty())
    list.push_back(files.room.string());
  return list;
}

LabelledCloud
readS3DISRoom(const std::string& folder, const RemarkCallback& remark)
{
  const RoomFiles files(folder);
  if (files.annotations.empty())
    throw CIDException(folder + ": has no annotation; Annotations/<class>_<k>.txt "
                                "must hold the points of each instance");
  RoomReading<float> reading(remark);
  for (const fs::path& other : files.others)
    reading.say(other.string(), ": is no .txt file and is passed over");
  reading.takeAll(files);
  if (files.room.empty())
    reading.say(folder,
                ": has no file of the whole room to check the number of points by");
  else
    reading.check(files.room);
  return reading.isFarAway() ? readInDouble(files, folder) : reading.cloud(folder);
}

} // namespace pcl_cid
