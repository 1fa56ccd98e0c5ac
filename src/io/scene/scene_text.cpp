/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the writers of scenes share: numbers, colors and names as text.
 */

#include "scene_text.h"

#include "base/sentence.h"
#include "text/numbers.h"
#include "text/path_names.h"

#include <pcl_cid/io/mesh_export.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

/** XML 1.0 and formats made of lines have no place for control characters. */
void
requirePrintable(const char* what, const std::string& text)
{
  const auto is_control = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  };
  if (std::any_of(text.begin(), text.end(), is_control))
    throw CIDException(
        sentence(what, " '", text, "' holds a control character; choose another name"));
}

constexpr const char* folder_of_meshes = "the folder of the meshes";

bool
isURI(const std::string& folder)
{
  return folder.find("://") != std::string::npos;
}

} // namespace

std::string
numbers(std::initializer_list<double> values)
{
  std::string text;
  for (const double value : values) {
    if (!text.empty())
      text += ' ';
    appendNumber(value, text);
  }
  return text;
}

std::string
numbers(const Eigen::Vector3d& v)
{
  return numbers({v.x(), v.y(), v.z()});
}

std::string
rgba(std::size_t part)
{
  const PartColor color = partColor(part);
  return numbers({color.red / 255.0, color.green / 255.0, color.blue / 255.0, 1.0});
}

Eigen::Vector3d
linearColor(std::size_t part)
{
  const PartColor color = partColor(part);
  const auto linear = [](std::uint8_t channel) { // the curve of sRGB
    const double value = channel / 255.0;
    const double light =
        value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    return std::round(1e6 * light) / 1e6;
  };
  return {linear(color.red), linear(color.green), linear(color.blue)};
}

void
requireName(const char* what, const std::string& name)
{
  if (name.empty())
    throw CIDException(sentence(what, " is empty; give it a name"));
  requirePrintable(what, name);
}

std::string
escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

const HullPrimitive*
primitiveOf(std::size_t part,
            const SceneDescription& scene,
            const std::vector<HullPrimitive::Kind>& kinds)
{
  const HullPrimitive* primitive = primitiveOf(part, scene);
  const bool is_known =
      primitive &&
      std::find(kinds.begin(), kinds.end(), primitive->kind) != kinds.end();
  return is_known ? primitive : nullptr;
}

std::vector<HullPrimitive::Kind>
kindsWithoutCapsule()
{
  return {HullPrimitive::Kind::box,
          HullPrimitive::Kind::sphere,
          HullPrimitive::Kind::cylinder};
}

std::vector<HullPrimitive::Kind>
allKinds()
{
  return PrimitiveOptions().kinds;
}

std::string
rollPitchYaw(const Eigen::Matrix3d& axes)
{
  const Eigen::Vector3d angles = axes.eulerAngles(2, 1, 0);
  return numbers({angles[2], angles[1], angles[0]});
}

std::string
meshReference(std::size_t part, const SceneDescription& scene)
{
  std::string folder = scene.mesh_folder;
  if (!folder.empty() && folder.back() != '/')
    folder += '/';
  return escaped(folder + partFileName(part, scene));
}

const std::string&
linkName(const SceneDescription& scene)
{
  return scene.frame.empty() ? scene.name : scene.frame;
}

void
requireMeshFolder(const std::string& folder)
{
  requirePrintable(folder_of_meshes, folder);
  const std::vector<std::string> beginnings = {
      "package://", "model://", "file:///", "http://", "https://"};
  const auto is_beginning = [&](const std::string& beginning) {
    return folder.rfind(beginning, 0) == 0 &&
           (folder.size() > beginning.size() || beginning == "file:///");
  };
  if (isURI(folder) && std::none_of(beginnings.begin(), beginnings.end(), is_beginning))
    throw CIDException(sentence(folder_of_meshes,
                                " is '",
                                folder,
                                "'; it must be a path, or begin with ",
                                listed(beginnings),
                                " and go on with a name"));
}

void
requireMeshFolderForMJCF(const std::string& folder)
{
  requirePrintable(folder_of_meshes, folder);
  if (isURI(folder))
    throw CIDException(sentence(folder_of_meshes,
                                " is '",
                                folder,
                                "'; MuJoCo reads no URI, it must be a path"));
}

} // namespace pcl_cid
