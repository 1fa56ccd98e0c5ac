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
#include <optional>
#include <string>
#include <utility>

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

/** The bound on the error where there is one. */
std::optional<ErrorBound>
errorBound(const AbstractSettings& settings,
           const Viewpoints& viewpoints,
           const PreparedScan::ConstPtr& scan,
           const ExecutionOptions& execution)
{
  if (!settings.max_error)
    return std::nullopt;
  return std::optional<ErrorBound>(
      std::in_place,
      scan,
      paddedBound(*settings.max_error, settings.hulls.padding),
      viewpoints,
      execution);
}

/** Parts whose hulls may be made simpler, taken out. */
std::vector<ConvexPart>
takeInexact(AbstractedScan& abstracted)
{
  std::vector<ConvexPart> taken;
  for (std::size_t k = 0; k < abstracted.parts.size(); ++k)
    if (!abstracted.isExact(k))
      taken.push_back(std::move(abstracted.parts[k]));
  return taken;
}

void
putBack(std::vector<ConvexPart> taken, AbstractedScan& abstracted)
{
  auto next = taken.begin();
  for (std::size_t k = 0; k < abstracted.parts.size(); ++k)
    if (!abstracted.isExact(k))
      abstracted.parts[k] = std::move(*next++);
}

} // namespace

void
findPrimitives(const AbstractSettings& settings,
               const Viewpoints& viewpoints,
               const PreparedScan::ConstPtr& scan,
               Run& run,
               AbstractedScan& abstracted)
{
  if (!settings.scenes.primitives)
    return;
  run.begin("Looking for primitives");
  const ExecutionOptions execution = {settings.threads, run.console.progress()};
  PrimitiveOptions options;
  options.kinds = settings.scenes.primitiveKinds();
  const auto bound = errorBound(settings, viewpoints, scan, execution);
  if (bound)
    options.may_replace = [&](const TriangleMesh& body) {
      return bound->isKeptBy(body);
    };
  abstracted.primitives =
      fitPrimitives(abstracted.parts, scan->points().frame, options, execution);
  run.report.primitives = abstracted.primitives;
  run.end(countsOf(abstracted.primitives, options.kinds), "primitives");
}

void
simplify(const AbstractSettings& settings,
         const Viewpoints& viewpoints,
         const PreparedScan::ConstPtr& scan,
         Run& run,
         AbstractedScan& abstracted)
{
  if (!settings.fewest_vertices)
    return;
  run.begin("Simplifying hulls");
  const std::size_t exact = verticesOf(abstracted.parts);
  const ExecutionOptions execution = {settings.threads, run.console.progress()};
  const auto bound =
      errorBound(settings, viewpoints, scan, partOf(execution, 0.0, 0.3));
  std::vector<ConvexPart> parts = takeInexact(abstracted);
  simplifyHulls(parts,
                scan->points().frame,
                bound ? &*bound : nullptr,
                partOf(execution, 0.3, 1.0));
  putBack(std::move(parts), abstracted);
  run.report.exact_vertices = exact;
  run.end(std::to_string(verticesOf(abstracted.parts)) + " vertices instead of " +
              std::to_string(exact),
          "simplify");
}

void
moveToFile(const Frame& frame, AbstractedScan& abstracted)
{
  pcl_cid::moveToFile(frame, abstracted.parts);
  for (auto& primitive : abstracted.primitives)
    if (primitive)
      primitive->center = frame.toFile(primitive->center);
}

} // namespace pcl_cid::tools
