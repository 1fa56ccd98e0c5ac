/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The file formats of meshes whose surface is sampled, and what their readers share.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/exceptions.h>

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_cid {

/** \brief A file format: one row of the table. */
struct SurfaceFormat {
  /** What users call it: "OBJ". */
  std::string name;
  /** How names of its files end: in small letters, with the dot. */
  std::vector<std::string> extensions;
  /** Whether such a file may be a cloud, too, and is one unless it is said. */
  bool is_cloud_too = false;
  /** Read a file.
   *  \param[in] size of the file in bytes, at least 1
   *  \param[in] name of the file, for messages */
  std::function<TriangleMesh(
      std::istream& stream, std::uint64_t size, const std::string& name)>
      read;
};

SurfaceFormat
objSurface();

SurfaceFormat
offSurface();

SurfaceFormat
plySurface();

SurfaceFormat
stlSurface();

/** \brief Cut three coordinates off a line of text.
 *  \return none when there are no three numbers */
std::optional<Eigen::Vector3d>
takeCoordinates(std::string_view& line);

/** \brief Add a face as triangles about its first corner.
 *  \param[in] corners indices of vertices, checked by the caller */
void
addFace(const std::vector<std::uint64_t>& corners, TriangleMesh& mesh);

} // namespace pcl_cid
