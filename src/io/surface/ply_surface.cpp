/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The triangles of a PLY with faces.
 */

#include "base/sentence.h"
#include "fields/field_values.h"
#include "ply/ply_header.h"
#include "ply/ply_rows.h"
#include "surface_formats.h"

#include <array>
#include <cmath>
#include <istream>

namespace pcl_cid {
namespace {

/** Reads one file; each member function is one element of it. */
class PLYSurfaceReading {
public:
  PLYSurfaceReading(std::istream& stream, std::uint64_t size, const std::string& name)
  : header_(readPLYHeader(stream, name))
  , rows_(stream, size, header_, name)
  , name_(name)
  {
  }

  TriangleMesh
  mesh()
  {
    for (const PLYElement& element : header_.elements)
      if (element.name == "vertex")
        readVertices(element);
      else if (element.name == "face")
        readFaces(element);
      else
        rows_.pass(element);
    rows_.requireEnd();
    return std::move(mesh_);
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(name_, ": ", parts...));
  }

  void
  readVertices(const PLYElement& element)
  {
    std::array<std::size_t, 3> axes{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int found = element.find(std::string(1, "xyz"[axis]));
      if (found < 0)
        fail("its vertices have no ", "xyz"[axis]);
      axes[axis] = static_cast<std::size_t>(found);
    }
    Eigen::Vector3d vertex;
    rows_.read(element, [&](auto, std::size_t i, const std::uint8_t* value, auto) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (axes[axis] == i)
          vertex[static_cast<Eigen::Index>(axis)] =
              toDouble(value, element.properties[i].datatype);
      if (i + 1 == element.properties.size())
        mesh_.vertices.push_back(vertex);
    });
  }

  /** Faces may stand before the vertices. */
  void
  readFaces(const PLYElement& element)
  {
    const std::size_t list = listOfCorners(element);
    const PLYProperty& corners = element.properties[list];
    const std::size_t size = sizeOf(corners.datatype);
    const std::uint64_t vertices = numberOfVertices();
    rows_.read(element,
               [&](std::uint64_t row,
                   std::size_t i,
                   const std::uint8_t* values,
                   std::uint64_t count) {
                 if (i != list)
                   return;
                 corners_.clear();
                 for (std::uint64_t k = 0; k < count; ++k) {
                   const double index = toDouble(values + k * size, corners.datatype);
                   if (!(index >= 0.0) || !(index < static_cast<double>(vertices)) ||
                       std::floor(index) != index)
                     fail("face ",
                          row,
                          " has the corner ",
                          index,
                          ", which is none of the ",
                          vertices,
                          " vertices");
                   corners_.push_back(static_cast<std::uint64_t>(index));
                 }
                 addFace(corners_, mesh_);
               });
  }

  std::size_t
  listOfCorners(const PLYElement& element) const
  {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PLYProperty& property = element.properties[i];
      if (property.length_datatype != 0 &&
          (property.name == "vertex_indices" || property.name == "vertex_index"))
        return i;
    }
    fail("its faces have no list 'vertex_indices' or 'vertex_index'");
  }

  std::uint64_t
  numberOfVertices() const
  {
    for (const PLYElement& element : header_.elements)
      if (element.name == "vertex")
        return element.count;
    return 0;
  }

  const PLYHeader header_;
  PLYRows rows_;
  const std::string& name_;
  std::vector<std::uint64_t> corners_; ///< of a face
  TriangleMesh mesh_;
};

} // namespace

SurfaceFormat
plySurface()
{
  return {"PLY",
          {".ply"},
          true,
          [](std::istream& stream, std::uint64_t size, const std::string& name) {
            return PLYSurfaceReading(stream, size, name).mesh();
          }};
}

} // namespace pcl_cid
