/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Samples spread evenly over a hull's surface, through its volume, and in a box.
 */

#include "hull_samples.h"

#include "hull_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_cid {
namespace {

/** The n-th of a sequence in 0 ... 1 of steps \a step. */
double
recurrence(std::size_t n, double step)
{
  const double whole = 0.5 + static_cast<double>(n) * step;
  return whole - std::floor(whole);
}

/** The share that a sample has of each corner of a simplex, evenly from a cube: the
 *  gaps between its sorted coordinates. */
template <std::size_t Size>
std::array<double, Size + 1>
cornerShares(std::array<double, Size> coordinates)
{
  std::sort(coordinates.begin(), coordinates.end());
  std::array<double, Size + 1> shares{};
  double last = 0.0;
  for (std::size_t k = 0; k < Size; ++k) {
    shares[k] = coordinates[k] - last;
    last = coordinates[k];
  }
  shares[Size] = 1.0 - last;
  return shares;
}

/** Distribute samples over items by weight: \a place(item, n) for n = 0, 1, ... */
template <typename Place>
void
dealOut(const std::vector<double>& weights, std::size_t count, const Place& place)
{
  double total = 0.0;
  for (const double weight : weights)
    total += weight;
  double reached = 0.0;
  std::size_t n = 0;
  for (std::size_t item = 0; item < weights.size(); ++item) {
    reached += weights[item];
    const bool is_last = item + 1 == weights.size();
    while (n < count && (is_last || (static_cast<double>(n) + 0.5) * total <
                                        reached * static_cast<double>(count)))
      place(item, n++);
  }
}

} // namespace

Eigen::Vector3d
evenInCube(std::size_t n)
{
  constexpr double ratio = 1.22074408460575947536; // x^4 = x + 1
  return {recurrence(n, 1.0 / ratio),
          recurrence(n, 1.0 / (ratio * ratio)),
          recurrence(n, 1.0 / (ratio * ratio * ratio))};
}

std::vector<Eigen::Vector3d>
surfaceSamples(const TriangleMesh& mesh, std::size_t count)
{
  constexpr double ratio = 1.32471795724474602596; // x^3 = x + 1
  std::vector<double> areas;
  for (const Triangle& triangle : mesh.triangles)
    areas.push_back(doubleAreaNormal(mesh, triangle).norm());
  std::vector<Eigen::Vector3d> samples;
  samples.reserve(count);
  dealOut(areas, count, [&](std::size_t item, std::size_t n) {
    const auto& [a, b, c] = mesh.triangles[item];
    const auto shares = cornerShares<2>(
        {recurrence(n, 1.0 / ratio), recurrence(n, 1.0 / (ratio * ratio))});
    samples.emplace_back(shares[0] * mesh.vertices[a] + shares[1] * mesh.vertices[b] +
                         shares[2] * mesh.vertices[c]);
  });
  return samples;
}

std::vector<Eigen::Vector3d>
volumeSamples(const TriangleMesh& mesh, std::size_t count)
{
  const Eigen::Vector3d apex = centroidOf(mesh);
  std::vector<double> volumes;
  for (const Triangle& triangle : mesh.triangles)
    volumes.push_back(
        doubleAreaNormal(mesh, triangle).dot(mesh.vertices[triangle[0]] - apex));
  std::vector<Eigen::Vector3d> samples;
  samples.reserve(count);
  dealOut(volumes, count, [&](std::size_t item, std::size_t n) {
    const auto& [a, b, c] = mesh.triangles[item];
    const Eigen::Vector3d even = evenInCube(n);
    const auto shares = cornerShares<3>({even.x(), even.y(), even.z()});
    samples.emplace_back(shares[0] * mesh.vertices[a] + shares[1] * mesh.vertices[b] +
                         shares[2] * mesh.vertices[c] + shares[3] * apex);
  });
  return samples;
}

} // namespace pcl_cid
