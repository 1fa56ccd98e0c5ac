/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --verify: the primitives in a scene, checked on what is in its file.
 */

#include "primitive_verification.h"

#include "file_points.h"
#include "run/words.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>

namespace pcl_cid::tools {
namespace {

/** How far a place is outside, negative inside. */
double
excessOf(const HullPrimitive& primitive, const Eigen::Vector3d& place)
{
  const Eigen::Vector3d local = primitive.axes.transpose() * (place - primitive.center);
  const double off_axis = std::hypot(local.x(), local.y());
  const double radius = 0.5 * primitive.extents.x();
  const double half = 0.5 * primitive.extents.z();
  switch (primitive.kind) {
  case HullPrimitive::Kind::box:
    return (local.cwiseAbs() - 0.5 * primitive.extents).maxCoeff();
  case HullPrimitive::Kind::sphere:
    return local.norm() - radius;
  case HullPrimitive::Kind::cylinder:
    return std::max(off_axis - radius, std::abs(local.z()) - half);
  default:
    return std::hypot(off_axis, std::max(0.0, std::abs(local.z()) - (half - radius))) -
           radius;
  }
}

/** What may be missing: coordinates have been rounded. */
double
allowanceFor(const HullPrimitive& primitive,
             const PartPoints& points,
             const Verification& verification)
{
  const double size =
      primitive.center.cwiseAbs().maxCoeff() + primitive.extents.maxCoeff();
  return 16.0 * std::numeric_limits<double>::epsilon() * size +
         std::min(roundingOf(points.points, verification.frame), unnoticed_rounding);
}

std::optional<std::string>
findPointOutside(const HullPrimitive& primitive,
                 const PartPoints& points,
                 const Verification& verification)
{
  const double allowance = allowanceFor(primitive, points, verification);
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const double excess = excessOf(primitive, points.points[i]) +
                          verification.abstracted.hull_options.padding;
    if (!(excess <= allowance))
      return "point " + std::to_string(points.indices[i]) +
             " is not contained: it is " + shortNumber(excess) + " m too far out";
  }
  return std::nullopt;
}

std::optional<std::string>
findTooFar(const HullPrimitive& primitive, const Verification& verification)
{
  if (!verification.error)
    return std::nullopt;
  TriangleMesh mesh = meshAround(primitive);
  for (Eigen::Vector3d& v : mesh.vertices)
    v = verification.frame.toLocal(v);
  return verification.error->findTooFar(mesh);
}

NamedPrimitives
readPrimitives(const SceneFile& file, OutputFiles& outputs)
{
  std::ifstream stream(outputs.pathBeforeCommit(file.path), std::ios::binary);
  return file.format.read_primitives(stream);
}

/** Those that must be there, by the number of their part. */
std::map<std::size_t, HullPrimitive>
byPart(const NamedPrimitives& primitives,
       const SceneDescription& scene,
       std::size_t parts)
{
  std::map<std::size_t, HullPrimitive> by_part;
  for (std::size_t k = 0; k < parts; ++k) {
    if (!primitiveOf(k, scene))
      continue;
    const auto found = primitives.find(partName(k, scene.name));
    if (found == primitives.end())
      throw CIDException("the primitive of " + partName(k) + " is missing");
    by_part.emplace(k, found->second);
  }
  if (primitives.size() != by_part.size())
    throw CIDException("it has " + std::to_string(primitives.size()) +
                       " primitives; it must have " + std::to_string(by_part.size()));
  return by_part;
}

void
failIf(const std::optional<std::string>& broken,
       const HullPrimitive& primitive,
       std::size_t part)
{
  if (broken)
    throw CIDException("the " + std::string(nameOf(primitive.kind)) + " of " +
                       partName(part) + " breaks a guarantee: " + *broken);
}

void
verify(const std::map<std::size_t, HullPrimitive>& primitives,
       const Verification& verification)
{
  verification.show([&](const PartPoints& points) {
    if (const auto found = primitives.find(points.part); found != primitives.end())
      failIf(findPointOutside(found->second, points, verification),
             found->second,
             points.part);
  });
  for (const auto& [part, primitive] : primitives)
    failIf(findTooFar(primitive, verification), primitive, part);
}

} // namespace

void
verifyPrimitives(const SceneFile& file,
                 const SceneDescription& scene,
                 const Verification& verification,
                 OutputFiles& outputs)
{
  try {
    verify(byPart(readPrimitives(file, outputs),
                  scene,
                  verification.abstracted.parts.size()),
           verification);
  }
  catch (const CIDException& error) {
    throw CIDException(file.path + ": verification: " + error.what());
  }
}

} // namespace pcl_cid::tools
