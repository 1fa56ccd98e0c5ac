/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * All hulls in one mesh file, in the format that its extension says.
 */

#include "mesh_output.h"

#include "run/words.h"

#include <pcl_cid/core/hull_guarantees.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>

#include <algorithm>
#include <ostream>

namespace pcl_cid::tools {
namespace {

std::vector<std::string>
extensionsOfDouble()
{
  std::vector<std::string> extensions;
  for (const MeshFormat& format : meshFormats())
    if (!format.is_float)
      extensions.insert(
          extensions.end(), format.extensions.begin(), format.extensions.end());
  return extensions;
}

constexpr double share_for_rounding = 0.25; // of a thickness

[[noreturn]] void
failForFloat(const std::string& path, const MeshFormat& format, const std::string& hull)
{
  throw CIDException(path + ": " + format.name +
                     " rounds coordinates to float, in which " + hull +
                     " would lose its shape so far from the origin; choose " +
                     alternatives(extensionsOfDouble()) +
                     ", or --parts-dir with --parts-format stl beside them");
}

/** STL holds float and has no pose: far from the origin, thin hulls fall flat in it.
 *  \param[in] parts with hulls in the unit of the file */
void
requireThickInFloat(const std::string& path,
                    const MeshFormat& format,
                    double metres_per_unit,
                    const std::vector<ConvexPart>& parts)
{
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (metres_per_unit * floatRounding(parts[i].hull) >
        share_for_rounding * parts[i].thickness)
      failForFloat(path, format, "the hull of " + partName(i));
}

/** The median of the largest coordinates of the points. */
double
typicalSize(const LoadedScan& scan)
{
  std::vector<double> sizes;
  for (const pcl::PointXYZ& point : *scan.points.points)
    if (point.getVector3fMap().allFinite())
      sizes.push_back(scan.points.frame.toFile(point.getVector3fMap().cast<double>())
                          .cwiseAbs()
                          .maxCoeff());
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

} // namespace

void
requireRoomForFloat(const std::string& path,
                    const LoadedScan& scan,
                    double min_thickness)
{
  const MeshFormat& format = meshFormatOf(path);
  const bool is_finer =
      FileCoordinates(scan.cloud).datatype() != pcl::PCLPointField::FLOAT32;
  const double unit = scan.points.metres_per_unit;
  if (format.is_float && is_finer &&
      unit * floatRounding(typicalSize(scan) / unit) >
          share_for_rounding * min_thickness)
    failForFloat(path, format, "a hull " + shortNumber(min_thickness) + " m thick");
}

void
saveMesh(const std::string& path,
         std::vector<ConvexPart> parts,
         double metres_per_unit,
         const std::string& name,
         OutputFiles& outputs)
{
  const MeshFormat& format = meshFormatOf(path);
  for (ConvexPart& part : parts)
    for (Eigen::Vector3d& v : part.hull.vertices)
      v /= metres_per_unit;
  if (format.is_float)
    requireThickInFloat(path, format, metres_per_unit, parts);
  outputs.write(path,
                [&](std::ostream& stream) { writeMesh(stream, parts, path, name); });
  if (const std::string materials = materialsBeside(path); !materials.empty())
    outputs.write(materials, [&](std::ostream& stream) {
      writeMaterials(stream, parts, path, name);
    });
}

} // namespace pcl_cid::tools
