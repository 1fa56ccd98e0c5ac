/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts as a scene for robot software: URDF, SDF, MJCF, MoveIt.
 */

#include "base/sentence.h"
#include "field_values.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <algorithm>
#include <ostream>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

constexpr const char* xml_declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/** Numbers with a space between them. */
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

/** Red, green, blue, opacity, each 0 to 1. */
std::string
rgba(std::size_t part)
{
  const PartColour colour = partColour(part);
  return numbers({colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, 1.0});
}

/** The formats are made of lines and of XML 1.0, which have no place for these. */
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

void
requireName(const char* what, const std::string& name)
{
  if (name.empty())
    throw CIDException(sentence(what, " is empty; give it a name"));
  requirePrintable(what, name);
}

/** For element content and for attributes in double quotes. */
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

/** Where a scene's file finds the mesh of a part, for XML. */
std::string
meshReference(std::size_t part, const SceneDescription& scene)
{
  requirePrintable("the folder of the meshes", scene.mesh_folder);
  const std::string folder =
      scene.mesh_folder.empty() ? std::string() : scene.mesh_folder + '/';
  return escaped(folder + partFileName(part, scene.mesh_format));
}

TriangleMesh
localMesh(const ConvexPart& part, const SceneDescription& scene)
{
  TriangleMesh mesh = part.hull;
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex -= scene.origin;
  return mesh;
}

const char*
extensionOf(PartFormat format)
{
  return format == PartFormat::obj ? ".obj" : ".stl";
}

} // namespace

Eigen::Vector3d
sceneOrigin(const std::vector<ConvexPart>& parts)
{
  constexpr double far_away = 1000.0;
  Eigen::AlignedBox3d box;
  for (const ConvexPart& part : parts)
    for (const Eigen::Vector3d& vertex : part.hull.vertices)
      box.extend(vertex);
  if (box.isEmpty() ||
      box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff() <= far_away)
    return Eigen::Vector3d::Zero();
  return box.center().array().round();
}

std::string
partFileName(std::size_t part, PartFormat format)
{
  return partName(part) + extensionOf(format);
}

bool
isPartFileName(const std::string& name)
{
  const std::size_t dot = name.rfind('.');
  const std::size_t digits = std::min(name.find_first_of("0123456789"), name.size());
  std::uint64_t part = 0;
  if (dot == std::string::npos || digits > dot ||
      !parseValue(name.substr(digits, dot - digits),
                  pcl::PCLPointField::UINT64,
                  reinterpret_cast<std::uint8_t*>(&part)))
    return false;
  return name == partFileName(part, PartFormat::obj) ||
         name == partFileName(part, PartFormat::stl);
}

void
writePartMesh(std::ostream& stream,
              const std::vector<ConvexPart>& parts,
              std::size_t part,
              const SceneDescription& scene)
{
  const TriangleMesh mesh = localMesh(parts[part], scene);
  if (scene.mesh_format == PartFormat::obj)
    writeOBJMesh(stream, mesh, partName(part));
  else
    writeSTLMesh(stream, mesh);
}

void
writeURDF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene)
{
  requireName("the robot's name", scene.name);
  requireName("the frame", scene.frame);
  const std::string origin =
      "      <origin xyz=\"" + numbers(scene.origin) + "\" rpy=\"0 0 0\"/>\n";
  stream << xml_declaration << "<robot name=\"" << escaped(scene.name)
         << "\">\n  <link name=\"" << escaped(scene.frame) << "\">\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string name = partName(i);
    const std::string geometry = origin + "      <geometry><mesh filename=\"" +
                                 meshReference(i, scene) + "\"/></geometry>\n";
    stream << "    <visual name=\"" << name << "\">\n"
           << geometry << "      <material name=\"" << name << "\"><color rgba=\""
           << rgba(i) << "\"/></material>\n    </visual>\n    <collision name=\""
           << name << "\">\n"
           << geometry << "    </collision>\n";
  }
  stream << "  </link>\n</robot>\n";
}

void
requireFrameForSDF(const std::string& frame)
{
  requireName("the frame", frame);
  const bool has_underscores = frame.size() >= 4 && frame.substr(0, 2) == "__" &&
                               frame.substr(frame.size() - 2) == "__";
  if (frame == "world" || has_underscores || frame.find("::") != std::string::npos)
    throw CIDException(
        sentence("the frame is '",
                 frame,
                 "'; SDF reserves 'world', '__NAME__' and '::', choose another name"));
}

void
writeSDF(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const SceneDescription& scene)
{
  requireName("the model's name", scene.name);
  requireFrameForSDF(scene.frame);
  const std::string pose = "        <pose>" + numbers(scene.origin) + " 0 0 0</pose>\n";
  stream << xml_declaration << "<sdf version=\"1.9\">\n  <model name=\""
         << escaped(scene.name) << "\">\n    <static>true</static>\n    <link name=\""
         << escaped(scene.frame) << "\">\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string name = partName(i);
    const std::string geometry = pose + "        <geometry><mesh><uri>" +
                                 meshReference(i, scene) + "</uri></mesh></geometry>\n";
    const std::string colour = rgba(i);
    stream << "      <visual name=\"" << name << "\">\n"
           << geometry << "        <material><ambient>" << colour
           << "</ambient><diffuse>" << colour
           << "</diffuse></material>\n      </visual>\n      <collision name=\"" << name
           << "\">\n"
           << geometry << "      </collision>\n";
  }
  stream << "    </link>\n  </model>\n</sdf>\n";
}

void
writeMJCF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene)
{
  requireName("the model's name", scene.name);
  stream << xml_declaration << "<mujoco model=\"" << escaped(scene.name)
         << "\">\n  <asset>\n";
  for (std::size_t i = 0; i < parts.size(); ++i)
    stream << "    <mesh name=\"" << partName(i) << "\" file=\""
           << meshReference(i, scene) << "\"/>\n";
  stream << "  </asset>\n  <worldbody>\n";
  const std::string pose = numbers(scene.origin);
  for (std::size_t i = 0; i < parts.size(); ++i)
    stream << "    <geom name=\"" << partName(i) << "\" type=\"mesh\" mesh=\""
           << partName(i) << "\" pos=\"" << pose << "\" rgba=\"" << rgba(i) << "\"/>\n";
  stream << "  </worldbody>\n</mujoco>\n";
}

void
writeMoveItScene(std::ostream& stream,
                 const std::vector<ConvexPart>& parts,
                 const SceneDescription& scene)
{
  constexpr const char* identity = "0 0 0\n0 0 0 1\n"; // position, quaternion x y z w
  requireName("the scene's name", scene.name);
  stream << scene.name << '\n';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TriangleMesh mesh = localMesh(parts[i], scene);
    std::string text = "* " + partName(i) + '\n' + numbers(scene.origin) +
                       "\n0 0 0 1\n1\nmesh\n" + std::to_string(mesh.vertices.size()) +
                       ' ' + std::to_string(mesh.triangles.size()) + '\n';
    for (const Eigen::Vector3d& vertex : mesh.vertices)
      text += numbers(vertex) + '\n';
    for (const auto& [a, b, c] : mesh.triangles)
      text +=
          std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
    stream << text << identity << rgba(i) << "\n0\n";
  }
  stream << ".\n";
}

} // namespace pcl_cid
