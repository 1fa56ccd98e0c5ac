/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as an SDF.
 */

#include "base/sentence.h"
#include "primitive_readers.h"
#include "scene_rows.h"
#include "scene_text.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <ostream>

namespace pcl_cid {
namespace {

std::string
element(const std::string& name, const std::string& content)
{
  return "<" + name + ">" + content + "</" + name + ">";
}

std::string
sdfShape(const HullPrimitive& primitive)
{
  const std::string name = nameOf(primitive.kind);
  const std::string radius = element("radius", numbers({primitive.radius()}));
  switch (primitive.kind) {
  case HullPrimitive::Kind::box:
    return element(name, element("size", numbers(primitive.extents)));
  case HullPrimitive::Kind::sphere:
    return element(name, radius);
  case HullPrimitive::Kind::cylinder:
    return element(name, radius + element("length", numbers({primitive.extents.z()})));
  default:
    return element(name,
                   radius + element("length", numbers({primitive.straightLength()})));
  }
}

/** Where a part is, and its shape.
 *  \param[in] note what else there is to say about a mesh */
std::string
sdfGeometry(std::size_t part, const SceneDescription& scene, const std::string& note)
{
  const HullPrimitive* primitive = primitiveOf(part, scene, allKinds());
  const std::string shape =
      primitive ? sdfShape(*primitive)
                : element("mesh", element("uri", meshReference(part, scene)) + note);
  return "        <pose>" + numbers(primitive ? primitive->center : scene.origin) +
         " " + (primitive ? rollPitchYaw(primitive->axes) : "0 0 0") +
         "</pose>\n        " + element("geometry", shape) + "\n";
}

/** Drake takes such a mesh for a convex shape. To other programs it is an element of a
 *  namespace that is not theirs. */
constexpr const char* convex_for_drake = "<drake:declare_convex/>";

void
requireForSDF(const SceneDescription& scene)
{
  requirePartsName(scene.name);
  requireFrameForSDF(linkName(scene));
  requireMeshFolder(scene.mesh_folder);
}

} // namespace

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
  requireForSDF(scene);
  stream
      << xml_declaration
      << "<sdf version=\"1.9\" xmlns:drake=\"http://drake.mit.edu\">\n  <model name=\""
      << scene.name << "\">\n    <static>true</static>\n    <link name=\""
      << escaped(linkName(scene)) << "\">\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string name = partName(i, scene.name);
    const std::string color = rgba(i);
    stream << "      <visual name=\"" << name << "\">\n"
           << sdfGeometry(i, scene, "") << "        <material><ambient>" << color
           << "</ambient><diffuse>" << color
           << "</diffuse></material>\n      </visual>\n      <collision name=\"" << name
           << "\">\n"
           << sdfGeometry(i, scene, convex_for_drake) << "      </collision>\n";
  }
  stream << "    </link>\n  </model>\n</sdf>\n";
}

SceneFormat
sdfFormat()
{
  SceneFormat format;
  format.name = "SDF";
  format.option = "sdf";
  format.extensions = {".sdf"};
  format.help = "write an SDF 1.9: a static model";
  format.refers_to_meshes = true;
  format.names_frame = true;
  format.check = requireForSDF;
  format.write = writeSDF;
  format.primitives = allKinds();
  format.read_primitives = readPrimitivesOfSDF;
  return format;
}

} // namespace pcl_cid
