/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls that cost whoever uses them less: primitives, and hulls of fewer vertices.
 */

#include "simpler_bodies.h"

#include <pcl_cid/core/hull_simplification.h>

#include <algorithm>
#include <string>

namespace pcl_cid::tools {
namespace {

/** "box: 12, sphere: 0, ...", of those kinds. */
std::string
countsOf(const Primitives& primitives, const std::vector<HullPrimitive::Kind>& kinds)
{
  std::string text;
  for (const HullPrimitive::Kind kind : kinds) {
    const auto count =
        std::count_if(primitives.begin(), primitives.end(), [&](const auto& primitive) {
          return primitive && primitive->kind == kind;
        });
    text += (text.empty() ? "" : ", ") + std::string(nameOf(kind)) + ": " +
            std::to_string(count);
  }
  return text;
}

std::size_t
verticesOf(const std::vector<ConvexPart>& parts)
{
  std::size_t vertices = 0;
  for (const ConvexPart& part : parts)
    vertices += part.hull.vertices.size();
  return vertices;
}

} // namespace

Primitives
findPrimitives(const AbstractSettings& settings,
               const Viewpoints& viewpoints,
               const std::vector<ConvexPart>& parts,
               Abstraction& abstraction,
               Run& run)
{
  if (!settings.scenes.primitives)
    return {};
  run.begin("Looking for primitives");
  const PreparedScan::ConstPtr scan = abstraction.prepare();
  const ExecutionOptions execution = {settings.threads, run.console.progress()};
  PrimitiveOptions options;
  options.kinds = settings.scenes.primitiveKinds();
  std::optional<ErrorBound> bound;
  if (settings.max_error) {
    bound.emplace(scan,
                  paddedBound(*settings.max_error, settings.hulls.padding),
                  viewpoints,
                  execution);
    options.may_replace = [&](const TriangleMesh& body) {
      return bound->isKeptBy(body);
    };
  }
  Primitives primitives =
      fitPrimitives(parts, scan->points().frame, options, execution);
  run.report.primitives = primitives;
  run.end(countsOf(primitives, options.kinds), "primitives");
  return primitives;
}

void
simplify(const AbstractSettings& settings,
         std::vector<ConvexPart>& parts,
         Abstraction& abstraction,
         Run& run)
{
  if (!settings.fewest_vertices)
    return;
  run.begin("Simplifying hulls");
  const std::size_t exact = verticesOf(parts);
  abstraction.simplify(parts);
  run.report.exact_vertices = exact;
  run.end(std::to_string(verticesOf(parts)) + " vertices instead of " +
              std::to_string(exact),
          "simplify");
}

void
moveToFile(const Frame& frame, Primitives& primitives)
{
  for (auto& primitive : primitives)
    if (primitive)
      primitive->center = frame.toFile(primitive->center);
}

} // namespace pcl_cid::tools
