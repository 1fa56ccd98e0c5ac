/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pages get: the page, and the scan.
 */

#include "scan_resources.h"

#include <pcl_cid/io/scene_formats.h>
#include <pcl_cid/version.h>

#include <nlohmann/json.hpp>

namespace pcl_cid::studio {
namespace {

using Json = nlohmann::json;

template <typename Vector>
Json
triple(const Vector& v)
{
  return {v.x(), v.y(), v.z()};
}

template <typename Value>
Resource
numbers(const std::vector<Value>& values)
{
  return {"application/octet-stream",
          false,
          {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)},
          nullptr};
}

/** The scenes that parts are exported in. */
Json
scenes()
{
  Json list = Json::array();
  for (const SceneFormat& format : sceneFormats())
    list.push_back({{"name", format.option}, {"help", format.help}});
  return list;
}

} // namespace

ScanResources::ScanResources(const Resources& page,
                             const ScanFacts& facts,
                             const PointSet& points,
                             const Places& places,
                             const std::vector<ColorRGB>& colors)
: page_(page)
{
  Eigen::Array3f low = points.points.front();
  Eigen::Array3f high = low;
  positions_.reserve(places.size());
  for (std::size_t place = 0; place < places.size(); ++place) {
    positions_.push_back(points.points[places.member(place)]);
    low = low.min(positions_.back().array());
    high = high.max(positions_.back().array());
    if (colors.empty())
      continue;
    const ColorRGB& color = colors[static_cast<std::size_t>(places.point(place))];
    colors_.insert(colors_.end(), {color.r, color.g, color.b});
  }
  Json classes = Json::array();
  for (const std::string& name : facts.classes)
    classes.push_back({{"name", name}});
  facts_ = Json{{"name", facts.name},
                {"session", facts.session},
                {"places", places.size()},
                {"points", facts.points},
                {"low", triple(low)},
                {"high", triple(high)},
                {"origin", triple(facts.origin)},
                {"up", triple(facts.up)},
                {"has_color", !colors.empty()},
                {"classes", std::move(classes)},
                {"meshes", facts.meshes},
                {"scenes", scenes()},
                {"version", PCL_CID_VERSION}}
               .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Resource>
ScanResources::find(std::string_view path) const
{
  if (path == "/api/scan")
    return textResource(facts_, "application/json");
  if (path == "/api/positions")
    return numbers(positions_);
  if (path == "/api/colors" && !colors_.empty())
    return numbers(colors_);
  return page_.find(path);
}

} // namespace pcl_cid::studio
