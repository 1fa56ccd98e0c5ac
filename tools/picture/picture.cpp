/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan and what was made of it as one page for the browser.
 */

#include "picture.h"

#include "page_data.h"
#include "page_template.h"
#include "picture_marks.h"
#include "thinning.h"

#include <pcl_cid/io/scan_source.h>

#include <ostream>
#include <utility>

namespace pcl_cid::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_bytes_of_rows = 600'000;
constexpr std::size_t most_bytes_of_remarks = 100'000;
constexpr std::size_t bytes_of_hull_facts = 200; // and a little more

/** What is drawn of a scan. */
struct ShownPoints {
  PointSet finite;
  Frame frame; ///< of these, in the frame of the file
  Eigen::AlignedBox3f box;
  std::vector<std::size_t> positions; ///< of those that are shown, among these

  std::size_t
  source(std::size_t position) const
  {
    return static_cast<std::size_t>(finite.source[position]);
  }
};

ShownPoints
shownPoints(const LoadedScan& scan)
{
  ShownPoints shown;
  shown.finite = finitePoints(*scan.points.points);
  shown.frame = {scan.points.frame.toFile(shown.finite.frame.origin)};
  shown.box = usualBox(shown.finite.points);
  shown.positions = spreadEvenly(shown.finite.points, shown.box, most_picture_points);
  return shown;
}

/** As many as fit. */
Json
someRemarks(const Json& remarks)
{
  Json some = Json::array();
  std::size_t left = most_bytes_of_remarks;
  for (const Json& remark : remarks) {
    const std::size_t size = textInPage(remark).size();
    if (size > left)
      break;
    left -= size;
    some.push_back(remark);
  }
  return some;
}

/** What the report says, but for what differs from run to run, and for lists. */
Json
reportedFigures(Json report)
{
  report.erase("seconds");
  report.erase("peak_memory_bytes");
  report["parameters"].erase("threads");
  const Json seeds = std::exchange(report["seeds"], nullptr);
  if (seeds.empty())
    report.erase("seeds");
  else
    report["seeds"] = {{"number", seeds.size()},
                       {"coverage", seeds.back()["coverage"]}};
  if (report.contains("parts"))
    report["parts"] = report["parts"].size();
  if (report.contains("remarks"))
    report["remarks"] = someRemarks(report["remarks"]);
  return report;
}

const char*
wordOf(Picture::Kind kind)
{
  switch (kind) {
  case Picture::Kind::labels:
    return "labels";
  case Picture::Kind::groups:
    return "groups";
  case Picture::Kind::parts:
    return "parts";
  default:
    return "values";
  }
}

template <typename Vector>
Json
triple(const Vector& v)
{
  return {v.x(), v.y(), v.z()};
}

/** One value of each point that is shown. */
template <typename Value>
std::vector<Value>
ofShown(const ShownPoints& shown, const std::vector<Value>& of_cloud)
{
  std::vector<Value> values;
  values.reserve(shown.positions.size());
  for (const std::size_t position : shown.positions)
    values.push_back(of_cloud[shown.source(position)]);
  return values;
}

std::vector<Eigen::Vector3f>
positionsOf(const ShownPoints& shown)
{
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(shown.positions.size());
  for (const std::size_t position : shown.positions)
    positions.push_back(shown.finite.points[position]);
  return positions;
}

/** The points of a picture, as elements of its page. */
std::string
pointElements(const ShownPoints& shown,
              const Picture& picture,
              const PictureMarks& marks,
              const LabelledCloud& cloud)
{
  std::string elements = dataElement("positions", bytesOf(positionsOf(shown)));
  static_assert(sizeof(ColorRGB) == 3);
  std::vector<ColorRGB> colors;
  if (hasColors(cloud))
    colors = ofShown(shown, colorsOf(cloud));
  elements += dataElement("colors", bytesOf(colors));
  std::vector<float> values;
  if (picture.values != nullptr)
    values = ofShown(shown, *picture.values);
  elements += dataElement("values", bytesOf(values));
  std::vector<std::uint32_t> labels;
  if (!marks.index.empty())
    labels = ofShown(shown, marks.index);
  return elements + dataElement("labels", bytesOf(labels));
}

/** Hulls of a picture: what is said of each, and all their vertices and triangles. */
struct HullData {
  Json facts = Json::array();
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

void
addHull(const ConvexPart& part,
        std::uint32_t index,
        const Frame& frame,
        HullData& hulls)
{
  hulls.facts.push_back({{"part", index},
                         {"vertices", part.hull.vertices.size()},
                         {"triangles", part.hull.triangles.size()},
                         {"volume", part.volume},
                         {"thickness", part.thickness},
                         {"thickened", part.thickened},
                         {"boxed", part.boxed}});
  for (const Eigen::Vector3d& vertex : part.hull.vertices)
    hulls.vertices.push_back(frame.toLocal(vertex).cast<float>());
  hulls.triangles.insert(
      hulls.triangles.end(), part.hull.triangles.begin(), part.hull.triangles.end());
}

/** The hulls of the parts with the most points, as far as they fit. */
HullData
hullsOf(const Picture& picture,
        const PictureMarks& marks,
        const Frame& frame,
        std::size_t most_bytes)
{
  HullData hulls;
  if (picture.parts == nullptr)
    return hulls;
  for (const std::uint32_t index : marks.by_size) {
    const ConvexPart& part = (*picture.parts)[index - 1];
    const std::size_t size =
        bytes_of_hull_facts +
        sizeInBase64(sizeof(Eigen::Vector3f) *
                     (part.hull.vertices.size() + part.hull.triangles.size()));
    if (size > most_bytes)
      continue;
    most_bytes -= size;
    addHull(part, index, frame, hulls);
  }
  return hulls;
}

Json
factsOf(const Picture& picture,
        const ShownPoints& shown,
        const PictureMarks& marks,
        const std::string& name,
        const Report& report)
{
  const Json all = Json::parse(toJson(report));
  Json rows = Json::array();
  if (!marks.index.empty())
    rows =
        rowsOf(marks, picture, all.value("parts", Json(nullptr)), most_bytes_of_rows);
  return {{"kind", wordOf(picture.kind)},
          {"name", name},
          {"values", picture.values_text},
          {"points", shown.positions.size()},
          {"origin", triple(shown.frame.origin)},
          {"low", triple(shown.box.min())},
          {"high", triple(shown.box.max())},
          {"indices", marks.by_size.size()},
          {"marks", std::move(rows)},
          {"report", reportedFigures(all)}};
}

/** What goes into the page. */
std::string
contentOf(const Picture& picture,
          const ShownPoints& shown,
          const LoadedScan& scan,
          std::size_t most_bytes,
          Run& run)
{
  PictureMarks marks;
  if (picture.kind != Picture::Kind::values)
    marks = marksOf(picture, scan.cloud.size(), shown.finite.source);
  Json facts = factsOf(picture, shown, marks, scan.name, run.report);
  std::string points = pointElements(shown, picture, marks, scan.cloud);
  const std::size_t taken = points.size() + dataElement("facts", facts).size() + 1000;
  HullData hulls =
      hullsOf(picture, marks, shown.frame, most_bytes > taken ? most_bytes - taken : 0);
  if (picture.parts != nullptr && hulls.facts.size() < picture.parts->size())
    run.console.value("Hulls in the picture",
                      std::to_string(hulls.facts.size()) + " of " +
                          std::to_string(picture.parts->size()) +
                          ", those of the parts with the most points");
  facts["hulls"] = std::move(hulls.facts);
  return dataElement("facts", facts) + points +
         dataElement("hull_vertices", bytesOf(hulls.vertices)) +
         dataElement("hull_triangles", bytesOf(hulls.triangles));
}

} // namespace

void
declarePictureOption(std::string& html, CommandLine& line)
{
  line.file(
      "html",
      "FILE.html",
      {".html"},
      html,
      "write a page for the browser that shows what was made: the scan, thinned to "
      "at most " +
          std::to_string(most_picture_points) +
          " points, in its labels or parts, the hulls, and the figures of the "
          "report; it needs no server and no network");
}

void
announcePicture(const std::string& html, OutputFiles& outputs)
{
  if (html.empty())
    return;
  requirePageTemplate(pageTemplate());
  outputs.announce(html);
}

void
requirePictureOf(const std::string& html, const LoadedScan& scan)
{
  if (!html.empty() && hasColors(scan.cloud))
    colorsOf(scan.cloud);
}

void
savePicture(const std::string& html,
            const Picture& picture,
            const LoadedScan& scan,
            Run& run)
{
  if (html.empty())
    return;
  run.begin("Saving " + html);
  const ShownPoints shown = shownPoints(scan);
  const std::string_view page = pageTemplate();
  const std::string content =
      contentOf(picture, shown, scan, most_picture_bytes - page.size(), run);
  run.outputs.write(html,
                    [&](std::ostream& stream) { stream << filledPage(page, content); });
  run.end(std::to_string(shown.positions.size()) + " of " +
              std::to_string(shown.finite.size()) + " points",
          "html");
}

} // namespace pcl_cid::tools
