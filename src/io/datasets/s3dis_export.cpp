/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labelled scans as rooms of S3DIS.
 */

#include "base/sentence.h"
#include "instance_points.h"
#include "text/numbers.h"
#include "text/path_names.h"

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/s3dis_export.h>

#include <filesystem>
#include <map>
#include <ostream>
#include <set>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

constexpr const char* no_class = "%none"; // no other class has it: "no" is no number
constexpr std::size_t longest_name = 200; // bytes; file systems take 255 in all

/** The lines of the points, the same wherever they stand. */
class PointLines {
public:
  explicit PointLines(const LabelledCloud& cloud)
  : size_(cloud.size())
  , coordinates_(cloud)
  , is_float_(coordinates_.datatype() == pcl::PCLPointField::FLOAT32)
  , colors_(hasColors(cloud) ? colorsOf(cloud)
                             : std::vector<ColorRGB>(cloud.size(), ColorRGB{0, 0, 0}))
  {
  }

  std::size_t
  size() const
  {
    return size_;
  }

  bool
  isFinite(std::size_t point) const
  {
    return coordinates_[point].allFinite();
  }

  void
  write(std::size_t point, std::ostream& stream)
  {
    line_.clear();
    for (const double coordinate : coordinates_[point]) {
      if (is_float_)
        appendNumber(static_cast<float>(coordinate), line_);
      else
        appendNumber(coordinate, line_);
      line_ += ' ';
    }
    const ColorRGB& color = colors_[point];
    for (const int channel : {color.r, color.g, color.b}) {
      appendNumber(channel, line_);
      line_ += ' ';
    }
    line_.back() = '\n';
    stream << line_;
  }

private:
  std::size_t size_;
  FileCoordinates coordinates_;
  bool is_float_;
  std::vector<ColorRGB> colors_;
  std::string line_;
};

/** See s3disFileClass().
 *  \param[in] where what the message begins with */
std::string
fileClass(const std::string& class_name, const std::string& where)
{
  constexpr const char* digits = "0123456789abcdef";
  if (class_name.empty())
    return no_class;
  std::string name;
  for (const unsigned char byte : class_name)
    if ((byte >= 'a' && byte <= 'z') || (byte >= '0' && byte <= '9') || byte == '-')
      name += static_cast<char>(byte);
    else if (byte == ' ')
      name += '+';
    else
      name += {'%', digits[byte / 16], digits[byte % 16]};
  if (name.size() > longest_name)
    throw CIDException(sentence(where,
                                "the class '",
                                class_name,
                                "' takes ",
                                name.size(),
                                " bytes in the name of a file; it must take at most ",
                                longest_name));
  return name;
}

/** Whether it is `<class>_<n>.txt`. */
bool
isAnnotation(const fs::path& path)
{
  const std::string stem = path.stem().string();
  const std::size_t line = stem.rfind('_');
  return path.extension() == ".txt" && line != std::string::npos && line > 0 &&
         stem[0] != '.' && parseNumber<std::size_t>(stem.substr(line + 1));
}

/** One room as files. */
class RoomWriting {
public:
  RoomWriting(const std::string& folder, OutputFiles& outputs)
  : folder_(folder), annotations_(fs::path(folder) / "Annotations"), outputs_(outputs)
  {
    outputs_.announceFolder(folder);
    outputs_.announceFolder(annotations_.string());
    announceOldAnnotations();
  }

  /** The file of the room. */
  void
  writeAll(PointLines& lines)
  {
    write(folder_ / (lastName(folder_.string()) + ".txt"), [&](std::ostream& stream) {
      for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines.isFinite(i))
          lines.write(i, stream);
    });
  }

  void
  writeInstance(const InstancePoints& instance, PointLines& lines)
  {
    const std::string name =
        fileClass(instance.instance.class_name, annotations_.string() + ": ");
    const std::string number = std::to_string(++instances_of_class_[name]);
    write(annotations_ / (name + "_" + number + ".txt"), [&](std::ostream& stream) {
      for (const std::size_t point : instance.points)
        lines.write(point, stream);
    });
  }

private:
  void
  announceOldAnnotations()
  {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(annotations_, error))
      if (isAnnotation(entry.path()))
        outputs_.announceRemoval(entry.path().string());
    if (error)
      throw CIDException(annotations_.string() +
                         ": cannot be read: " + error.message());
  }

  void
  write(const fs::path& path, const std::function<void(std::ostream&)>& writer)
  {
    outputs_.announce(path.string());
    outputs_.write(path.string(), writer);
  }

  fs::path folder_;
  fs::path annotations_;
  OutputFiles& outputs_;
  std::map<std::string, std::size_t> instances_of_class_;
};

/** What the room does not say, or says otherwise. */
class RoomRemarks {
public:
  RoomRemarks(const std::string& folder, const RemarkCallback& remark)
  : folder_(folder), remark_(remark)
  {
  }

  void
  onPoints(const LabelledCloud& cloud, const PointLines& lines) const
  {
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
      left_out += lines.isFinite(i) ? 0 : 1;
    if (left_out > 0)
      say(countOf(left_out, "point"), " that are not finite are left out");
    if (!hasColors(cloud))
      say(cloud.name, " has no colors; all points are written as 0 0 0");
  }

  void
  onInstances(std::size_t labelled, const std::vector<InstancePoints>& written) const
  {
    if (labelled > written.size())
      say(countOf(labelled - written.size(), "instance"),
          " without a finite point are left out");
    std::set<std::string> unknown;
    for (const InstancePoints& each : written)
      if (!classNumber(s3disClasses(), each.instance.class_name))
        unknown.insert("'" + each.instance.class_name + "'");
    if (!unknown.empty())
      say(listed({unknown.begin(), unknown.end()}, "and"),
          ": no class of S3DIS, so most readers take it as clutter");
  }

private:
  template <typename... Parts>
  void
  say(const Parts&... parts) const
  {
    if (remark_)
      remark_(sentence(folder_, ": ", parts...));
  }

  const std::string& folder_;
  const RemarkCallback& remark_;
};

} // namespace

std::string
s3disFileClass(const std::string& class_name)
{
  return fileClass(class_name, "");
}

void
writeS3DISRoom(const LabelledCloud& cloud,
               const LabelledInstances& scan,
               const std::string& folder,
               OutputFiles& outputs,
               const RemarkCallback& remark)
{
  requireConsistent(scan, cloud.size(), cloud.name);
  PointLines lines(cloud);
  const std::vector<InstancePoints> instances =
      pointsOfInstances(scan, [&](std::size_t point) { return lines.isFinite(point); });
  RoomWriting room(folder, outputs);
  room.writeAll(lines);
  for (const InstancePoints& instance : instances)
    room.writeInstance(instance, lines);
  const RoomRemarks remarks(folder, remark);
  remarks.onPoints(cloud, lines);
  remarks.onInstances(scan.instances.size(), instances);
}

} // namespace pcl_cid
