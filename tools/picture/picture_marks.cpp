/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The labels, groups or parts of a picture, which have a color each.
 */

#include "picture_marks.h"

#include "page_data.h"

#include <algorithm>
#include <numeric>

namespace pcl_cid::tools {
namespace {

using Json = nlohmann::ordered_json;

/** All but 0, ascending. */
std::vector<std::uint32_t>
labelsIn(std::vector<std::uint32_t> labels)
{
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  if (!labels.empty() && labels.front() == 0)
    labels.erase(labels.begin());
  return labels;
}

std::vector<std::uint32_t>
indexByLabel(const std::vector<std::uint32_t>& labels,
             const std::vector<std::uint32_t>& distinct)
{
  std::vector<std::uint32_t> index;
  index.reserve(labels.size());
  for (const std::uint32_t label : labels) {
    const auto at = std::lower_bound(distinct.begin(), distinct.end(), label);
    index.push_back(label == 0 ? 0
                               : static_cast<std::uint32_t>(at - distinct.begin()) + 1);
  }
  return index;
}

std::string
nameOf(const NamedInstance& instance)
{
  if (!instance.name.empty())
    return instance.name;
  return (instance.class_name.empty() ? "Label" : instance.class_name) + " " +
         std::to_string(instance.label);
}

std::string
nameOfLabel(std::uint32_t label, const Picture& picture)
{
  for (const NamedInstance& instance : picture.instances)
    if (instance.label == label)
      return nameOf(instance);
  return nameOf({label, "", ""});
}

std::string
nameOfNone(Picture::Kind kind)
{
  return kind == Picture::Kind::parts    ? "in no part"
         : kind == Picture::Kind::groups ? "in no group"
                                         : "no label";
}

std::string
nameOf(std::uint32_t index, const PictureMarks& marks, const Picture& picture)
{
  if (picture.kind == Picture::Kind::parts)
    return "Part " + std::to_string(index - 1);
  const std::uint32_t label = marks.labels[index - 1];
  if (picture.kind == Picture::Kind::groups) // whose numbers are labels - 1
    return "Group " + std::to_string(label - 1);
  return nameOfLabel(label, picture);
}

/** What the report says of a part, without the list of stray points. */
Json
figuresOfPart(Json part)
{
  part.erase("trimmed");
  part.erase("points");
  return part;
}

/** Unless it does not fit any more. */
void
addRow(Json row, std::size_t& left, Json& rows)
{
  const std::size_t size = textInPage(row).size() + 1;
  if (size > left)
    return;
  left -= size;
  rows.push_back(std::move(row));
}

} // namespace

PictureMarks
marksOf(const Picture& picture, std::size_t cloud_size, const pcl::Indices& finite)
{
  PictureMarks marks;
  std::size_t size = 0;
  if (picture.parts != nullptr) {
    size = picture.parts->size();
    marks.index.assign(cloud_size, 0);
    for (std::size_t k = 0; k < size; ++k)
      for (const pcl::index_t point : (*picture.parts)[k].indices)
        marks.index[static_cast<std::size_t>(point)] =
            static_cast<std::uint32_t>(k + 1);
  }
  else {
    marks.labels = labelsIn(*picture.labels);
    marks.index = indexByLabel(*picture.labels, marks.labels);
    size = marks.labels.size();
  }
  marks.points.assign(size + 1, 0);
  for (const pcl::index_t point : finite)
    ++marks.points[marks.index[static_cast<std::size_t>(point)]];
  marks.by_size.resize(size);
  std::iota(marks.by_size.begin(), marks.by_size.end(), 1u);
  std::stable_sort(marks.by_size.begin(),
                   marks.by_size.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     return marks.points[a] > marks.points[b];
                   });
  return marks;
}

nlohmann::ordered_json
rowsOf(const PictureMarks& marks,
       const Picture& picture,
       const nlohmann::ordered_json& parts,
       std::size_t most_bytes)
{
  Json rows = Json::array();
  for (const std::uint32_t index : marks.by_size) {
    Json row = {{"index", index},
                {"name", nameOf(index, marks, picture)},
                {"points", marks.points[index]}};
    if (!parts.is_null())
      row.update(figuresOfPart(parts[index - 1]));
    addRow(std::move(row), most_bytes, rows);
  }
  if (marks.points[0] > 0)
    rows.push_back({{"index", 0},
                    {"name", nameOfNone(picture.kind)},
                    {"points", marks.points[0]}});
  return rows;
}

} // namespace pcl_cid::tools
