/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls with as few vertices as the error allows.
 */

#include "base/parallel_for.h"
#include "hull/hull_distance.h"
#include "hull/hull_mesh.h"
#include "hull/hull_reduction.h"
#include "hull/hull_width.h"

#include <pcl_cid/core/hull_simplification.h>

#include <utility>

namespace pcl_cid {
namespace {

/** Work is done about the local origin, where double has digits to spare. */
void
simplify(ConvexPart& part, const Eigen::Vector3d& origin, const ErrorBound* bound)
{
  const TriangleMesh exact = moved(part.hull, -origin);
  const double most =
      bound ? bound->maxError() : simplification_share * diagonalOf(exact);
  TriangleMesh simpler = simplifyOutward(exact, [&](const TriangleMesh& body) {
    return staysNear(exact, body, most) &&
           (!bound || bound->isKeptBy(moved(body, origin)));
  });
  if (simpler.vertices.size() == exact.vertices.size())
    return;
  part.volume = volumeOf(simpler);
  part.area = areaOf(simpler);
  part.thickness = leastWidth(simpler).width;
  part.hull = moved(std::move(simpler), origin);
}

} // namespace

void
simplifyHulls(std::vector<ConvexPart>& parts,
              const Frame& frame,
              const ErrorBound* bound,
              const ExecutionOptions& execution)
{
  Progress progress(execution.progress);
  parallelForEach(parts.size(),
                  threadCount(execution.threads),
                  progress,
                  {0.0, 1.0},
                  [&](std::size_t k) { simplify(parts[k], frame.origin, bound); });
}

} // namespace pcl_cid
