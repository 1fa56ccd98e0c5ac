/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds from meshes: which file is read how.
 */

#include "base/sentence.h"
#include "columns/point_columns.h"
#include "surface_formats.h"
#include "text/format_table.h"
#include "text/numbers.h"
#include "text/opened_file.h"
#include "text/words.h"

#include <pcl_cid/io/mesh_surface.h>

#include <utility>

namespace pcl_cid {
namespace {

/** A new format is one more row here. */
const FormatTable<SurfaceFormat>&
surfaceTable()
{
  static const FormatTable<SurfaceFormat> table{
      objSurface(), stlSurface(), offSurface(), plySurface()};
  return table;
}

const SurfaceFormat*
surfaceFormatOf(const std::string& path)
{
  return surfaceTable().forFile(withoutGzip(path));
}

void
requireFinite(const TriangleMesh& mesh, const std::string& path)
{
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (!mesh.vertices[i].allFinite())
      throw CIDException(
          sentence(path, ": vertex ", i, " is not finite, so it has no surface"));
}

} // namespace

std::optional<Eigen::Vector3d>
takeCoordinates(std::string_view& line)
{
  Eigen::Vector3d point;
  for (double& coordinate : point) {
    const auto number = parseLoosely<double>(takeWord(line));
    if (!number)
      return std::nullopt;
    coordinate = *number;
  }
  return point;
}

void
addFace(const std::vector<std::uint64_t>& corners, TriangleMesh& mesh)
{
  for (std::size_t k = 2; k < corners.size(); ++k)
    mesh.triangles.push_back({static_cast<std::uint32_t>(corners[0]),
                              static_cast<std::uint32_t>(corners[k - 1]),
                              static_cast<std::uint32_t>(corners[k])});
}

TriangleMesh
readSurface(const std::string& path, const std::string& extension)
{
  const std::string needed = "a mesh is needed: " + listed(surfaceNames());
  const SurfaceFormat* const format =
      surfaceFormatOf(extension.empty() ? path : "file" + extension);
  if (!format)
    throw CIDException(path + ": is no mesh by its name; " + needed);
  const OpenedFile file = openFile(path, needed);
  TriangleMesh mesh = format->read(*file.stream, file.size, path);
  if (mesh.triangles.empty())
    throw CIDException(path + ": holds no faces, so there is no surface to sample");
  requireFinite(mesh, path);
  return mesh;
}

bool
isSurfaceFile(const std::string& path)
{
  const SurfaceFormat* const format = surfaceFormatOf(path);
  return format && !format->is_cloud_too;
}

std::vector<std::string>
surfaceNames()
{
  std::vector<std::string> names;
  for (const SurfaceFormat& format : surfaceTable().all())
    names.push_back(format.name);
  return names;
}

std::vector<std::string>
surfaceExtensions()
{
  std::vector<std::string> extensions;
  for (const SurfaceFormat& format : surfaceTable().all())
    extensions.insert(
        extensions.end(), format.extensions.begin(), format.extensions.end());
  return extensions;
}

LabelledCloud
readSurfaceAsCloud(const std::string& path,
                   double spacing,
                   const std::string& extension)
{
  const TriangleMesh mesh = readSurface(path, extension);
  LabelledCloud cloud;
  cloud.name = path;
  try {
    const double used = spacing > 0.0 ? spacing : usualSpacing(mesh);
    PointColumns columns;
    columns.names = {"x", "y", "z"};
    columns.values.resize(3);
    for (const Eigen::Vector3d& point : sampleSurface(mesh, used))
      for (int axis = 0; axis < 3; ++axis)
        columns.values[static_cast<std::size_t>(axis)].push_back(point[axis]);
    columns.width = static_cast<std::uint32_t>(columns.values[0].size());
    setFields(std::move(columns), cloud);
    cloud.remarks.push_back(sentence("its surface, ",
                                     countOf(mesh.triangles.size(), "triangle"),
                                     ", is sampled with a spacing of ",
                                     used,
                                     " of its units"));
  }
  catch (const CIDException& error) {
    throw CIDException(path + ": " + error.what());
  }
  return cloud;
}

} // namespace pcl_cid
