/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The triangles of a Wavefront OBJ.
 */

#include "base/sentence.h"
#include "surface_formats.h"
#include "text/file_reading.h"
#include "text/numbers.h"
#include "text/words.h"

#include <istream>
#include <string_view>

namespace pcl_cid {
namespace {

/** Reads one file, line by line. */
class OBJSurfaceReading {
public:
  OBJSurfaceReading(std::istream& stream, const std::string& name)
  : stream_(stream), name_(name)
  {
  }

  TriangleMesh
  mesh()
  {
    const char line_end = lineEndOf(stream_);
    for (std::string line; std::getline(stream_, line, line_end);) {
      ++line_number_;
      std::string_view rest = line;
      const std::string_view statement = takeWord(rest);
      if (statement == "v")
        addVertex(rest);
      else if (statement == "f")
        addFaceOf(rest);
    }
    return std::move(mesh_);
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(name_, ": line ", line_number_, ": ", parts...));
  }

  /** Weights and colors may follow. */
  void
  addVertex(std::string_view rest)
  {
    const auto vertex = takeCoordinates(rest);
    if (!vertex)
      fail("has no three coordinates");
    mesh_.vertices.push_back(*vertex);
  }

  /** Corners are "vertex/texture/normal", or less of it. */
  void
  addFaceOf(std::string_view rest)
  {
    corners_.clear();
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
      corners_.push_back(vertexOf(word.substr(0, word.find('/'))));
    if (corners_.size() < 3)
      fail("is a face with fewer than 3 corners");
    addFace(corners_, mesh_);
  }

  /** Numbers count from 1, or back from the last vertex so far. */
  std::uint64_t
  vertexOf(std::string_view word) const
  {
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const auto number = parseNumber<std::int64_t>(word);
    const std::int64_t index = !number       ? -1
                               : *number < 0 ? count + *number
                                             : *number - 1;
    if (index < 0 || index >= count)
      fail("'", word.substr(0, 32), "' is none of the ", count, " vertices before it");
    return static_cast<std::uint64_t>(index);
  }

  std::istream& stream_;
  const std::string& name_;
  std::size_t line_number_ = 0;
  std::vector<std::uint64_t> corners_;
  TriangleMesh mesh_;
};

} // namespace

SurfaceFormat
objSurface()
{
  return {"OBJ",
          {".obj"},
          false,
          [](std::istream& stream, std::uint64_t, const auto& name) {
            return OBJSurfaceReading(stream, name).mesh();
          }};
}

} // namespace pcl_cid
