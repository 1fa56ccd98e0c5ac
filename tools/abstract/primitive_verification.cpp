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
             const ConvexPart& part,
             const Verification& verification)
{
  const double size =
      primitive.center.cwiseAbs().maxCoeff() + primitive.extents.maxCoeff();
  return 16.0 * std::numeric_limits<double>::epsilon() * size +
         std::min(
             roundingOf(part.indices, verification.points, verification.coordinates),
             unnoticed_rounding);
}

std::optional<std::string>
findPointOutside(const HullPrimitive& primitive,
                 const ConvexPart& part,
                 const Verification& verification)
{
  const double allowance = allowanceFor(primitive, part, verification);
  for (const pcl::index_t index : part.indices) {
    const auto i = static_cast<std::size_t>(index);
    const double excess = excessOf(primitive, verification.coordinates[i]) +
                          verification.abstracted.hull_options.padding;
    if (!(excess <= allowance))
      return "point " + std::to_string(i) + " is not contained: it is " +
             shortNumber(excess) + " m too far out";
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
    v = verification.points.frame.toLocal(v);
  return verification.error->findTooFar(mesh);
}

NamedPrimitives
readPrimitives(const SceneFile& file, OutputFiles& outputs)
{
  std::ifstream stream(outputs.pathBeforeCommit(file.path), std::ios::binary);
  return file.format.read_primitives(stream);
}

void
verify(const NamedPrimitives& primitives,
       const SceneDescription& scene,
       const Verification& verification)
{
  std::size_t expected = 0;
  for (std::size_t k = 0; k < verification.abstracted.parts.size(); ++k) {
    if (!primitiveOf(k, scene))
      continue;
    ++expected;
    const auto found = primitives.find(partName(k, scene.name));
    if (found == primitives.end())
      throw CIDException("the primitive of " + partName(k) + " is missing");
    auto broken =
        findPointOutside(found->second, verification.abstracted.parts[k], verification);
    if (!broken)
      broken = findTooFar(found->second, verification);
    if (broken)
      throw CIDException("the " + std::string(nameOf(found->second.kind)) + " of " +
                         partName(k) + " breaks a guarantee: " + *broken);
  }
  if (primitives.size() != expected)
    throw CIDException("it has " + std::to_string(primitives.size()) +
                       " primitives; it must have " + std::to_string(expected));
}

} // namespace

void
verifyPrimitives(const SceneFile& file,
                 const SceneDescription& scene,
                 const Verification& verification,
                 OutputFiles& outputs)
{
  try {
    verify(readPrimitives(file, outputs), scene, verification);
  }
  catch (const CIDException& error) {
    throw CIDException(file.path + ": verification: " + error.what());
  }
}

} // namespace pcl_cid::tools
