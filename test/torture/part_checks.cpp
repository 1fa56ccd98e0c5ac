/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What must hold of parts and their hulls, whichever rule chose them.
 */

#include "part_checks.h"

#include "torture_fault.h"

#include <pcl_cid/core/hull_guarantees.h>

#include <algorithm>
#include <set>

namespace pcl_cid::test {

bool
sameParts(const std::vector<ConvexPart>& a, const std::vector<ConvexPart>& b)
{
  return std::equal(a.begin(),
                    a.end(),
                    b.begin(),
                    b.end(),
                    [](const ConvexPart& left, const ConvexPart& right) {
                      return left.indices == right.indices &&
                             left.trimmed == right.trimmed &&
                             left.hull.vertices == right.hull.vertices &&
                             left.hull.triangles == right.hull.triangles &&
                             left.volume == right.volume &&
                             left.thickness == right.thickness;
                    });
}

void
checkParts(const TortureCloud& cloud,
           const std::vector<ConvexPart>& parts,
           const ConvexPartOptions& hull,
           std::size_t parted,
           std::size_t dropped)
{
  std::set<pcl::index_t> covered;
  for (const ConvexPart& part : parts) {
    expect(!part.indices.empty(), "a part without points");
    std::vector<Eigen::Vector3d> points;
    for (const pcl::index_t i : part.indices)
      points.push_back(
          cloud[static_cast<std::size_t>(i)].getVector3fMap().cast<double>());
    if (const auto broken = findBrokenGuarantee(part.hull, points, hull))
      throw Fault("a hull: " + *broken);
    for (const pcl::Indices* indices : {&part.indices, &part.trimmed})
      for (const pcl::index_t i : *indices)
        expect(covered.insert(i).second, "a point in two parts");
  }
  expect(covered.size() + dropped == parted, "a point in no part");
}

} // namespace pcl_cid::test
