/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The primitives of scenes, read back to check them.
 */

#include "primitive_readers.h"

#include "mesh_readers.h"

#include <pcl_cid/exceptions.h>

#include <array>
#include <istream>
#include <limits>
#include <sstream>
#include <variant>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

using Kind = HullPrimitive::Kind;
using Xml = boost::property_tree::ptree;

/** So many numbers from a text. */
std::vector<double>
take(std::istream& text, std::size_t count)
{
  std::vector<double> values(count);
  for (double& value : values)
    text >> value;
  if (!text)
    throw CIDException("a number is missing in a primitive");
  return values;
}

std::vector<double>
numbersOf(const std::string& text, std::size_t count)
{
  std::istringstream stream(text);
  return take(stream, count);
}

std::string
attribute(const Xml& node, const std::string& name)
{
  return node.get<std::string>("<xmlattr>." + name);
}

/** A pose of a position and three angles, of which the first turns first. */
void
setPose(const std::vector<double>& pose, HullPrimitive& primitive)
{
  primitive.center = {pose[0], pose[1], pose[2]};
  primitive.axes = (Eigen::AngleAxisd(pose[5], Eigen::Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(pose[4], Eigen::Vector3d::UnitY()) *
                    Eigen::AngleAxisd(pose[3], Eigen::Vector3d::UnitX()))
                       .toRotationMatrix();
}

HullPrimitive
box(const std::vector<double>& size)
{
  HullPrimitive primitive;
  primitive.extents = {size[0], size[1], size[2]};
  return primitive;
}

/** What is round, by the length from end to end. */
HullPrimitive
roundOne(Kind kind, double radius, double length)
{
  HullPrimitive primitive;
  primitive.kind = kind;
  primitive.extents = {2.0 * radius, 2.0 * radius, length};
  return primitive;
}

/** Errors of Boost get a type that is ours. */
Xml
readXml(std::istream& stream)
{
  Xml xml;
  try {
    boost::property_tree::read_xml(stream, xml);
  }
  catch (const boost::property_tree::ptree_error& error) {
    throw CIDException(error.what());
  }
  return xml;
}

/** Call \a read with all children of this name. */
template <typename Read>
void
forEach(const Xml& parent, const std::string& name, const Read& read)
{
  for (const auto& [key, child] : parent)
    if (key == name)
      read(child);
}

/** Read XML by a function; what it does not find is an error of ours. */
template <typename Read>
NamedPrimitives
readFrom(std::istream& stream, const Read& read)
{
  const Xml xml = readXml(stream);
  NamedPrimitives primitives;
  try {
    read(xml, primitives);
  }
  catch (const boost::property_tree::ptree_error& error) {
    throw CIDException(error.what());
  }
  return primitives;
}

void
addOfURDF(const Xml& collision, NamedPrimitives& primitives)
{
  const auto& [shape, node] = collision.get_child("geometry").front();
  if (shape == "mesh")
    return;
  const auto number = [&node = node](const char* name) {
    return numbersOf(attribute(node, name), 1)[0];
  };
  HullPrimitive primitive;
  if (shape == "box")
    primitive = box(numbersOf(attribute(node, "size"), 3));
  else if (shape == "sphere")
    primitive = roundOne(Kind::sphere, number("radius"), 2.0 * number("radius"));
  else if (shape == "cylinder")
    primitive = roundOne(Kind::cylinder, number("radius"), number("length"));
  else
    throw CIDException("the shape '" + shape + "' is unknown");
  const Xml& origin = collision.get_child("origin");
  setPose(numbersOf(attribute(origin, "xyz") + " " + attribute(origin, "rpy"), 6),
          primitive);
  primitives[attribute(collision, "name")] = primitive;
}

void
addOfSDF(const Xml& collision, NamedPrimitives& primitives)
{
  const auto& [shape, node] = collision.get_child("geometry").front();
  if (shape == "mesh")
    return;
  const auto number = [&node = node](const char* name) {
    return numbersOf(node.get<std::string>(name), 1)[0];
  };
  HullPrimitive primitive;
  if (shape == "box")
    primitive = box(numbersOf(node.get<std::string>("size"), 3));
  else if (shape == "sphere")
    primitive = roundOne(Kind::sphere, number("radius"), 2.0 * number("radius"));
  else if (shape == "cylinder")
    primitive = roundOne(Kind::cylinder, number("radius"), number("length"));
  else if (shape == "capsule")
    primitive = roundOne(
        Kind::capsule, number("radius"), number("length") + 2.0 * number("radius"));
  else
    throw CIDException("the shape '" + shape + "' is unknown");
  setPose(numbersOf(collision.get<std::string>("pose"), 6), primitive);
  primitives[attribute(collision, "name")] = primitive;
}

void
addOfMJCF(const Xml& geom, NamedPrimitives& primitives)
{
  const std::string type = attribute(geom, "type");
  if (type == "mesh")
    return;
  const auto sizes = [&](std::size_t count) {
    return numbersOf(attribute(geom, "size"), count);
  };
  HullPrimitive primitive;
  if (type == "box")
    primitive = box(sizes(3));
  else if (type == "sphere")
    primitive = roundOne(Kind::sphere, sizes(1)[0], sizes(1)[0]);
  else if (type == "cylinder")
    primitive = roundOne(Kind::cylinder, sizes(2)[0], sizes(2)[1]);
  else if (type == "capsule")
    primitive = roundOne(Kind::capsule, sizes(2)[0], sizes(2)[1] + sizes(2)[0]);
  else
    throw CIDException("the shape '" + type + "' is unknown");
  // Sizes are halves, but for radii, of which roundOne() has made diameters.
  if (type == "box")
    primitive.extents *= 2.0;
  else
    primitive.extents.z() *= 2.0;
  const std::vector<double> position = numbersOf(attribute(geom, "pos"), 3);
  primitive.center = {position[0], position[1], position[2]};
  const std::vector<double> turn = numbersOf(attribute(geom, "quat"), 4);
  primitive.axes = Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3])
                       .normalized()
                       .toRotationMatrix();
  primitives[attribute(geom, "name")] = primitive;
}

TriangleMesh
meshOfMoveIt(std::istream& stream)
{
  const std::vector<double> counts = take(stream, 2);
  TriangleMesh mesh;
  for (double i = 0; i < counts[0]; ++i) {
    const std::vector<double> place = take(stream, 3);
    mesh.vertices.emplace_back(place[0], place[1], place[2]);
  }
  for (double i = 0; i < counts[1]; ++i) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::uint32_t& corner : triangle)
      if (!(stream >> corner) || corner >= mesh.vertices.size())
        throw CIDException("a triangle has a corner that is none");
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/** The shape of an object. */
std::variant<HullPrimitive, TriangleMesh>
shapeOfMoveIt(std::istream& stream)
{
  std::string shape;
  stream >> shape;
  if (shape == "box")
    return box(take(stream, 3));
  if (shape == "sphere") {
    const double radius = take(stream, 1)[0];
    return roundOne(Kind::sphere, radius, 2.0 * radius);
  }
  if (shape == "cylinder") {
    const std::vector<double> size = take(stream, 2);
    return roundOne(Kind::cylinder, size[0], size[1]);
  }
  if (shape != "mesh")
    throw CIDException("the shape '" + shape + "' is unknown");
  return meshOfMoveIt(stream);
}

/** Call \a read with name, pose and shape of each object. */
template <typename Read>
void
forEachObjectOfMoveIt(std::istream& stream, const Read& read)
{
  constexpr std::size_t numbers_after_shape = 7 + 4 + 1; // pose, color, subframes
  stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  std::string name;
  for (std::string marker; stream >> marker && marker == "*";) {
    stream >> name;
    const std::vector<double> pose = take(stream, 7);
    if (take(stream, 1)[0] != 1.0)
      throw CIDException("the object " + name + " has several shapes");
    read(name, pose, shapeOfMoveIt(stream));
    take(stream, numbers_after_shape);
  }
}

} // namespace

NamedPrimitives
readPrimitivesOfURDF(std::istream& stream)
{
  return readFrom(stream, [](const Xml& xml, NamedPrimitives& primitives) {
    forEach(xml.get_child("robot.link"), "collision", [&](const Xml& collision) {
      addOfURDF(collision, primitives);
    });
  });
}

NamedPrimitives
readPrimitivesOfSDF(std::istream& stream)
{
  return readFrom(stream, [](const Xml& xml, NamedPrimitives& primitives) {
    forEach(xml.get_child("sdf.model.link"), "collision", [&](const Xml& collision) {
      addOfSDF(collision, primitives);
    });
  });
}

NamedPrimitives
readPrimitivesOfMJCF(std::istream& stream)
{
  return readFrom(stream, [](const Xml& xml, NamedPrimitives& primitives) {
    forEach(xml.get_child("mujoco.worldbody"), "geom", [&](const Xml& geom) {
      addOfMJCF(geom, primitives);
    });
  });
}

NamedPrimitives
readPrimitivesOfMoveIt(std::istream& stream)
{
  NamedPrimitives primitives;
  forEachObjectOfMoveIt(
      stream, [&](const auto& name, const std::vector<double>& pose, auto shape) {
        if (auto* const primitive = std::get_if<HullPrimitive>(&shape)) {
          primitive->center = {pose[0], pose[1], pose[2]};
          primitive->axes = Eigen::Quaterniond(pose[6], pose[3], pose[4], pose[5])
                                .normalized()
                                .toRotationMatrix();
          primitives[name] = *primitive;
        }
      });
  return primitives;
}

NamedMeshes
readMeshesOfMoveIt(std::istream& stream)
{
  NamedMeshes meshes;
  forEachObjectOfMoveIt(
      stream, [&](const auto& name, const std::vector<double>& pose, auto shape) {
        if (auto* const mesh = std::get_if<TriangleMesh>(&shape)) {
          if (pose[3] != 0.0 || pose[4] != 0.0 || pose[5] != 0.0)
            throw CIDException("the mesh " + name + " is turned");
          meshes[name] = {*mesh, {pose[0], pose[1], pose[2]}};
        }
      });
  return meshes;
}

} // namespace pcl_cid
